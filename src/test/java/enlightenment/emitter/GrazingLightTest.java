package enlightenment.emitter;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.math.Vec3;
import java.math.BigDecimal;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Rectangles and triangles that are sampled evenly over their solid angles from next to their planes and edges, however long and thin. */
class GrazingLightTest {
    private static final double ULP = 0x1p-52;

    private final SplittableRandom random = new SplittableRandom(41);

    /** A number whose logarithm is even. */
    private double scaled(double least, double most) {
        return least * Math.exp(Math.log(most / least) * random.nextDouble());
    }

    private double signed(double least, double most) {
        return random.nextBoolean() ? scaled(least, most) : -scaled(least, most);
    }

    @Test
    void rectanglesAreSampledEvenlyFromAnywhereDownToTheSmallestSolidAngles() {
        checkRectangles(500);
    }

    @Tag("full")
    @Test
    void soAreThousandsOfRectangles() {
        checkRectangles(5000);
    }

    private void checkRectangles(int rectangles) {
        SphericalRectangle r = new SphericalRectangle();
        int checked = 0;
        for (int k = 0; k < rectangles; k++) {
            double width = random.nextBoolean() ? 1 : scaled(1e-8, 1);
            double length = random.nextBoolean() ? 1 : scaled(1e-8, 1);
            double height = scaled(1e-12, 10);
            double x = random.nextBoolean() ? -width * random.nextDouble() : signed(1e-9, 30);
            double y = random.nextBoolean() ? -length * random.nextDouble() : signed(1e-9, 30);
            r.set(x, width, y, length, height);
            r.measure();
            if (!(r.solidAngle > 1e-12)) {
                continue;
            }
            r.prepare();
            checked++;
            check(r, x, width, y, length, height);
        }
        assertTrue(checked > rectangles * 2 / 3, checked + " of " + rectangles);
    }

    private void check(SphericalRectangle r, double x, double width, double y, double length, double height) {
        String where = "x " + x + " width " + width + " y " + y + " length " + length + " height " + height;
        BigDecimal x0 = new BigDecimal(x);
        BigDecimal x1 = x0.add(new BigDecimal(width));
        BigDecimal y0 = new BigDecimal(y);
        BigDecimal y1 = y0.add(new BigDecimal(length));
        BigDecimal z = new BigDecimal(height);
        double whole = ExactSolidAngle.ofRectangle(x0, x1, y0, y1, z);
        // The rounding of the far edges may be that of a smaller width.
        double size = 1e-12 + 4 * ULP * (Math.abs(x) / width + Math.abs(y) / length);
        assertEquals(whole, r.solidAngle, size * whole, where);
        for (double u : new double[] {0, random.nextDouble() * 1e-3, 0.25, random.nextDouble(), 0.75, 1}) {
            double v = random.nextDouble();
            r.choose(u, v);
            assertTrue(r.x >= x && r.x <= x + width && r.y >= y && r.y <= y + length, where);
            double error = 16 * ULP * Math.abs(r.x);
            double share = share(x0, r.x, x1, y0, y1, z, whole);
            double low = share(x0, r.x - error, x1, y0, y1, z, whole);
            double high = share(x0, r.x + error, x1, y0, y1, z, whole);
            // A few roundings of an angle of at most a half turn, next to Ω.
            double few = 1e-11 + size + 16 * ULP * Math.PI / whole;
            assertEquals(u, share, Math.max(high - low, few), where + " u " + u);
            checkAcross(r, y, length, height, v, where);
        }
    }

    private static double share(
            BigDecimal x0, double x, BigDecimal x1, BigDecimal y0, BigDecimal y1, BigDecimal z, double whole) {
        BigDecimal to = new BigDecimal(x).max(x0).min(x1);
        return ExactSolidAngle.ofRectangle(x0, to, y0, y1, z) / whole;
    }

