package enlightenment.primitive;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.math.Vec3;
import enlightenment.numeric.Scale;
import java.math.BigDecimal;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/**
 * Random rays against decimal arithmetic. A solid is entered later than the same solid inflated by the allowed error,
 * and earlier than the deflated one: that bounds hit, miss and distance at once, at grazing incidence and at rims too.
 */
class RoundTruthTest {
    /** The allowed displacement of a surface, in roundings of the distance from it: "4 u D". */
    static final double ROUNDINGS = 4;

    /** Says what is wrong with a ray's answer, or null. */
    static String verdict(Primitive p, ExactSolid solid, Vec3 o, Vec3 d, double size) {
        double distance = o.minus(RoundSamples.center(p)).length() + size;
        double allowed = ROUNDINGS * Scale.UNIT_ROUNDOFF * distance;
        BigDecimal[] inner = solid.inflated(-allowed).stretch(o, d);
        BigDecimal[] outer = solid.inflated(allowed).stretch(o, d);
        double t = p.nearest(Ray.of(o, d), Double.MAX_VALUE);
        double lowest;
        double highest;
        boolean mustHit = inner != null && inner[1].signum() >= 0;
        if (outer == null || outer[1].signum() < 0) {
            return t == Primitive.MISS ? null : "hits at " + t + " but passes by";
        } else if (outer[0].signum() > 0) {
            lowest = outer[0].doubleValue();
            highest = (mustHit ? inner[0] : outer[1]).doubleValue();
        } else if (inner != null && inner[0].signum() < 0) {
            lowest = inner[1].doubleValue();
            highest = outer[1].doubleValue();
        } else {
            lowest = 0;
            highest = outer[1].doubleValue();
        }
        if (t == Primitive.MISS) {
            return mustHit ? "misses, but must hit" : null;
        }
        double rounding = 4 * Math.ulp(highest);
        return t >= lowest - rounding && t <= highest + rounding ? null : t + " not in " + lowest + ".." + highest;
    }

    private static Primitive frustum(RoundSamples s) {
        Vec3 axis = s.axis().times(s.magnitude(1e-3, 100));
        Vec3 base = s.direction().times(s.magnitude(0.01, 100));
        double r = s.magnitude(0.1, 10);
        double other =
                switch (s.below(8)) {
                    case 0 -> 0;
                    case 1 -> r;
                    case 2 -> Math.nextUp(r);
                    case 3 -> r * (1 + s.magnitude(1e-15, 1e-1));
                    case 4 -> r * s.magnitude(1e-12, 1e-1);
                    default -> s.magnitude(0.1, 10);
                };
        return s.oneIn(2)
                ? new ConePrimitive(base, base.plus(axis), r, other, true)
                : new ConePrimitive(base, base.plus(axis), other, r, true);
    }

    private static Primitive primitive(String kind, RoundSamples s) {
        return kind.equals("frustum") ? frustum(s) : s.primitive(kind, s.magnitude(0.1, 10), s.magnitude(0.01, 100));
    }

    /** A point to aim at: near the surface or a rim, on the axis, or anywhere around. */
    private static Vec3 target(Primitive p, RoundSamples s, double size) {
        if (p instanceof AxialPrimitive a) {
            Vec3 axis = a.top().minus(a.base());
            double fraction = s.oneIn(3) ? s.below(2) : s.uniform(0, 1);
            double radius = a.baseRadius() + fraction * (a.topRadius() - a.baseRadius());
            double off = s.oneIn(3) ? 1 + s.uniform(-1, 1) * s.magnitude(1e-15, 1) : s.uniform(0, 1.5);
            return a.base()
                    .plus(axis.times(fraction))
                    .plus(s.across(axis.normalized()).times(radius * off));
        }
        return RoundSamples.center(p).plus(s.direction().times(s.uniform(0, 0.6) * size));
    }

    private static void check(String kind, int rays, long seed) {
        RoundSamples s = new RoundSamples(seed);
        List<String> wrong = new ArrayList<>();
        int hits = 0;
        for (int i = 0; i < rays; i++) {
            Primitive p = primitive(kind, s);
            double size = RoundSamples.size(p);
            Vec3 target = target(p, s, size);
            Vec3 o = s.oneIn(4)
                    ? target(p, s, size * 0.5)
                    : target.plus(s.direction().times(size * s.magnitude(0.1, 1e6)));
            Vec3 d = target.minus(o);
            if (s.oneIn(8) && p instanceof AxialPrimitive a) {
                d = a.top().minus(a.base());
                o = target.minus(d.times(s.uniform(0, 3)));
            }
            if (d.maxAbs() == 0) {
                continue;
            }
            String verdict = verdict(p, ExactSolid.of(p), o, d, size);
            if (verdict != null) {
                wrong.add(verdict + ": " + p.getClass().getSimpleName() + List.of(boxed(p)) + " " + o + " " + d);
            }
            hits += p.nearest(Ray.of(o, d), Double.MAX_VALUE) != Primitive.MISS ? 1 : 0;
        }
        assertEquals(List.of(), wrong, wrong.size() + " of " + rays);
        assertTrue(hits > rays / 4 && hits < rays, hits + " hits of " + rays);
    }

    private static String boxed(Primitive p) {
        return java.util.Arrays.toString(p.parameters());
    }

    @ParameterizedTest
    @ValueSource(strings = {"sphere", "cylinder", "cone", "frustum"})
    void crossingsAreThoseOfDecimalArithmetic(String kind) {
        check(kind, 250, 1);
    }

