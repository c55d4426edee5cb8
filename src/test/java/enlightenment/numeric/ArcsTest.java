package enlightenment.numeric;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.math.BigDecimal;
import java.math.MathContext;
import org.junit.jupiter.api.Test;

class ArcsTest {
    private static final MathContext DIGITS = new MathContext(40);

    /** θ/sin θ by Gauss's series in t = 1 − cos θ: 1 + t/3 (1 + 2t/5 (1 + 3t/7 (1 + …))). */
    private static BigDecimal exact(double cosine) {
        BigDecimal t = BigDecimal.ONE.subtract(new BigDecimal(cosine));
        BigDecimal sum = BigDecimal.ONE;
        BigDecimal term = BigDecimal.ONE;
        for (int k = 0; term.compareTo(new BigDecimal("1e-30")) > 0; k++) {
            term = term.multiply(t).multiply(BigDecimal.valueOf(k + 1)).divide(BigDecimal.valueOf(2L * k + 3), DIGITS);
            sum = sum.add(term, DIGITS);
        }
        return sum;
    }

    private static void assertOverSine(double cosine) {
        double exact = exact(cosine).doubleValue();
        double found = Arcs.overSine(cosine);
        assertEquals(
                0,
                new BigDecimal(found).subtract(exact(cosine)).doubleValue(),
                (cosine < 0.5 ? 3 : 2) * Math.ulp(exact),
                () -> "cos θ = " + cosine);
    }

    @Test
    void anArcOverItsSineIsThatOfTheSeriesToAFewUnitsInTheLastPlace() {
        for (int i = 0; i <= 3000; i++) {
            assertOverSine(Arcs.LEAST_COSINE + (1 - Arcs.LEAST_COSINE) * i / 3000);
        }
        for (double t = 0.5; t > 1e-16; t *= 0.7) {
            assertOverSine(1 - t);
        }
    }

    @Test
    void anArcOverItsSineIsOneWhereThereIsNoArcAndARoundingBeyond() {
        assertEquals(1, Arcs.overSine(1));
        assertEquals(1, Arcs.overSine(1 + 4 * Scale.UNIT_ROUNDOFF), 2 * Scale.UNIT_ROUNDOFF);
        assertEquals(2 * Math.PI / 3 / Math.sqrt(0.75), Arcs.overSine(-0.5), 4 * Scale.UNIT_ROUNDOFF * 2);
        assertEquals(Math.PI / 2, Arcs.overSine(0), 4 * Scale.UNIT_ROUNDOFF);
    }

    @Test
    void upToAnEighthOfATurnNoReductionIsNeeded() {
        for (int i = -1000; i <= 1000; i++) {
            double x = Math.PI / 4 * i / 1000;
            assertEquals(StrictMath.sin(x), Arcs.sineNearZero(x), 2 * Math.ulp(x));
            assertEquals(StrictMath.cos(x), Arcs.cosineNearZero(x), 2 * Math.ulp(1.0));
        }
    }

    @Test
    void sinesAndCosinesAgreeWithTheExactOnesAllTheWayRound() {
        double worst = 0;
        for (int i = -40_000; i <= 40_000; i++) {
            double x = 2 * Math.PI * i / 40_000;
            worst = Math.max(worst, Math.abs(Arcs.sine(x) - StrictMath.sin(x)));
            worst = Math.max(worst, Math.abs(Arcs.cosine(x) - StrictMath.cos(x)));
        }
        // StrictMath's own error is below 1 unit in the last place, which is 1.1e-16 below 1.
        assertTrue(worst <= 2.3e-16, "worst " + worst);
    }

    @Test
    void sinesOfSmallAnglesKeepAllTheirDigits() {
        for (double x = 1; x > 1e-300; x *= 0.3) {
            assertEquals(StrictMath.sin(x), Arcs.sine(x), 2 * Math.ulp(x));
            assertEquals(-StrictMath.sin(x), Arcs.sine(-x), 2 * Math.ulp(x));
        }
        assertEquals(0, Arcs.sine(0));
        assertEquals(1, Arcs.cosine(0));
    }
}
