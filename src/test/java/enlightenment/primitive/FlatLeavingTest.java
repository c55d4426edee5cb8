package enlightenment.primitive;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.math.Vec3;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;

/** N18: a ray that leaves a surface meets it again exactly where geometry says; N08: whatever its direction's length. */
class FlatLeavingTest {
    private static final double[] SCALES = {1e-9, 1, 1e9};
    private static final double[] SHIFTS = {0, 1e6, 1e9};
    private static final int KINDS = 5;

    private static Primitive primitive(RandomRays random, int kind, double size, Vec3 at) {
        Vec3 up = random.direction().times(size);
        Vec3 right = random.direction().times(size);
        switch (kind) {
            case 0:
                return new BoxPrimitive(
                        at, at.plus(new Vec3(0.1 + random.uniform(), 0.1 + random.uniform(), 1).times(size)));
            case 1:
                return new CubePrimitive(at, size, random.rotation());
            case 2:
                return new TrianglePrimitive(at, at.plus(up), at.plus(right));
            case 3:
                return new RectanglePrimitive(at, at.plus(up), at.plus(up).plus(right), at.plus(right));
            default:
                Vec3 h = new Vec3(0, size, 0);
                Vec3 w = new Vec3(0, 0, size);
                return new RectanglePrimitive(at, at.plus(h), at.plus(h).plus(w), at.plus(w));
        }
    }

    @Test
    void noRayMeetsTheSurfaceItLeavesAndNoneIsLostInside() {
        leave(20_000);
    }

    @Test
    @Tag("full")
    void noneOfAMillionRaysMeetsTheSurfaceItLeaves() {
        leave(1_000_000);
    }

    private static void leave(int rays) {
        for (int kind = 0; kind < KINDS; kind++) {
            for (double scale : SCALES) {
                for (double shift : SHIFTS) {
                    leave(kind, scale, shift, rays / (SCALES.length * SHIFTS.length));
                }
            }
        }
    }

    private static void leave(int kind, double scale, double shift, int rays) {
        RandomRays random = new RandomRays(18 + kind);
        Hit hit = new Hit();
        Hit again = new Hit();
        int met = 0;
        for (int i = 0; i < rays; i++) {
            Vec3 at = random.inCube().times(scale * shift);
            Primitive p = primitive(random, kind, scale, at);
            Vec3 target = p.bounds().center().plus(random.inCube().times(0.3 * scale));
            Vec3 o = target.plus(random.direction().times(4 * scale));
            if (!p.intersect(Ray.of(o, target.minus(o)), hit)) {
                continue;
            }
            met++;
            double cosine = i % 2 == 0 ? random.uniform() : Math.abs(random.decade(-12, -1));
            Vec3 out = random.leaving(hit.normal(), cosine);
            String name = p.getClass().getSimpleName() + " " + scale + " " + shift + " ray " + i;
            assertEquals(
                    Primitive.MISS, p.nearest(Ray.leaving(hit.point(), out, p, Ray.OUTSIDE), Double.MAX_VALUE), name);
            Ray inwards = Ray.leaving(hit.point(), out.negated(), p, Ray.INSIDE);
            if (p.isSolid()) {
                int from = hit.face;
                assertTrue(p.intersect(inwards, again), name + " is lost inside");
                assertTrue(again.t >= 0 && again.side == Ray.INSIDE && again.t <= 2.5 * 2 * scale, name);
                // Only a ray that starts within rounding of an edge may leave through the face that it starts on.
                boolean elsewhere = again.face != from;
                double ulp = Math.ulp(hit.point().maxAbs() + scale);
                assertTrue(elsewhere || again.t <= 64 * ulp / cosine, name + " leaves through the face it came in by");
                assertTrue(again.normal().dot(out) < 0, name);
            } else {
                assertEquals(Primitive.MISS, p.nearest(inwards, Double.MAX_VALUE), name);
            }
        }
        assertTrue(met > rays / 10, met + " of " + rays);
    }

    @Test
    void theLengthOfTheDirectionDoesNotMatter() {
        RandomRays random = new RandomRays(8);
        Hit one = new Hit();
        Hit other = new Hit();
        int hits = 0;
        for (int i = 0; i < 1000; i++) {
            Primitive p = primitive(random, i % KINDS, 1, random.inCube());
            Vec3 target = p.bounds().center().plus(random.inCube().times(0.5));
            Vec3 o = target.plus(random.direction().times(0.1 + 5 * random.uniform()));
            Vec3 d = target.minus(o).normalized();
            boolean met = p.intersect(Ray.of(o, d), one);
            hits += met ? 1 : 0;
            for (int k = -1000; k <= 1000; k += 50) {
                assertEquals(met, p.intersect(Ray.of(o, d.scaledBy(k)), other), "ray " + i + " times 2^" + k);
                if (met) {
                    assertEquals(one.point(), other.point(), "ray " + i + " times 2^" + k);
                    assertEquals(one.normal(), other.normal());
                    assertEquals(one.face, other.face);
                    assertEquals(one.side, other.side);
                }
            }
            Vec3 tiny = d.times(1e-310);
            assertTrue(tiny.maxAbs() > 0 && p.intersect(Ray.of(o, tiny), other) == met || nearRim(p, o, d), "ray " + i);
            if (met) {
                double off = Math.abs(one.normal().dot(other.point().minus(one.point())));
                assertTrue(off <= 8 * Math.ulp(1 + one.point().maxAbs()) || one.face != other.face, "ray " + i);
            }
        }
        assertTrue(hits > 300 && hits < 900, hits + " hits");
    }

    /** A subnormal direction has few digits: close to the outline it may point to the other side. */
    private static boolean nearRim(Primitive p, Vec3 o, Vec3 d) {
        boolean any = false;
        boolean all = true;
        for (int k = 0; k < 6; k++) {
            Vec3 nudge = (k < 2 ? Vec3.X : k < 4 ? Vec3.Y : Vec3.Z).times((k & 1) == 0 ? 1e-12 : -1e-12);
            boolean met = p.nearest(Ray.of(o, d.plus(nudge)), Double.MAX_VALUE) < Primitive.MISS;
            any |= met;
            all &= met;
        }
        return any && !all;
    }

    @Test
    void sizesBeyondOrdinaryOnesAreScaled() {
        RandomRays random = new RandomRays(9);
        Hit one = new Hit();
        Hit other = new Hit();
        int hits = 0;
        for (int i = 0; i < 2000; i++) {
            Primitive p = primitive(random, i % KINDS, 1, random.inCube());
            Vec3 o = random.inCube().times(4);
            Vec3 d = p.bounds().center().minus(o);
            boolean met = p.intersect(Ray.of(o, d), one);
            for (int k = -900; k <= 900; k += 300) {
                Ray ray = Ray.of(o.scaledBy(k), d.scaledBy(k));
                assertEquals(met, p.scaledBy(k).intersect(ray, other), "ray " + i + ", scene times 2^" + k);
                if (met) {
                    hits++;
                    assertEquals(one.t, other.t);
                    assertEquals(one.point().scaledBy(k), other.point());
                    assertEquals(one.normal(), other.normal());
                }
            }
        }
        assertTrue(hits > 4000);
    }
}
