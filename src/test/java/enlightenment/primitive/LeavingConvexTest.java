package enlightenment.primitive;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.math.Vec3;
import java.util.List;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.FieldSource;

/** Rays that leave a convex primitive (numerics, N18): none hits it again outside, none is lost inside. */
class LeavingConvexTest {
    static final List<String> KINDS = RoundSamples.CONVEX;

    private static void check(String kind, int rays) {
        for (double scale : new double[] {1e-9, 1, 1e9}) {
            for (double shift : new double[] {0, 1e6, 1e9}) {
                check(kind, scale, scale * shift, rays / 9 + 1);
            }
        }
    }

    private static void check(String kind, double scale, double shift, int rays) {
        RoundSamples s = new RoundSamples(20);
        Primitive p = null;
        for (int i = 0; i < rays; i++) {
            if (i % 50 == 0) {
                p = s.primitive(kind, scale, shift);
            }
            Hit start = s.surfacePoint(p);
            double cosine = s.oneIn(2) ? s.uniform(0, 1) : s.magnitude(1e-12, 1e-1);
            Vec3 outward = s.leaning(start.normal(), cosine).times(s.magnitude(1e-3, 1e3));
            Vec3 inward = s.leaning(start.normal(), -cosine).times(s.magnitude(1e-3, 1e3));
            Ray leaving = Ray.leaving(start.point(), outward, p, Ray.OUTSIDE);
            assertEquals(Primitive.MISS, p.nearest(leaving, Double.MAX_VALUE), "hits itself");
            checkInward(p, Ray.leaving(start.point(), inward, p, Ray.INSIDE), start, cosine);
        }
    }

    private static void checkInward(Primitive p, Ray ray, Hit start, double cosine) {
        Hit hit = new Hit();
        boolean left = p.intersect(ray, hit);
        if (!p.isSolid()) {
            assertEquals(false, left);
            return;
        }
        assertTrue(left, () -> "lost at cosine " + cosine);
        assertTrue(hit.t >= 0);
        assertEquals(Ray.INSIDE, hit.side);
        double size = RoundSamples.size(p);
        double ulp = IntersectionVectorsTest.pointUlp(p, start.point());
        Vec3 d = new Vec3(ray.dx, ray.dy, ray.dz);
        double moved = hit.point().minus(start.point()).length();
        // The point is on the ray, but for what rounding may move a grazing exit along the surface.
        double lever = Math.max(size * Math.max(cosine, 0), 0) + Math.sqrt(size * ulp);
        double away = hit.point().minus(start.point()).cross(d).length() / d.length();
        assertTrue(away <= 64 * ulp * (1 + size / lever), () -> away / ulp + " ulp off the ray at cosine " + cosine);
        assertTrue(moved <= 2 * size);
    }

    @ParameterizedTest
    @FieldSource("KINDS")
    void noRayHitsItselfOutsideNorIsLostInside(String kind) {
        check(kind, 9_000);
    }

    @Tag("full")
    @ParameterizedTest
    @FieldSource("KINDS")
    void noneOfAMillionRaysHitsItselfOutsideNorIsLostInside(String kind) {
        check(kind, 1_000_000);
    }
}
