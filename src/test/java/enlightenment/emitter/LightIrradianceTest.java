package enlightenment.emitter;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.math.Vec3;
import enlightenment.sampling.Hash;
import enlightenment.sampling.Quadrature;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** The closed forms of irradiance against quadratures that do not cancel, and against known factors. */
class LightIrradianceTest {
    private final LightSample sample = new LightSample();

    private double irradiance(AreaLight light, Vec3 p, Vec3 n) {
        light.aim(sample, p.x(), p.y(), p.z());
        return light.irradiance(sample, n.x(), n.y(), n.z());
    }

    @ParameterizedTest
    @CsvSource({
        "2, 0.2, 0.186440", "2, 0, 0.090586", "2, -0.3, 0.011672",
        "1.1, 0.5, 1.512387", "5, 0.1, 0.013606", "5, -0.15, 0.000192"
    })
    void aBallCutByTheHorizonGivesWhatQuadratureGives(double h, double cosine, double expected) {
        SphereLight light = new SphereLight(new Vec3(0, 0, h), 1);
        Vec3 n = new Vec3(Math.sqrt(1 - cosine * cosine), 0, cosine);
        assertEquals(expected, irradiance(light, Vec3.ZERO, n), 6e-7);
    }

    /** sin φ − φ cos φ; for small angles by its series. */
    private static double cap(double sine, double cosine) {
        double angle = Math.atan2(sine, cosine);
        if (angle > 0.5) {
            return sine - angle * cosine;
        }
        double sum = 0;
        double term = angle;
        for (int k = 1; k < 20; k++) {
            term *= -angle * angle / (2 * k * (2 * k + 1));
            sum -= 2 * k * term;
        }
        return sum;
    }

    /** Rings round the axis, t the sine of their angle: no term is negative. */
    private static double byRings(double s, double k) {
        double sigma = Math.sqrt((1 - k) * (1 + k));
        double least = Math.abs(k);
        double cut = Quadrature.integral(
                x -> {
                    // Substituted at both ends, where roots vanish.
                    double share = x * x * (3 - 2 * x);
                    double t = least + (s - least) * share;
                    double sine = Math.sqrt((s - least) * share * (t + least)) / (sigma * t);
                    double root = Math.sqrt((1 - s) + (s - least) * (1 - x) * (1 - x) * (1 + 2 * x));
                    double c = root * Math.sqrt(1 + t);
                    double cosine = -k * c / (sigma * t);
                    return t * t / c * cap(sine, cosine) * (s - least) * 6 * x * (1 - x);
                },
                0,
                1,
                60);
        return (k > 0 ? Math.PI * k * k * k : 0) + 2 * sigma * cut;
    }

    @ParameterizedTest
    @ValueSource(doubles = {0.99, 0.5, 0.1, 1e-3, 1e-8, 1e-12})
    void aBallKeepsItsDigitsFarAwayAndAtTheHorizon(double s) {
        double c = Math.sqrt((1 - s) * (1 + s));
        for (double part : new double[] {
            -1 + 1e-9, -0.9999, -0.99, -0.9, -0.867, -0.865, -0.5, -0.1, 0, 1e-5, 0.1, 0.5, 0.9, 0.9999, 1 - 1e-9
        }) {
            double k = part * s;
            double expected = byRings(s, k);
            assertTrue(expected > 0);
            assertEquals(expected, SphereIrradiance.cut(s, c, k), 2e-13 * expected, s + " " + part);
        }
    }

    @Test
    void aBallThatNearlyTouchesTheReceiverIsAHalfSpace() {
        double s = 1 - 1e-14;
        double c = Math.sqrt((1 - s) * (1 + s));
        for (double k = -0.99; k < 1; k += 0.01) {
            double half = 0.5 * Math.PI * (1 + k);
            assertEquals(half, SphereIrradiance.cut(s, c, k), 10 * c, "cosine " + k);
        }
    }

    @Test
    void aWholeBallGivesPiTimesTheCosineOverTheSquareOfItsDistance() {
        for (double distance = 1.01; distance < 1e12; distance *= 7) {
            SphereLight light = new SphereLight(new Vec3(0, 0, distance), 1);
            double expected = Math.PI / (distance * distance);
            assertEquals(expected, irradiance(light, Vec3.ZERO, Vec3.Z), 1e-15 * expected);
            assertEquals(0, irradiance(light, Vec3.ZERO, new Vec3(0, 0, -1)));
        }
        assertTrue(Double.isNaN(irradiance(new SphereLight(Vec3.ZERO, 1), new Vec3(0.5, 0, 0), Vec3.Z)));
        assertTrue(Double.isNaN(irradiance(new SphereLight(Vec3.ZERO, 1), new Vec3(1, 0, 0), Vec3.X)), "touching");
    }

