package enlightenment.math;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;

import java.math.BigDecimal;
import java.util.Random;
import org.junit.jupiter.api.Test;

/** Points keep every decimal, whatever form it takes inside, and their differences are rounded once. */
class ExactPointArithmeticTest {
    /** Of 1 to 25 digits, with and without point, exponent, sign and zeros at either end. */
    private static String text(Random random) {
        StringBuilder digits = new StringBuilder();
        int n = random.nextInt(5) == 0 ? 1 + random.nextInt(25) : 1 + random.nextInt(8);
        for (int i = 0; i < n; i++) {
            digits.append(random.nextInt(3) == 0 ? 0 : random.nextInt(10));
        }
        if (random.nextInt(4) > 0) {
            digits.insert(1 + random.nextInt(n), ".");
        }
        if (digits.charAt(digits.length() - 1) == '.') {
            digits.append(0);
        }
        String sign = random.nextBoolean() ? "-" : "";
        return sign + digits + (random.nextInt(6) == 0 ? "e" + (random.nextInt(60) - 30) : "");
    }

    private static void assertSame(BigDecimal expected, BigDecimal found) {
        assertEquals(0, expected.compareTo(found), () -> found + " is not " + expected);
    }

    @Test
    void coordinatesAreTheNumbersThatWereWritten() {
        Random random = new Random(1);
        for (int i = 0; i < 20_000; i++) {
            String[] t = {text(random), text(random), text(random)};
            ExactPoint p = ExactPoint.of(t[0], t[1], t[2]);
            ExactPoint q = new ExactPoint(new BigDecimal(t[0]), new BigDecimal(t[1]), new BigDecimal(t[2]));
            assertEquals(p, q);
            assertEquals(p.hashCode(), q.hashCode());
            assertEquals(p.toString(), q.toString());
            for (int k = 0; k < 3; k++) {
                assertSame(new BigDecimal(t[k]), p.component(k));
            }
            assertSame(new BigDecimal(t[0]), p.x());
            assertSame(new BigDecimal(t[1]), p.y());
            assertSame(new BigDecimal(t[2]), p.z());
            // The same number with more digits around it, or a different one in its last digit.
            assertEquals(p, ExactPoint.of(new BigDecimal(t[0]).setScale(60).toString(), t[1], t[2]));
            assertNotEquals(
                    p,
                    ExactPoint.of(
                            new BigDecimal(t[0]).add(new BigDecimal("1e-60")).toString(), t[1], t[2]));
        }
    }

    @Test
    void differencesAreRoundedOnce() {
        Random random = new Random(2);
        for (int i = 0; i < 20_000; i++) {
            ExactPoint p = ExactPoint.of(text(random), text(random), text(random));
            ExactPoint q = ExactPoint.of(text(random), random.nextInt(9) == 0 ? p.y().toString() : "0", text(random));
            Vec3 d = p.minus(q);
            for (int k = 0; k < 3; k++) {
                double expected = Double.parseDouble(
                        p.component(k).subtract(q.component(k)).toString());
                assertEquals(expected, d.component(k), () -> p + " minus " + q);
            }
        }
    }
}
