package enlightenment.primitive;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.frame.Rotation;
import enlightenment.math.Vec3;
import enlightenment.numeric.Scale;
import java.math.BigDecimal;
import org.junit.jupiter.api.Test;

/** Boxes and cubes against exact slabs of the same doubles. */
class BoxCubeTruthTest {
    private static final int RAYS = 5000;
    private static final double U = Scale.UNIT_ROUNDOFF;

    /** A solid between three pairs of planes: lo ≤ axis·(p − center) ≤ hi. */
    private record Solid(Primitive primitive, Vec3 center, Vec3[] axes, Vec3 lo, Vec3 hi) {
        double size() {
            return hi.minus(lo).maxAbs();
        }
    }

    private interface Maker {
        Solid make(RandomRays random, double size);
    }

    @Test
    void boxesAgreeWithExactArithmetic() {
        check(4, BoxCubeTruthTest::box);
    }

    @Test
    void cubesAgreeWithExactArithmetic() {
        check(5, BoxCubeTruthTest::cube);
    }

    @Test
    void cubesOfQuarterTurnsAgreeWithExactArithmetic() {
        check(6, BoxCubeTruthTest::quarterTurnedCube);
    }

    private static Solid box(RandomRays random, double size) {
        Vec3 lo = random.inCube().times(3 * size);
        Vec3 hi = lo.plus(new Vec3(random.uniform(), random.uniform(), random.uniform()).times(size));
        return new Solid(new BoxPrimitive(lo, hi), Vec3.ZERO, new Vec3[] {Vec3.X, Vec3.Y, Vec3.Z}, lo, hi);
    }

    private static Solid cube(RandomRays random, double size) {
        Rotation r = random.rotation();
        Vec3 center = random.inCube().times(3 * size);
        Vec3 h = new Vec3(size, size, size);
        return new Solid(
                new CubePrimitive(center, size, r),
                center,
                new Vec3[] {r.axis(0), r.axis(1), r.axis(2)},
                h.negated(),
                h);
    }

    private static Solid quarterTurnedCube(RandomRays random, double size) {
        Rotation r = Rotation.ofDegrees(new Vec3(90 * random.index(4), 90 * random.index(4), 90 * random.index(4)));
        Vec3 center = random.inCube().times(3 * size);
        Vec3 h = new Vec3(size, size, size);
        // The faces lie at center ± size, rounded once.
        return new Solid(
                new CubePrimitive(center, size, r),
                Vec3.ZERO,
                new Vec3[] {Vec3.X, Vec3.Y, Vec3.Z},
                center.minus(h),
                center.plus(h));
    }

    private static void check(long seed, Maker maker) {
        RandomRays random = new RandomRays(seed);
        int certain = 0;
        int entered = 0;
        int left = 0;
        for (int i = 0; i < RAYS; i++) {
            double size = Math.abs(random.decade(-9, 9));
            Solid solid = maker.make(random, size);
            Vec3 middle = solid.center.plus(inside(solid, new Vec3(0.5, 0.5, 0.5)));
            Vec3 fractions = random.inCube().times(0.6).plus(new Vec3(0.5, 0.5, 0.5));
            Vec3 target = solid.center.plus(inside(solid, fractions));
            double away = i % 4 == 0 ? 0.2 : Math.abs(random.decade(-1, 6));
            Vec3 o = target.plus(random.direction().times(solid.size() * away));
            Ray ray = Ray.of(o, target.minus(o).times(0.5 + random.uniform()));
            double grain = U * (o.minus(middle).length() + o.maxAbs() + middle.maxAbs() + solid.size());
            Interval exact = new Interval(solid, ray);
            double length = Math.sqrt(ray.dd);
            double margin = Math.min(exact.gap(), exact.fromOrigin()) * length;
            if (margin < 64 * grain * exact.steepness()) {
                continue;
            }
            certain++;
            Hit hit = new Hit();
            boolean met = solid.primitive.intersect(ray, hit);
            boolean expected = exact.near.compareTo(exact.far) <= 0 && exact.far.signum() >= 0;
            assertEquals(expected, met, "ray " + i);
            if (met) {
                boolean entering = exact.near.signum() >= 0;
                entered += entering ? 1 : 0;
                left += entering ? 0 : 1;
                assertEquals(entering ? Ray.OUTSIDE : Ray.INSIDE, hit.side, "ray " + i);
                checkHit(i, solid, ray, hit, entering ? exact.near : exact.far, 16 * grain * exact.steepness());
            }
        }
        assertTrue(
                certain > RAYS * 0.9 && entered > RAYS / 5 && left > RAYS / 20, certain + ": " + entered + ", " + left);
    }

