package enlightenment.emitter;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.frame.Basis;
import enlightenment.frame.SceneFrame;
import enlightenment.geometry.Rectangle;
import enlightenment.geometry.Sphere;
import enlightenment.math.ExactPoint;
import enlightenment.math.Vec3;
import enlightenment.primitive.Primitives;
import enlightenment.sampling.ChiSquare;
import enlightenment.sampling.Quadrature;
import enlightenment.sampling.RunningStatistics;
import java.util.SplittableRandom;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.MethodSource;

/** Points on lights: even over the area; and samples where they are hard: at grazing angles, far away, at other scales. */
class LightPointTest {
    private static final int SAMPLES = 10_000;
    private static final int GRID = 4;

    private final SplittableRandom random = new SplittableRandom(23);

    static Stream<SeenLight> lights() {
        return SeenLights.forms().stream();
    }

    private static int cell(AreaLight light, double x, double y, double z) {
        Vec3 c = light.ballCenter();
        double r = light.ballRadius();
        return (part(x - c.x(), r) * GRID + part(y - c.y(), r)) * GRID + part(z - c.z(), r);
    }

    private static int part(double offset, double radius) {
        return Math.min(Math.max((int) (GRID * (offset / radius + 1) / 2), 0), GRID - 1);
    }

    /** Lines that are even in direction and place meet a surface evenly over its area (Crofton). */
    @ParameterizedTest
    @MethodSource("lights")
    void pointsAreAsDenseAsTheCrossingsOfRandomLines(SeenLight seen) {
        AreaLight light = seen.light;
        int cells = GRID * GRID * GRID;
        int[] counts = new int[cells];
        SurfacePoint point = new SurfacePoint();
        for (int k = 0; k < SAMPLES; k++) {
            light.samplePoint(random.nextDouble(), random.nextDouble(), point);
            assertEquals(1, Math.sqrt(point.nx * point.nx + point.ny * point.ny + point.nz * point.nz), 1e-14);
            counts[cell(light, point.x, point.y, point.z)]++;
        }
        double[] expected = new double[cells];
        double[] crossings = new double[1];
        int lines = 8 * SAMPLES;
        for (int k = 0; k < lines; k++) {
            line(seen, (x, y, z) -> {
                expected[cell(light, x, y, z)]++;
                crossings[0]++;
            });
        }
        double r = light.ballRadius();
        // A line through the ball meets an area A that often in the mean: 2 · (A/2)/(π r²) · ½.
        double mean = light.area() / (2 * Math.PI * r * r);
        assertEquals(mean, crossings[0] / lines, 5 * Math.sqrt(2 * mean / lines));
        double scale = SAMPLES / crossings[0];
        for (int k = 0; k < cells; k++) {
            expected[k] *= scale;
        }
        AreaLightTest.pool(expected, counts);
        ChiSquare.check(expected, counts, seen.name);
    }

    private void line(SeenLight seen, SeenLight.Crossing crossing) {
        double z = 2 * random.nextDouble() - 1;
        double across = Math.sqrt(1 - z * z);
        double angle = 2 * Math.PI * random.nextDouble();
        Vec3 d = new Vec3(across * Math.cos(angle), across * Math.sin(angle), z);
        Basis basis = new Basis();
        basis.around(d.x(), d.y(), d.z());
        double turn = 2 * Math.PI * random.nextDouble();
        double r = seen.light.ballRadius();
        double p = r * Math.sqrt(random.nextDouble());
        double s = p * Math.cos(turn);
        double t = p * Math.sin(turn);
        Vec3 offset = new Vec3(s * basis.ax + t * basis.bx, s * basis.ay + t * basis.by, s * basis.az + t * basis.bz);
        seen.cross(seen.light.ballCenter().plus(offset).minus(d.times(2 * r)), d, crossing);
    }

    /** Cells of the rectangle itself, by quadrature of the solid angle that they cover. */
    @ParameterizedTest
    @CsvSource({"4, 0.3, 0.01", "-0.1, -0.1, 0.0001", "1, 0.5, 0.001", "-30, 0.5, 0.001", "3, 0.5, 1e-6", "9, 9, 1e3"})
    void rectanglesAtGrazingAnglesAreSampledAsTheirDensitySays(double x, double y, double z) {
        ParallelogramLight light = new ParallelogramLight(Vec3.ZERO, new Vec3(2, 0, 0), new Vec3(0, 1, 0), true);
        LightSample s = new LightSample();
        light.aim(s, x, y, z);
        int[] counts = new int[64];
        int samples = 20_000;
        RunningStatistics solidAngle = new RunningStatistics();
        for (int k = 0; k < samples; k++) {
            light.sample(s, random.nextDouble(), random.nextDouble());
            assertTrue(s.pdf > 0);
            assertEquals(s.pdf, light.pdf(s, s.dx, s.dy, s.dz, s.length, s.cosine), 1e-12 * s.pdf);
            double px = Math.fma(s.length, s.dx, x);
            double py = Math.fma(s.length, s.dy, y);
            assertEquals(0, Math.fma(s.length, s.dz, z), 1e-14 * (s.length + z));
            counts[8 * Math.min(Math.max((int) (4 * px), 0), 7) + Math.min(Math.max((int) (8 * py), 0), 7)]++;
            solidAngle.add(1 / s.pdf);
        }
        double[] expected = new double[64];
        double sum = 0;
        for (int k = 0; k < expected.length; k++) {
            expected[k] = cellAngle(k / 8, k % 8, x, y, z);
            sum += expected[k];
        }
        assertEquals(sum, solidAngle.mean(), 1e-9 * sum + 4 * solidAngle.standardError());
        boolean even = solidAngle.standardError() > 1e-12 * sum;
        for (int k = 0; k < expected.length; k++) {
            expected[k] = even ? samples / 64.0 : expected[k] * samples / sum;
        }
        AreaLightTest.pool(expected, counts);
        ChiSquare.check(expected, counts, x + " " + y + " " + z);
    }