    /** At an x the solid angle grows as sin of the angle at which y is seen. */
    private static void checkAcross(
            SphericalRectangle r, double y, double length, double height, double v, String where) {
        BigDecimal from = rise(y, 0, r.x, height);
        BigDecimal all = rise(y, length, r.x, height).subtract(from);
        double share = rise(r.y, 0, r.x, height)
                .subtract(from)
                .divide(all, ExactSolidAngle.DIGITS)
                .doubleValue();
        double d = Math.hypot(r.x, height);
        double reach = Math.min(1, d / Math.abs(r.y)) * d / Math.hypot(d, r.y);
        assertEquals(v, share, 1e-13 + 16 * ULP * reach / all.doubleValue(), where + " v " + v);
    }

    private static BigDecimal rise(double y, double more, double x, double height) {
        BigDecimal sum = new BigDecimal(y).add(new BigDecimal(more));
        BigDecimal[] p = {new BigDecimal(x), sum, new BigDecimal(height)};
        return sum.divide(ExactSolidAngle.length(p), ExactSolidAngle.DIGITS);
    }

    /** The receiver stands above the plane and looks across a wide lamp, half of which is above its horizon, or along it. */
    @ParameterizedTest
    @ValueSource(doubles = {1e-3, 3e-6, 3e-7, 5e-8, 1e-8, 2e-9})
    void theIrradianceOfALongLampAtAGrazingAngleIsThatOfTheClosedForm(double height) {
        ParallelogramLight light =
                new ParallelogramLight(new Vec3(1.5, -2.3, 0), new Vec3(1, 0, 0), new Vec3(0, 6.7, 0), true);
        LightSample s = new LightSample();
        light.aim(s, 0, 0, height);
        double closed = light.irradiance(s, 1, 0, 0);
        assertEquals(closed, gridOfSamples(light, s, Vec3.X), 1e-3 * closed);
    }

    /** The mean over the midpoints of a grid. */
    private static double gridOfSamples(AreaLight light, LightSample s, Vec3 n) {
        int grid = 64;
        double sum = 0;
        for (int k = 0; k < grid * grid; k++) {
            light.sample(s, (k % grid + 0.5) / grid, (k / grid + 0.5) / grid);
            assertTrue(s.pdf > 0);
            assertEquals(s.pdf, light.pdf(s, s.dx, s.dy, s.dz, s.length, s.cosine), 1e-12 * s.pdf);
            sum += Math.max(0, n.x() * s.dx + n.y() * s.dy + n.z() * s.dz) / s.pdf;
        }
        return sum / (grid * grid);
    }

    @Test
    void theIrradianceOfANeedleNextToTheReceiverIsThatOfTheClosedForm() {
        Vec3 a = Vec3.ZERO;
        Vec3 b = Vec3.X;
        Vec3 c = new Vec3(-.0036848, 5.0847e-6, 0);
        Vec3[] receivers = {new Vec3(.65684, 1.0103e-4, 3.0735e-6), new Vec3(.3, 1e-6, 1e-8), new Vec3(.3, -1e-6, 1e-7)
        };
        LightSample s = new LightSample();
        for (Vec3 p : receivers) {
            for (AreaLight light : new AreaLight[] {
                new TriangleLight(a, b, c, true), new TriangleLight(b, c, a, true), new TriangleLight(c, a, b, true)
            }) {
                light.aim(s, p.x(), p.y(), p.z());
                Vec3 n = new Vec3(0.1, p.y() > 0 ? -1 : 1, -0.1).normalized();
                double closed = light.irradiance(s, n.x(), n.y(), n.z());
                assertEquals(closed, gridOfSamples(light, s, n), 2e-3 * closed);
            }
        }
    }

    @Test
    void trianglesAreSampledEvenlyUpToTheRoundingOfWhereTheyAreSeenFrom() {
        checkTriangles(700);
    }

    @Tag("full")
    @Test
    void soAreThousandsOfTriangles() {
        checkTriangles(7000);
    }

