package enlightenment.primitive;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.math.Vec3;
import java.math.BigDecimal;
import java.util.List;
import java.util.Random;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;

/** Rays that start on a torus (numerics N19): the truth is the quartic without the root that the start is. */
class TorusLeavingTest {
    private static final double U = 0x1p-53;

    @Test
    void leavingATorusMeetsItAgainOnlyAsTheReducedQuarticSays() {
        compare(150, 1);
    }

    @Test
    @Tag("full")
    void leavingATorusManyTimesMeetsItAgainOnlyAsTheReducedQuarticSays() {
        compare(20_000, 2);
    }

    private static void compare(int count, long seed) {
        Random random = new Random(seed);
        for (double far : new double[] {0, 1e6, 1e9}) {
            int wrong = 0;
            int again = 0;
            int escaped = 0;
            String example = "";
            for (int i = 0; i < count; i++) {
                Start s = new Start(random, far);
                TorusTruth truth = new TorusTruth(s.torus.center(), s.axis, s.major, s.minor, s.point, s.direction);
                int side = truth.signAfterStart();
                double t = s.torus.nearest(Ray.leaving(s.point, s.direction, s.torus, side), Double.MAX_VALUE);
                List<BigDecimal> exact = truth.crossingsAfterStart();
                if (exact.isEmpty() != (t == Primitive.MISS)) {
                    wrong++;
                    example = s + " side " + side + ": found " + t + ", exact " + exact;
                } else if (exact.isEmpty()) {
                    escaped++;
                } else {
                    again++;
                }
            }
            // About half meet it again; of 150, a third is four standard deviations away.
            assertTrue(again > count / 3 && escaped > count / 10, again + " again, " + escaped + " escaped");
            assertTrue(wrong <= (far < 1e9 ? 0 : count / 1000), wrong + " wrong at " + far + ", such as " + example);
        }
    }

    @Test
    void leavingATorusFindsTheNextCrossingWhereTheReducedQuarticHasIt() {
        compareNextCrossings(200);
    }

    @Test
    @Tag("full")
    void leavingATorusManyTimesFindsTheNextCrossingWhereTheReducedQuarticHasIt() {
        compareNextCrossings(400);
    }

    private static void compareNextCrossings(int rays) {
        Random random = new Random(3);
        int compared = 0;
        for (int i = 0; i < rays; i++) {
            Start s = new Start(random, 0);
            TorusTruth truth = new TorusTruth(s.torus.center(), s.axis, s.major, s.minor, s.point, s.direction);
            Ray ray = Ray.leaving(s.point, s.direction, s.torus, truth.signAfterStart());
            Hit hit = new Hit();
            List<BigDecimal> exact = truth.crossingsAfterStart();
            if (s.torus.intersect(ray, hit) && !exact.isEmpty()) {
                compared++;
                double steep = Math.abs(hit.normal().dot(s.direction.normalized()));
                double scale = (s.major + s.minor) / s.direction.length();
                assertEquals(exact.get(0).doubleValue(), hit.t, 64 * U * scale / steep, s::toString);
                assertEquals(ray.startSide, hit.side, s::toString);
            }
        }
        assertTrue(compared > rays / 2, compared + " compared");
    }

    @Test
    void aShortChordHasTheLengthThatTheReducedQuarticSays() {
        compareShortChords(600);
    }

    @Test
    @Tag("full")
    void manyShortChordsHaveTheLengthThatTheReducedQuarticSays() {
        compareShortChords(1500);
    }

    private static void compareShortChords(int rays) {
        Random random = new Random(7);
        int compared = 0;
        for (int i = 0; i < rays; i++) {
            Start s = new Start(random, 0);
            if (s.cosine == 0 || Math.abs(s.cosine) > 1e-3) {
                continue;
            }
            TorusTruth truth = new TorusTruth(s.torus.center(), s.axis, s.major, s.minor, s.point, s.direction);
            Ray ray = Ray.leaving(s.point, s.direction, s.torus, truth.signAfterStart());
            double t = s.torus.nearest(ray, Double.MAX_VALUE);
            List<BigDecimal> exact = truth.crossingsAfterStart();
            double scale = (s.major + s.minor) / s.direction.length();
            if (t < 1e-2 * scale && !exact.isEmpty()) {
                compared++;
                double error = Math.abs(exact.get(0).doubleValue() - t);
                assertTrue(error <= 64 * U * scale * s.major / s.minor, () -> "t is off by " + error + ": " + s);
            }
        }
        assertTrue(compared > rays * 2 / 15, compared + " compared");
    }

    @Test
    void fromInsideTheExitIsNeverLost() {
        exit(15_000);
    }

