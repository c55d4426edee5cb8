package enlightenment.primitive;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.frame.Rotation;
import enlightenment.math.Vec3;
import enlightenment.numeric.Scale;
import java.math.BigDecimal;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;

/** Rectangles and triangles against exact arithmetic on the same doubles. */
class FlatTruthTest {
    private static final double U = Scale.UNIT_ROUNDOFF;

    /** A flat primitive and its corners, in order around it. */
    private record Flat(Primitive primitive, Vec3... corners) {
        double size() {
            return corners[1].minus(corners[0]).length()
                    + corners[2].minus(corners[0]).length();
        }
    }

    @Test
    void trianglesAgreeWithExactArithmetic() {
        check(800, 1, FlatTruthTest::triangle);
    }

    @Test
    void alignedRectanglesAgreeWithExactArithmetic() {
        check(800, 2, FlatTruthTest::alignedRectangle);
    }

    @Test
    void tiltedRectanglesAgreeWithExactArithmetic() {
        check(800, 3, FlatTruthTest::tiltedRectangle);
    }

    @Tag("full")
    @Test
    void manyRaysAgreeWithExactArithmetic() {
        check(2000, 1, FlatTruthTest::triangle);
        check(2000, 2, FlatTruthTest::alignedRectangle);
        check(2000, 3, FlatTruthTest::tiltedRectangle);
    }

    private interface Maker {
        Flat make(RandomRays random, double size);
    }

    private static Flat triangle(RandomRays random, double size) {
        Vec3 at = random.inCube().times(3 * size);
        Vec3 a = at.plus(random.inCube().times(size));
        Vec3 b = at.plus(random.inCube().times(size));
        Vec3 c = at.plus(random.inCube().times(size));
        if (random.index(4) == 0) {
            b = new Vec3(b.x(), a.y(), b.z());
            c = new Vec3(c.x(), a.y(), c.z());
        }
        return new Flat(new TrianglePrimitive(a, b, c), a, b, c);
    }

    private static Flat alignedRectangle(RandomRays random, double size) {
        Vec3 a = random.inCube().times(3 * size);
        double w = a.x() + size * random.signed();
        double h = a.y() + size * random.signed();
        Vec3[] c = {a, new Vec3(a.x(), h, a.z()), new Vec3(w, h, a.z()), new Vec3(w, a.y(), a.z())};
        int turn = random.index(3);
        for (int i = 0; i < c.length; i++) {
            for (int k = 0; k < turn; k++) {
                c[i] = new Vec3(c[i].y(), c[i].z(), c[i].x());
            }
        }
        return new Flat(new RectanglePrimitive(c[0], c[1], c[2], c[3]), c);
    }

    private static Flat tiltedRectangle(RandomRays random, double size) {
        Rotation r = random.rotation();
        Vec3 a = random.inCube().times(3 * size);
        Vec3 up = r.axis(0).times(size);
        Vec3 right = r.axis(1).times(size * random.uniform());
        Vec3[] c = {a, a.plus(up), a.plus(up).plus(right), a.plus(right)};
        return new Flat(new RectanglePrimitive(c[0], c[1], c[2], c[3]), c);
    }

    private static void check(int rays, long seed, Maker maker) {
        RandomRays random = new RandomRays(seed);
        int hits = 0;
        int certain = 0;
        for (int i = 0; i < rays; i++) {
            double size = Math.abs(random.decade(-9, 9));
            Flat flat = maker.make(random, size);
            Vec3 s = random.inCube();
            Vec3 target = flat.corners[0]
                    .plus(flat.corners[1].minus(flat.corners[0]).times(1.4 * s.x() * s.x() * s.x() + 0.4))
                    .plus(flat.corners[2].minus(flat.corners[0]).times(0.8 * s.y()));
            Vec3 o = target.plus(random.direction().times(size * Math.abs(random.decade(-3, 6))));
            Vec3 d = target.minus(o).times(0.5 + random.uniform());
            Ray ray = Ray.of(o, d);
            double grain = distance(flat, o) * U;
            Exact n = normal(flat);
            if (Math.abs(clearance(flat, ray)) < 64 * grain) {
                continue;
            }
            certain++;
            Hit hit = new Hit();
            boolean met = flat.primitive.intersect(ray, hit);
            BigDecimal t = Exact.quotient(
                    n.dot(Exact.of(flat.corners[0]).minus(Exact.origin(ray))), n.dot(Exact.direction(ray)));
            assertEquals(clearance(flat, ray) > 0 && t.signum() >= 0, met, "ray " + i);
            if (met) {
                hits++;
                checkHit(i, flat, ray, hit, n, t, grain);
            }
        }
        assertTrue(certain > rays / 2 && hits > certain / 10 && hits < certain * 9 / 10, hits + " of " + certain);
    }

    private static void checkHit(int i, Flat flat, Ray ray, Hit hit, Exact n, BigDecimal t, double grain) {
        double length = Math.sqrt(ray.dd);
        double cosine = Math.abs(n.dot(Exact.direction(ray)).doubleValue())
                / (n.length().doubleValue() * length);
        double bound = 16 * grain / cosine;
        double error = t.subtract(new BigDecimal(hit.t)).abs().doubleValue() * length;
        assertTrue(error <= bound, "ray " + i + ": t is off by " + error + ", may be " + bound);
        Exact p = Exact.of(hit.point());
        double off = Exact.quotient(n.dot(p.minus(Exact.of(flat.corners[0]))), n.length())
                .abs()
                .doubleValue();
        double ulp = Math.ulp(Math.max(hit.point().maxAbs(), Math.max(flat.corners[0].maxAbs(), flat.size())));
        assertTrue(off <= 8 * ulp, "ray " + i + ": " + off / ulp + " ulp off the plane");
        Exact along = Exact.origin(ray).plus(Exact.direction(ray).times(t));
        double miss = along.minus(p).length().doubleValue();
        assertTrue(miss <= 2 * bound + 8 * ulp, "ray " + i + ": point off by " + miss);
        double facing = n.dot(Exact.direction(ray)).doubleValue();
        assertEquals(facing < 0 ? Ray.OUTSIDE : Ray.INSIDE, hit.side, "ray " + i);
        assertEquals(1, hit.normal().length(), 4 * Math.ulp(1.0));
    }

    /** (second − first) × (last − first): up × right. */
    private static Exact normal(Flat flat) {
        Vec3[] c = flat.corners;
        Exact a = Exact.of(c[0]);
        return Exact.of(c[1]).minus(a).cross(Exact.of(c[c.length - 1]).minus(a));
    }

    private static double distance(Flat flat, Vec3 o) {
        double d = 0;
        for (Vec3 c : flat.corners) {
            d = Math.max(d, c.minus(o).length() + c.maxAbs() + o.maxAbs());
        }
        return d;
    }

    /** How far inside the outline the ray's line passes, exactly computed; negative outside. */
    private static double clearance(Flat flat, Ray ray) {
        Exact o = Exact.origin(ray);
        Exact d = Exact.direction(ray);
        int sign = normal(flat).dot(d).signum();
        double least = Double.POSITIVE_INFINITY;
        int n = flat.corners.length;
        for (int k = 0; k < n; k++) {
            Exact a = Exact.of(flat.corners[k]);
            Exact b = Exact.of(flat.corners[(k + 1) % n]);
            BigDecimal side = d.dot(b.minus(o).cross(a.minus(o)));
            double gap = Exact.quotient(side, d.cross(b.minus(a)).length()).doubleValue();
            least = Math.min(least, gap * -sign);
        }
        return least;
    }
}