    @Tag("full")
    @ParameterizedTest
    @ValueSource(strings = {"sphere", "cylinder", "cone", "frustum"})
    void manyCrossingsAreThoseOfDecimalArithmetic(String kind) {
        check(kind, 60_000, 2);
    }

    @Test
    void aDiskIsHitWhereDecimalArithmeticSaysSo() {
        RoundSamples s = new RoundSamples(3);
        int decided = 0;
        for (int i = 0; i < 1500; i++) {
            DiskPrimitive p = (DiskPrimitive) s.primitive("disk", s.magnitude(0.1, 10), s.magnitude(0.01, 100));
            Vec3 n = p.normal();
            double off = s.oneIn(2) ? 1 + s.uniform(-1, 1) * s.magnitude(1e-15, 1) : s.uniform(0, 1.5);
            Vec3 target = p.center().plus(s.across(n).times(p.radius() * off));
            Vec3 o = target.plus(s.direction().times(p.radius() * s.magnitude(0.1, 1e6)));
            Vec3 d = target.minus(o);
            decided += checkDisk(p, o, d) ? 1 : 0;
        }
        assertTrue(decided > 1000, decided + " decided");
    }

    private static boolean checkDisk(DiskPrimitive p, Vec3 o, Vec3 d) {
        double[] q = p.parameters();
        BigDecimal[] n = ExactSolid.vector(new Vec3(q[3], q[4], q[5]));
        BigDecimal[] f = ExactSolid.minus(ExactSolid.vector(o), ExactSolid.vector(p.center()));
        BigDecimal[] dir = ExactSolid.vector(d);
        BigDecimal exact = ExactSolid.dot(f, n).negate().divide(ExactSolid.dot(dir, n), ExactSolid.MC);
        BigDecimal[] at = ExactSolid.plus(f, dir, exact);
        double clearance = ExactSolid.dot(at, at)
                .sqrt(ExactSolid.MC)
                .subtract(ExactSolid.big(p.radius()))
                .doubleValue();
        double distance = o.minus(p.center()).length() + p.radius();
        double cosine = Math.abs(d.dot(p.normal())) / d.length();
        double allowed = ROUNDINGS * Scale.UNIT_ROUNDOFF * distance / cosine;
        double t = p.nearest(Ray.of(o, d), Double.MAX_VALUE);
        if (Math.abs(clearance) > allowed) {
            assertEquals(clearance < 0, t != Primitive.MISS, () -> "clearance " + clearance + " of " + boxed(p));
        }
        if (t != Primitive.MISS) {
            double error = new BigDecimal(t).subtract(exact).abs().doubleValue() * d.length();
            assertTrue(error <= allowed, () -> "t is off by " + error + " of " + allowed);
        }
        return Math.abs(clearance) > allowed;
    }

    @Test
    void anOpenFrustumIsHitOnItsLateralSurfaceOnly() {
        checkOpen(400);
    }

    @Tag("full")
    @Test
    void anOpenFrustumIsHitByManyRaysOnItsLateralSurfaceOnly() {
        checkOpen(1600);
    }

    private static void checkOpen(int rays) {
        RoundSamples s = new RoundSamples(4);
        int outside = 0;
        int inside = 0;
        int missed = 0;
        for (int i = 0; i < rays; i++) {
            AxialPrimitive solid = (AxialPrimitive) (s.oneIn(2) ? s.primitive("cylinder", 1, 2) : frustum(s));
            Primitive p = solid.baseRadius() == solid.topRadius()
                    ? new CylinderPrimitive(solid.base(), solid.top(), solid.baseRadius(), false)
                    : new ConePrimitive(solid.base(), solid.top(), solid.baseRadius(), solid.topRadius(), false);
            double size = RoundSamples.size(p);
            Vec3 o = RoundSamples.center(p).plus(s.direction().times(size * s.uniform(0, 3)));
            Vec3 d = target(p, s, size).minus(o);
            ExactSolid truth = ExactSolid.of(p);
            List<BigDecimal> exact = truth.lateralCrossings(o, d);
            List<BigDecimal> inner = truth.inflated(-1e-9).lateralCrossings(o, d);
            List<BigDecimal> outer = truth.inflated(1e-9).lateralCrossings(o, d);
            if (exact == null || inner == null || outer == null || inner.size() != outer.size()) {
                continue;
            }
            Hit hit = new Hit();
            boolean met = p.intersect(Ray.of(o, d), hit);
            assertEquals(!exact.isEmpty(), met, () -> boxed(p) + " " + o + " " + d);
            if (met) {
                assertEquals(exact.get(0).doubleValue(), hit.t, 1e-11 * (1 + hit.t));
                int side = hit.normal().dot(d) < 0 ? Ray.OUTSIDE : Ray.INSIDE;
                assertEquals(side, hit.side);
                assertEquals(AxialPrimitive.LATERAL, hit.face);
                assertTrue(ExactSolid.of(p).lateralDistance(hit.point())
                        <= 8 * IntersectionVectorsTest.pointUlp(p, hit.point()));
                outside += side == Ray.OUTSIDE ? 1 : 0;
                inside += side == Ray.INSIDE ? 1 : 0;
            } else {
                missed++;
            }
        }
        boolean all = outside > rays / 8 && inside > rays / 8 && missed > rays / 40;
        assertTrue(all, outside + " " + inside + " " + missed);
    }
}
