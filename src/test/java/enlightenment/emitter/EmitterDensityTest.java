package enlightenment.emitter;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.frame.Basis;
import enlightenment.math.Vec3;
import enlightenment.sampling.ChiSquare;
import enlightenment.sampling.RunningStatistics;
import java.util.List;
import java.util.SplittableRandom;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/** The densities of light points per solid angle are those with which they are sampled. */
class EmitterDensityTest {
    private static final int SAMPLES = 10_000;
    private static final int RINGS = 4;
    private static final int SECTORS = 8;

    /** Something that is seen from the origin. */
    record Seen(String name, Emitter emitter) {
        @Override
        public String toString() {
            return name;
        }
    }

    static Stream<Seen> seen() {
        return Stream.of(
                new Seen("ball", new SphereEmitter(new Vec3(1, 2, -1), 0.8)),
                new Seen("near ball", new SphereEmitter(new Vec3(0, 0, 1), 0.999)),
                new Seen("far ball", new SphereEmitter(new Vec3(3e8, 1e8, 2e8), 1)),
                new Seen("ball around", new SphereEmitter(new Vec3(0.2, 0.3, -0.1), 1)),
                new Seen("rectangle", new RectangleEmitter(new Vec3(-1, 1, 2), new Vec3(2, 0, 0), new Vec3(0, 1, 1))),
                new Seen(
                        "parallelogram",
                        new RectangleEmitter(new Vec3(-1, -1, 2), new Vec3(2, 1, 0), new Vec3(0.5, 2, 1))),
                new Seen(
                        "slanted rectangle",
                        new RectangleEmitter(new Vec3(-1, -1, 1), new Vec3(2, 0, 0), new Vec3(0, 2, 3))));
    }

    private final SplittableRandom random = new SplittableRandom(5);

    private void sample(Seen seen, EmitterView view) {
        seen.emitter.sample(view, random.nextDouble(), random.nextDouble());
    }

    @ParameterizedTest
    @MethodSource("seen")
    void theDensityOfASampleIsThatOfItsDirection(Seen seen) {
        EmitterView view = Views.fromOrigin(seen.emitter);
        int rim = 0;
        for (int k = 0; k < 2_000; k++) {
            sample(seen, view);
            double pdf = seen.emitter.pdf(view);
            assertTrue(pdf > 0 && pdf < Double.POSITIVE_INFINITY);
            double same = seen.emitter.pdf(view, view.dx, view.dy, view.dz);
            if (same == 0) {
                rim++;
            } else {
                assertEquals(pdf, same, 1e-11 * pdf);
            }
            // Away from it the density is 0, unless it is all around.
            double away = seen.emitter.pdf(view, -view.dx, -view.dy, -view.dz);
            assertEquals(view.cone.inside ? pdf : 0, away);
        }
        assertTrue(rim <= 2, rim + " directions miss what they were sampled on by rounding");
    }

    /** The cone of the ball around an emitter: directions in it, uniform in solid angle, and cells of them. */
    private final class Cone {
        private final double down;
        private final double most;
        private final Basis basis = new Basis();
        private final double wx;
        private final double wy;
        private final double wz;
        private final double solidAngle;
        private double x;
        private double y;
        private double z;

        Cone(EmitterView view) {
            down = view.cone.inside ? 2 : view.cone.oneMinusCosine();
            most = view.cone.inside ? 1 : view.cone.sine;
            wx = view.cone.wx;
            wy = view.cone.wy;
            wz = view.cone.wz;
            basis.around(wx, wy, wz);
            solidAngle = 2 * Math.PI * down;
        }

        void choose() {
            double drop = random.nextDouble() * down;
            double across = Math.sqrt(drop * (2 - drop));
            double angle = 2 * Math.PI * random.nextDouble();
            double s = across * Math.cos(angle);
            double t = across * Math.sin(angle);
            x = wx * (1 - drop) + basis.ax * s + basis.bx * t;
            y = wy * (1 - drop) + basis.ay * s + basis.by * t;
            z = wz * (1 - drop) + basis.az * s + basis.bz * t;
        }

        int cell(double dx, double dy, double dz) {
            double s = dx * basis.ax + dy * basis.ay + dz * basis.az;
            double t = dx * basis.bx + dy * basis.by + dz * basis.bz;
            int ring = Math.min((int) (RINGS * (s * s + t * t) / (most * most)), RINGS - 1);
            int sector = Math.min((int) (SECTORS * (Math.atan2(t, s) / (2 * Math.PI) + 0.5)), SECTORS - 1);
            return ring * SECTORS + sector;
        }
    }

    @ParameterizedTest
    @MethodSource("seen")
    void samplesAreDistributedAsTheirDensitySaysAndItIsOneInAll(Seen seen) {
        EmitterView view = Views.fromOrigin(seen.emitter);
        Cone cone = new Cone(view);
        // More directions than samples, so that the error of what is expected hardly counts.
        int directions = 10 * SAMPLES;
        double[] expected = new double[RINGS * SECTORS];
        RunningStatistics all = new RunningStatistics();
        for (int k = 0; k < directions; k++) {
            cone.choose();
            double p = seen.emitter.pdf(view, cone.x, cone.y, cone.z) * cone.solidAngle;
            expected[cone.cell(cone.x, cone.y, cone.z)] += p * SAMPLES / directions;
            all.add(p);
        }
        assertEquals(1, all.mean(), 4 * all.standardError() + 1e-12);
        int[] counts = new int[RINGS * SECTORS];
        for (int k = 0; k < SAMPLES; k++) {
            sample(seen, view);
            counts[cone.cell(view.dx, view.dy, view.dz)]++;
        }
        pool(expected, counts);
        ChiSquare.check(expected, counts, seen.name);
    }

    /** Cells that expect too few are counted with the fullest one. */
    private static void pool(double[] expected, int[] counts) {
        int fullest = 0;
        for (int k = 1; k < expected.length; k++) {
            fullest = expected[k] > expected[fullest] ? k : fullest;
        }
        for (int k = 0; k < expected.length; k++) {
            if (expected[k] < 50) {
                expected[fullest] += expected[k];
                counts[fullest] += counts[k];
                expected[k] = 5;
                counts[k] = 5;
            }
        }
    }

    @Test
    void aPointIsSeenInOneDirectionThatNobodyElseChooses() {
        PointEmitter point = new PointEmitter(new Vec3(0, 3, 4));
        EmitterView view = Views.fromOrigin(point);
        assertTrue(point.isDelta());
        point.sample(view, 0.3, 0.8);
        assertEquals(5, view.length);
        assertEquals(0.8, view.dz);
        assertEquals(1, point.pdf(view), "a probability");
        assertEquals(0, point.pdf(view, view.dx, view.dy, view.dz));
        EmitterView there = Views.from(point.position(), point);
        point.sample(there, 0.3, 0.8);
        assertEquals(0, point.pdf(there), "from its own place it has no direction");
    }

    @Test
    void edgeOnARectangleCoversNoSolidAngle() {
        RectangleEmitter flat = new RectangleEmitter(new Vec3(1, -1, 0), new Vec3(0, 2, 0), new Vec3(1, 0, 0));
        EmitterView view = Views.fromOrigin(flat);
        for (Vec3 uv : List.of(new Vec3(0.2, 0.3, 0), new Vec3(0.9, 0.5, 0))) {
            flat.sample(view, uv.x(), uv.y());
            assertEquals(0, 1 / flat.pdf(view));
            assertEquals(0, flat.pdf(view, view.dx, view.dy, view.dz));
        }
    }
}