    /** The integral over a parallelogram, of which only v0 &lt; v is above the horizon. */
    private static double byArea(Vec3 corner, Vec3 right, Vec3 up, Vec3 p, Vec3 n, double v0) {
        Vec3 area = up.cross(right);
        return Quadrature.integral(
                v -> Quadrature.integral(
                        u -> {
                            Vec3 w = corner.minus(p).plus(right.times(u)).plus(up.times(v));
                            double square = w.lengthSquared();
                            return w.dot(n) * Math.abs(area.dot(w)) / (square * square);
                        },
                        0,
                        1,
                        8),
                v0,
                1,
                8);
    }

    @ParameterizedTest
    @ValueSource(doubles = {0.6, 1, 10, 100, 500, 520, 1000, 1e4, 1e6, 1e9, 1e12})
    void parallelogramsNearAndFarGiveTheIntegralOverTheirArea(double distance) {
        Vec3 corner = new Vec3(0.2, -0.1, 0.3);
        Vec3 right = new Vec3(0.7, 0.1, 0.2);
        Vec3 up = new Vec3(-0.1, 0.9, 0);
        Vec3 towards = new Vec3(0.1, 0.2, -1).normalized();
        Vec3 p = corner.plus(right.plus(up).times(0.5)).plus(towards.times(distance));
        Vec3 n = new Vec3(0.3, -0.2, 0.8).normalized();
        double expected = byArea(corner, right, up, p, n, 0);
        ParallelogramLight light = new ParallelogramLight(corner, right, up, true);
        assertEquals(expected, irradiance(light, p, n), 3e-12 * expected);
        Vec3 far = corner.plus(right).plus(up);
        double halves = irradiance(new TriangleLight(corner, corner.plus(right), far, true), p, n)
                + irradiance(new TriangleLight(corner, corner.plus(up), far, true), p, n);
        assertEquals(expected, halves, 3e-12 * expected);
    }

    /**
     * Rectangles have a form of their own where the horizon does not cut them; near ones also where an edge covers more than 60° or 120°.
     */
    @ParameterizedTest
    @ValueSource(doubles = {0.05, 0.2, 0.3, 0.6, 1, 3, 10, 100, 500, 520, 1000, 1e6})
    void rectanglesNearAndFarGiveTheIntegralOverTheirAreaOrTheSumOfTheirHalves(double distance) {
        Vec3 right = new Vec3(0.7, 0.1, 0.2);
        Vec3 up = right.cross(new Vec3(0.2, 0.3, -0.9)).normalized().times(0.9);
        Vec3 normal = right.cross(up).normalized();
        for (int k = 0; k < 40; k++) {
            Vec3 to = new Vec3(Hash.unit(Hash.of(1, k)) - 0.5, Hash.unit(Hash.of(2, k)) - 0.5, -1);
            Vec3 p = right.times(to.x()).plus(up.times(to.y())).plus(normal.times(to.z() * distance));
            Vec3 n = normal.plus(right.times(0.2 * to.y())).normalized();
            Vec3 corner = right.plus(up).times(-0.5);
            ParallelogramLight light = new ParallelogramLight(corner, right, up, true);
            Vec3 far = right.plus(up).times(0.5);
            double found = irradiance(light, p, n);
            if (distance > 0.5) {
                double expected = byArea(corner, right, up, p, n, 0);
                assertEquals(expected, found, 3e-12 * expected);
            } else {
                double halves = irradiance(new TriangleLight(corner, corner.plus(right), far, true), p, n)
                        + irradiance(new TriangleLight(corner, corner.plus(up), far, true), p, n);
                assertEquals(halves, found, 1e-13 * halves);
            }
        }
    }

    /** A rectangle is found to shine on a receiver exactly where it does. */
    @Test
    void lightReachesReceiversThatItIrradiates() {
        ParallelogramLight square = new ParallelogramLight(new Vec3(-0.5, -0.5, 0), Vec3.X, Vec3.Y, false);
        TriangleLight triangle = new TriangleLight(Vec3.ZERO, new Vec3(0, 1, 0), new Vec3(1, 0, 0), false);
        for (int k = 0; k < 2000; k++) {
            Vec3 p = new Vec3(signed(1, k), signed(2, k), signed(3, k)).times(2);
            Vec3 n = new Vec3(signed(4, k), signed(5, k), signed(6, k)).normalized();
            for (AreaLight light : new AreaLight[] {square, triangle}) {
                boolean shines = irradiance(light, p, n) > 0;
                assertEquals(
                        shines,
                        light.reaches(sample, n.x(), n.y(), n.z()),
                        light.getClass().getSimpleName());
            }
        }
    }