    private void checkTriangles(int triangles) {
        int checked = 0;
        for (int k = 0; k < triangles; k++) {
            double aspect = random.nextInt(3) == 0 ? 1 : scaled(1e-7, 1);
            Vec3[] corners = {
                Vec3.ZERO, Vec3.X, new Vec3(random.nextBoolean() ? random.nextDouble() : signed(1e-5, 3), aspect, 0)
            };
            int turn = random.nextInt(3);
            Vec3 p = corners[turn];
            Vec3 q = corners[(turn + 1) % 3];
            Vec3 r = corners[(turn + 2) % 3];
            double share = Math.sqrt(random.nextDouble());
            double other = share * random.nextDouble();
            Vec3 inside =
                    p.plus(q.minus(p).times(share - other)).plus(r.minus(p).times(other));
            double height = scaled(1e-9, 1);
            double aside = random.nextBoolean() ? 0 : signed(1e-9, 2);
            Vec3 receiver = inside.plus(new Vec3(0, aside, height));
            checked += check(p, q, r, receiver, Math.hypot(aside, height)) ? 1 : 0;
        }
        assertTrue(checked > triangles / 4, checked + " of " + triangles + " were sampled by solid angle");
    }

    private boolean check(Vec3 p, Vec3 q, Vec3 r, Vec3 receiver, double distance) {
        TriangleLight light = new TriangleLight(p, q, r, true);
        LightSample s = new LightSample();
        light.aim(s, receiver.x(), receiver.y(), receiver.z());
        light.sample(s, 0.5, 0.5);
        if (s.choice != SamplingChoice.SOLID_ANGLE) {
            return false;
        }
        String where = p + " " + q + " " + r + " from " + receiver;
        BigDecimal[] from = exact(receiver);
        BigDecimal[] a = ExactSolidAngle.minus(exact(p), from);
        BigDecimal[] b = ExactSolidAngle.minus(exact(q), from);
        BigDecimal[] c = ExactSolidAngle.minus(exact(r), from);
        double whole = ExactSolidAngle.ofTriangle(a, b, c);
        // Corners are rounded to a unit in the last place of their distances, next to which the light is that near.
        double rounding = 1e-11 + 64 * ULP * light.ballRadius() / Math.min(distance, receiver.z());
        assertEquals(whole, s.triangle.solidAngle, rounding * whole, where);
        for (double u : new double[] {0, 0.125, random.nextDouble(), 0.875, 1}) {
            for (double v : new double[] {0.25, 1}) {
                light.sample(s, u, v);
                assertTrue(s.pdf > 0, where);
                BigDecimal[] d = ExactSolidAngle.point(s.dx, s.dy, s.dz);
                // Where the plane through b and the direction cuts the opposite edge.
                BigDecimal[] plane = ExactSolidAngle.cross(b, d);
                BigDecimal ofA = ExactSolidAngle.dot(plane, a);
                BigDecimal t = ofA.divide(ofA.subtract(ExactSolidAngle.dot(plane, c)), ExactSolidAngle.DIGITS);
                BigDecimal[] cut =
                        ExactSolidAngle.between(a, c, t.max(BigDecimal.ZERO).min(BigDecimal.ONE));
                String at = where + " u " + u + " v " + v;
                assertEquals(u, ExactSolidAngle.ofTriangle(a, b, cut) / whole, rounding, at);
                assertEquals(v, down(b, d) / down(b, cut), 64 * ULP / down(b, cut) + rounding, at);
            }
        }
        return true;
    }

    private static BigDecimal[] exact(Vec3 p) {
        return ExactSolidAngle.point(p.x(), p.y(), p.z());
    }

    /** 1 less the cosine of an angle. */
    private static double down(BigDecimal[] b, BigDecimal[] d) {
        BigDecimal product = ExactSolidAngle.length(b).multiply(ExactSolidAngle.length(d));
        return BigDecimal.ONE
                .subtract(ExactSolidAngle.dot(b, d).divide(product, ExactSolidAngle.DIGITS))
                .doubleValue();
    }
}