    private static double cellAngle(int i, int k, double x, double y, double z) {
        double lo = i / 4.0;
        double hi = lo + 0.25;
        double near = Math.min(Math.max(x, lo), hi);
        return slices(near, hi, k, x, y, z) + slices(near, lo, k, x, y, z);
    }

    /** Slices of the cell across x, in panels that widen away from where it is nearest. */
    private static double slices(double near, double far, int k, double x, double y, double z) {
        double sum = 0;
        double width = Math.abs(far - near);
        double side = Math.signum(far - near);
        for (double from = 0, to = Math.min(0.25 * z, width); from < width; from = to, to = Math.min(2 * to, width)) {
            sum += Quadrature.panel(
                    t -> {
                        // ∫ z/(q² + (py − y)²)^{3/2} dpy, q² = (px − x)² + z²
                        double px = near + side * t - x;
                        double q = px * px + z * z;
                        return z / q * (rise(k / 8.0 + 0.125 - y, q) - rise(k / 8.0 - y, q));
                    },
                    from,
                    to);
        }
        return sum;
    }

    private static double rise(double y, double q) {
        return y / Math.sqrt(q + y * y);
    }

    @Test
    void theIrradianceOfSamplesIsRightAtEveryDistance() {
        AreaLight[] lights = {
            new SphereLight(Vec3.ZERO, 1),
            new ParallelogramLight(Vec3.ZERO, Vec3.X, Vec3.Y, true),
            new ParallelogramLight(Vec3.ZERO, Vec3.X, new Vec3(0.4, 1, 0), true),
            new TriangleLight(Vec3.ZERO, Vec3.X, Vec3.Y, true)
        };
        LightSample s = new LightSample();
        for (double distance = 1.2; distance < 2e12; distance *= 9) {
            Vec3 p = new Vec3(0.3, 0.6, 0.8).times(distance);
            Vec3 n = new Vec3(-0.5, -0.2, -0.7).normalized();
            for (AreaLight light : lights) {
                light.aim(s, p.x(), p.y(), p.z());
                RunningStatistics sampled = new RunningStatistics();
                for (int k = 0; k < 2000; k++) {
                    light.sample(s, random.nextDouble(), random.nextDouble());
                    sampled.add((n.x() * s.dx + n.y() * s.dy + n.z() * s.dz) / s.pdf);
                }
                double closed = light.irradiance(s, n.x(), n.y(), n.z());
                assertEquals(closed, sampled.mean(), 4.5 * sampled.standardError() + 1e-13 * closed);
                light.sampleByCosine(s, n.x(), n.y(), n.z(), 0.3, 0.8);
                if (light.samplesByCosine(s, n.x(), n.y(), n.z())) {
                    double same = (n.x() * s.dx + n.y() * s.dy + n.z() * s.dz) / s.pdf;
                    assertEquals(closed, same, 1e-14 * closed);
                }
            }
        }
    }

    @Test
    void powersOfTwoChangeNoBit() {
        for (int e : new int[] {-110, -7, 60, 110}) {
            double f = Math.scalb(1.0, e);
            LightSample s = new LightSample();
            LightSample t = new LightSample();
            for (SeenLight seen : SeenLights.forms()) {
                AreaLight one = seen.light;
                AreaLight other = Scaled.by(one, f);
                Vec3 v = seen.viewer;
                one.aim(s, v.x(), v.y(), v.z());
                other.aim(t, f * v.x(), f * v.y(), f * v.z());
                for (int k = 0; k < 20; k++) {
                    double p = random.nextDouble();
                    double q = random.nextDouble();
                    one.sample(s, p, q);
                    other.sample(t, p, q);
                    assertEquals(s.pdf, t.pdf, seen.name);
                    assertEquals(f * s.length, t.length);
                    assertEquals(s.dx, t.dx);
                }
                assertEquals(one.irradiance(s, 0.6, 0, 0.8), other.irradiance(t, 0.6, 0, 0.8));
            }
        }
    }

    @Test
    void enormousAndTinyScenesGiveTheSameLights() {
        for (int e : new int[] {-900, 900}) {
            double f = Math.scalb(1.0, e);
            SceneFrame frame = new SceneFrame(ExactPoint.ORIGIN, e);
            assertArrayEquals(
                    new SphereLight(new Vec3(1, 2, 3), 0.5).parameters(),
                    AreaLights.of(
                                    Primitives.place(Sphere.of(ExactPoint.of(f, 2 * f, 3 * f), f / 2), frame),
                                    0,
                                    LightSides.FRONT)
                            .parameters());
            Rectangle square = new Rectangle(
                    ExactPoint.ORIGIN, ExactPoint.of(0, f, 0), ExactPoint.of(f, f, 0), ExactPoint.of(f, 0, 0));
            assertArrayEquals(
                    new ParallelogramLight(Vec3.ZERO, Vec3.X, Vec3.Y, true).parameters(),
                    AreaLights.of(Primitives.place(square, frame), 0, LightSides.BOTH)
                            .parameters());
        }
    }
}