    private static double signed(int key, int k) {
        return 2 * Hash.unit(Hash.of(key, k)) - 1;
    }

    @ParameterizedTest
    @ValueSource(doubles = {0.6, 10, 500, 520, 1000, 1e4, 1e6})
    void parallelogramsCutByTheHorizonGiveTheIntegralOverWhatIsAboveIt(double distance) {
        Vec3 corner = new Vec3(-0.5, distance, -0.75);
        Vec3 right = new Vec3(1, 0.2, 0);
        Vec3 up = new Vec3(0, 0, 1);
        double expected = byArea(corner, right, up, Vec3.ZERO, Vec3.Z, 0.75);
        ParallelogramLight light = new ParallelogramLight(corner, right, up, true);
        assertEquals(expected, irradiance(light, Vec3.ZERO, Vec3.Z), (distance < 1e3 ? 1e-9 : 1e-12) * expected);
    }

    @Test
    void aLightInThePlaneOfTheReceiverGivesExactlyNothing() {
        ParallelogramLight square = new ParallelogramLight(new Vec3(1, 0, 0), Vec3.X, Vec3.Y, true);
        TriangleLight triangle = new TriangleLight(new Vec3(1, 0, 0), new Vec3(2, 0, 0), new Vec3(1, 1, 0), true);
        DiskLight disk = new DiskLight(new Vec3(3, 0, 0), Vec3.Z, 1, true);
        for (AreaLight light : new AreaLight[] {square, triangle, disk}) {
            assertEquals(0, irradiance(light, Vec3.ZERO, Vec3.X));
            light.sample(sample, 0.3, 0.6);
            assertEquals(0, sample.pdf);
            assertEquals(0, light.pdf(sample, 1, 0, 0, 2, 0));
        }
        // And one whose plane is the horizon.
        assertEquals(0, irradiance(square, new Vec3(0, 0, -1), new Vec3(0, 0, -1)));
        assertEquals(0, irradiance(square, new Vec3(0, 0, 0), Vec3.Z));
    }

    @Test
    void theBackOfALightWithOneSideIsBlack() {
        // Up × right is −z.
        ParallelogramLight square = new ParallelogramLight(Vec3.ZERO, Vec3.X, Vec3.Y, false);
        assertEquals(0, irradiance(square, new Vec3(0.5, 0.5, 1), new Vec3(0, 0, -1)));
        square.sample(sample, 0.5, 0.5);
        assertEquals(0, sample.pdf);
        assertTrue(irradiance(square, new Vec3(0.5, 0.5, -1), Vec3.Z) > 0.5);
    }

    /** P02 of the design: Howell's catalogue of configuration factors, C-11. */
    @Test
    void parallelSquaresExchangeWhatTheViewFactorSays() {
        ParallelogramLight light = new ParallelogramLight(new Vec3(0, 0, 1), Vec3.X, Vec3.Y, false);
        double mean = Quadrature.integral(
                x -> Quadrature.integral(y -> irradiance(light, new Vec3(x, y, 0), Vec3.Z), 0, 1, 2), 0, 1, 2);
        assertEquals(0.199824896, mean / Math.PI, 1e-9);
    }

    /** P03: Howell C-14; near the common edge the irradiance is steep, so panels shrink towards it. */
    @Test
    void squaresWithACommonEdgeExchangeWhatTheViewFactorSays() {
        ParallelogramLight light = new ParallelogramLight(Vec3.ZERO, Vec3.Y, Vec3.Z, true);
        double sum = 0;
        for (double hi = 1; hi > 1e-12; hi *= 0.5) {
            double end = hi;
            sum += Quadrature.panel(x -> 2 * steepEnd(light, x), 0.5 * end, end);
        }
        assertEquals(0.200043776, sum / Math.PI, 1e-9);
    }

    /** The half from y = 1/2 to 1, towards the corner. */
    private double steepEnd(AreaLight light, double x) {
        double sum = 0;
        for (double hi = 0.5; hi > 1e-12; hi *= 0.5) {
            sum += Quadrature.panel(y -> irradiance(light, new Vec3(x, 1 - y, 0), Vec3.Z), 0.5 * hi, hi);
        }
        return sum;
    }
}
