package enlightenment.frame;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.math.BigDecimal;
import java.math.MathContext;
import java.util.List;
import java.util.Map;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;

/** How much of the sky a ball covers, from the touch of its surface to 1e100 radii away (numerics, N30). */
class BallConeTest {
    private static final double ALLOWED = 2e-15;
    private static final MathContext DIGITS = new MathContext(260);
    private static final BigDecimal PI = new BigDecimal("3.14159265358979323846264338327950288419716939937510");

    /** The ball of radius r at the distance d, straight ahead along a coordinate axis. */
    private static BallCone cone(double d, double r, int axis) {
        BallCone cone = new BallCone();
        cone.set(axis == 0 ? d : 0, axis == 1 ? -d : 0, axis == 2 ? d : 0, r, 0, 0, 0);
        return cone;
    }

    private static double relativeError(double v, BigDecimal exact) {
        return new BigDecimal(v).subtract(exact).divide(exact, DIGITS).abs().doubleValue();
    }

    private static BigDecimal density(BigDecimal oneMinusCosine) {
        return BigDecimal.ONE.divide(PI.multiply(BigDecimal.valueOf(2)).multiply(oneMinusCosine), DIGITS);
    }

    private static void check(double d, double r, int axis, BigDecimal oneMinusCosine, BigDecimal density) {
        BallCone cone = cone(d, r, axis);
        assertFalse(cone.inside);
        String what = "distance " + d + ", radius " + r;
        double error = relativeError(cone.oneMinusCosine(), oneMinusCosine);
        assertTrue(error <= ALLOWED, what + ": 1 - cos is off by " + error);
        double pdf = 1 / (2 * Math.PI * cone.oneMinusCosine());
        double pdfError = relativeError(pdf, density);
        assertTrue(pdfError <= ALLOWED, what + ": the density is off by " + pdfError);
    }

    @Test
    void theConeAndItsDensityAreThoseOfTheVectors() {
        List<Map<String, String>> lines = LightVectors.of("sphereLight");
        assertEquals(15, lines.size());
        for (Map<String, String> line : lines) {
            for (int axis = 0; axis < 3; axis++) {
                check(
                        Double.parseDouble(line.get("distance")),
                        Double.parseDouble(line.get("radius")),
                        axis,
                        new BigDecimal(line.get("oneMinusCosThetaMax")),
                        new BigDecimal(line.get("pdf")));
            }
        }
    }

    @Test
    void theConeIsThatOfDecimalArithmeticAtEveryDistance() {
        SplittableRandom random = new SplittableRandom(30);
        for (int i = 0; i < 3000; i++) {
            double r = 1 + random.nextDouble();
            double exponent = -15 + 115 * random.nextDouble();
            double beyond = StrictMath.pow(10, i % 2 == 0 ? exponent : -15 * random.nextDouble());
            double d = Math.max(r * (1 + beyond), Math.nextUp(r));
            BigDecimal sine = new BigDecimal(r).divide(new BigDecimal(d), DIGITS);
            BigDecimal cosine = BigDecimal.ONE.subtract(sine.multiply(sine)).sqrt(DIGITS);
            BigDecimal exact = BigDecimal.ONE.subtract(cosine);
            check(d, r, i % 3, exact, density(exact));
        }
    }

    @Test
    void sineAndCosineOfTheConeAgree() {
        for (double d : new double[] {Math.nextUp(1.0), 1.5, 1e3, 1e8, 1e100}) {
            BallCone cone = cone(d, 1, 0);
            assertEquals(1 / d, cone.sine, 2 * Math.ulp(1 / d));
            assertEquals(1, cone.sine * cone.sine + cone.cosine * cone.cosine, 4 * Math.ulp(1.0));
        }
    }

    @Test
    void onAndInTheBallThereIsNoCone() {
        for (double d : new double[] {0, 0.5, Math.nextDown(1.0), 1}) {
            assertTrue(cone(d, 1, 2).inside, "distance " + d);
        }
    }
}