    @Test
    @Tag("full")
    void fromInsideTheExitOfManyRaysIsNeverLost() {
        exit(50_000);
    }

    private static void exit(int rays) {
        Random random = new Random(4);
        for (double far : new double[] {0, 1e6, 1e9}) {
            for (int i = 0; i < rays; i++) {
                Start s = new Start(random, far);
                Hit hit = new Hit();
                assertTrue(s.torus.intersect(Ray.leaving(s.point, s.direction, s.torus, Ray.INSIDE), hit), s::toString);
                assertEquals(Ray.INSIDE, hit.side, s::toString);
                assertTrue(hit.t >= 0);
            }
        }
    }

    @Test
    void fromOutsideWhatIsMetIsMetFromOutside() {
        meetFromOutside(20_000);
    }

    @Test
    @Tag("full")
    void fromOutsideWhatManyRaysMeetIsMetFromOutside() {
        meetFromOutside(50_000);
    }

    private static void meetFromOutside(int rays) {
        Random random = new Random(5);
        int met = 0;
        for (int i = 0; i < rays; i++) {
            Start s = new Start(random, 0);
            Hit hit = new Hit();
            if (s.torus.intersect(Ray.leaving(s.point, s.direction, s.torus, Ray.OUTSIDE), hit)) {
                met++;
                assertEquals(Ray.OUTSIDE, hit.side, s::toString);
            }
        }
        assertTrue(met > rays / 10, "a torus is not convex: only " + met);
    }

    @Test
    void aRayThatBouncesInsideTheTubeStaysOnItsSurface() {
        TorusPrimitive torus = new TorusPrimitive(Vec3.ZERO, Vec3.Y, 1, 0.25);
        Ray ray = Ray.leaving(new Vec3(1.25, 0, 0), new Vec3(-0.3, 0.2, 0.7), torus, Ray.INSIDE);
        Hit hit = new Hit();
        for (int i = 0; i < 10_000; i++) {
            assertTrue(torus.intersect(ray, hit), "lost at bounce " + i);
            double off = Math.hypot(Math.hypot(hit.px, hit.pz) - 1, hit.py) - 0.25;
            assertEquals(0, off, 4 * Math.ulp(1.25));
            Vec3 d = new Vec3(ray.dx, ray.dy, ray.dz);
            Vec3 reflected = d.minus(hit.normal().times(2 * d.dot(hit.normal())));
            ray.set(hit.px, hit.py, hit.pz, reflected.x(), reflected.y(), reflected.z(), 0);
            ray.from(torus, Ray.INSIDE);
        }
    }

    /** A point found by a hit, and a direction from it: any, or an almost tangential one. */
    private static final class Start {
        final Vec3 axis;
        final double major;
        final double minor;
        final TorusPrimitive torus;
        final Vec3 point;
        final Vec3 direction;
        final double cosine;

        Start(Random random, double far) {
            double scale = new double[] {1e-9, 1, 1e9}[random.nextInt(3)];
            axis = gaussian(random);
            major = scale * (0.2 + random.nextDouble());
            minor = major
                    * switch (random.nextInt(6)) {
                        case 0 -> 1;
                        case 1 -> Math.pow(10, -4 * random.nextDouble());
                        default -> 0.02 + 0.97 * random.nextDouble();
                    };
            Vec3 center = gaussian(random).times(far * scale);
            torus = new TorusPrimitive(center, axis.normalized(), major, minor);
            Hit hit = new Hit();
            Vec3 inTube;
            do {
                Vec3 radial = axis.cross(gaussian(random)).normalized();
                inTube = center.plus(radial.times(major));
            } while (!torus.intersect(Ray.of(inTube, gaussian(random)), hit));
            point = hit.point();
            Vec3 n = hit.normal();
            Vec3 tangent = n.cross(gaussian(random)).normalized();
            cosine = random.nextBoolean()
                    ? 2 * random.nextDouble() - 1
                    : (random.nextBoolean() ? 1 : -1) * Math.pow(10, -1 - 11 * random.nextDouble());
            Vec3 unit = n.times(cosine).plus(tangent.times(Math.sqrt(1 - cosine * cosine)));
            direction = unit.times(Math.pow(10, 6 * random.nextDouble() - 3));
        }

        @Override
        public String toString() {
            return "torus at " + torus.center() + " about " + axis + ", radii " + major + ", " + minor + ", from "
                    + point + " along " + direction;
        }
    }

    private static Vec3 gaussian(Random random) {
        return new Vec3(random.nextGaussian(), random.nextGaussian(), random.nextGaussian());
    }
}