    private static Vec3 inside(Solid s, Vec3 fractions) {
        Vec3 sum = Vec3.ZERO;
        for (int k = 0; k < 3; k++) {
            double f = fractions.component(k);
            sum = sum.plus(s.axes[k].times(s.lo.component(k) * (1 - f) + s.hi.component(k) * f));
        }
        return sum;
    }

    private static void checkHit(int i, Solid solid, Ray ray, Hit hit, BigDecimal t, double bound) {
        double error = t.subtract(new BigDecimal(hit.t)).abs().doubleValue() * Math.sqrt(ray.dd);
        assertTrue(error <= bound, "ray " + i + ": t is off by " + error + ", may be " + bound);
        double ulp = Math.ulp(Math.max(hit.point().maxAbs(), solid.size()));
        Exact p = Exact.of(hit.point()).minus(Exact.of(solid.center));
        double nearest = Double.POSITIVE_INFINITY;
        for (int k = 0; k < 3; k++) {
            BigDecimal along = p.dot(Exact.of(solid.axes[k]));
            double above = along.subtract(new BigDecimal(solid.lo.component(k))).doubleValue();
            double below = new BigDecimal(solid.hi.component(k)).subtract(along).doubleValue();
            assertTrue(Math.min(above, below) >= -8 * ulp, "ray " + i + " outside by " + Math.min(above, below) / ulp);
            nearest = Math.min(nearest, Math.min(Math.abs(above), Math.abs(below)));
            boolean upper = solid.axes[k].dot(hit.normal()) > 0.5;
            boolean lower = solid.axes[k].dot(hit.normal()) < -0.5;
            if (upper || lower) {
                assertTrue(Math.abs(upper ? below : above) <= 8 * ulp, "ray " + i + " off its face");
            }
        }
        assertTrue(nearest <= 8 * ulp, "ray " + i + ": " + nearest / ulp + " ulp off the surface");
    }

    /** The exact interval of a ray within a solid. */
    private static final class Interval {
        private BigDecimal near;
        private BigDecimal far;
        private double steepness = 1;

        Interval(Solid s, Ray ray) {
            Exact d = Exact.direction(ray);
            Exact f = Exact.origin(ray).minus(Exact.of(s.center));
            for (int k = 0; k < 3; k++) {
                Exact axis = Exact.of(s.axes[k]);
                BigDecimal along = d.dot(axis);
                BigDecimal lo = Exact.quotient(new BigDecimal(s.lo.component(k)).subtract(f.dot(axis)), along);
                BigDecimal hi = Exact.quotient(new BigDecimal(s.hi.component(k)).subtract(f.dot(axis)), along);
                near = near == null ? lo.min(hi) : near.max(lo.min(hi));
                far = far == null ? lo.max(hi) : far.min(lo.max(hi));
                steepness = Math.max(steepness, Math.sqrt(ray.dd) / Math.abs(along.doubleValue()));
            }
        }

        double gap() {
            return far.subtract(near).abs().doubleValue();
        }

        double fromOrigin() {
            return Math.min(near.abs().doubleValue(), far.abs().doubleValue());
        }

        /** How much a displacement of a plane is magnified along the ray, at worst. */
        double steepness() {
            return steepness;
        }
    }
}
