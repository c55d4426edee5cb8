package enlightenment.primitive;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.math.Vec3;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.FieldSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Ladders of direction length, clearance and distance (numerics, N08 to N10). */
class RoundLadderTest {
    static final List<String> KINDS = RoundSamples.CONVEX;

    @ParameterizedTest
    @FieldSource("KINDS")
    void theHitDoesNotDependOnAPowerOfTwoInTheDirection(String kind) {
        RoundSamples s = new RoundSamples(10);
        int hits = 0;
        for (int i = 0; i < 1000; i++) {
            Primitive p = s.primitive(kind, 1, 3);
            Vec3 o = RoundSamples.center(p).plus(s.direction().times(s.uniform(0.1, 20)));
            Vec3 d = s.surfacePoint(p).point().minus(o).plus(s.direction().times(s.uniform(0, 0.5)));
            Hit expected = new Hit();
            boolean met = p.intersect(Ray.of(o, d), expected);
            for (int j = -1000; j <= 1000; j += 50) {
                Hit hit = new Hit();
                assertEquals(met, p.intersect(Ray.of(o, d.scaledBy(j)), hit));
                if (met) {
                    assertEquals(expected.point(), hit.point(), () -> kind + " " + o + d);
                    assertEquals(expected.normal(), hit.normal());
                    assertEquals(expected.face, hit.face);
                    assertEquals(expected.side, hit.side);
                    assertEquals(Math.scalb(expected.t, -j), hit.t);
                    assertEquals(hit.t, p.nearest(Ray.of(o, d.scaledBy(j)), Double.MAX_VALUE));
                }
            }
            hits += met ? 1 : 0;
        }
        assertTrue(hits > 500 && hits < 1000, hits + " hits");
    }

    @ParameterizedTest
    @FieldSource("KINDS")
    void aPowerOfTwoInEveryLengthScalesTheHitAndNothingElse(String kind) {
        RoundSamples s = new RoundSamples(15);
        int hits = 0;
        for (int i = 0; i < 300; i++) {
            Primitive p = s.primitive(kind, 1, 3);
            Vec3 o = RoundSamples.center(p).plus(s.direction().times(s.uniform(0.1, 20)));
            Vec3 d = s.surfacePoint(p).point().minus(o).plus(s.direction().times(s.uniform(0, 0.3)));
            Hit expected = new Hit();
            boolean met = p.intersect(Ray.of(o, d), expected);
            hits += met ? 1 : 0;
            for (int k : new int[] {-900, -300, -60, -1, 60, 300, 900}) {
                Primitive q = p.scaledBy(k);
                Ray ray = Ray.of(o.scaledBy(k), d);
                Hit hit = new Hit();
                assertEquals(met, q.intersect(ray, hit));
                if (met) {
                    assertEquals(expected.point().scaledBy(k), hit.point());
                    assertEquals(expected.normal(), hit.normal());
                    assertEquals(Math.scalb(expected.t, k), q.nearest(ray, Double.MAX_VALUE));
                    assertEquals(hit.t, q.nearest(ray, hit.t));
                    assertEquals(Primitive.MISS, q.nearest(ray, Math.nextDown(hit.t)));
                }
            }
        }
        assertTrue(hits > 150, hits + " hits");
    }

    @ParameterizedTest
    @ValueSource(strings = {"sphere", "cylinder", "cone", "frustum"})
    void aSubnormalDirectionStillHitsTheSurface(String kind) {
        hitBySubnormals(kind, 100);
    }

    @Tag("full")
    @ParameterizedTest
    @ValueSource(strings = {"sphere", "cylinder", "cone", "frustum"})
    void manySubnormalDirectionsStillHitTheSurface(String kind) {
        hitBySubnormals(kind, 500);
    }

    private static void hitBySubnormals(String kind, int rays) {
        RoundSamples s = new RoundSamples(11);
        for (int i = 0; i < rays; i++) {
            Primitive p = s.primitive(kind, 1, 3);
            Vec3 o = RoundSamples.center(p).plus(s.direction().times(s.uniform(3, 20)));
            Vec3 d = RoundSamples.center(p).minus(o).times(1e-310);
            Hit hit = new Hit();
            assertTrue(p.intersect(Ray.of(o, d), hit));
            double ulp = IntersectionVectorsTest.pointUlp(p, hit.point());
            assertTrue(ExactSolid.of(p).distance(hit.point()) <= 8 * ulp);
            assertNotEquals(Primitive.MISS, p.nearest(Ray.of(o, d), Double.MAX_VALUE));
        }
    }

    @ParameterizedTest
    @ValueSource(strings = {"sphere", "cylinder", "cone", "frustum", "flare"})
    void aLineIsHitIfAndOnlyIfItsClearanceSaysSo(String kind) {
        climbClearances(kind, 8);
    }

    @Tag("full")
    @ParameterizedTest
    @ValueSource(strings = {"sphere", "cylinder", "cone", "frustum", "flare"})
    void manyLinesAreHitIfAndOnlyIfTheirClearanceSaysSo(String kind) {
        climbClearances(kind, 16);
    }

    private static void climbClearances(String kind, int lines) {
        RoundSamples s = new RoundSamples(12);
        List<String> wrong = new ArrayList<>();
        int tried = 0;
        for (int k = 1; k <= 14; k++) {
            for (int i = 0; i < lines; i++) {
                Primitive p = s.primitive(kind, 1, 1);
                Hit at = s.surfacePoint(p);
                if (at.face != AxialPrimitive.LATERAL) {
                    continue;
                }
                tried++;
                double clearance = (i % 2 == 0 ? 1 : -1) * Math.pow(10, -k) * 0.5;
                // Along a generator the line would run along the whole surface; any other tangent touches it.
                Vec3 d = s.leaning(at.normal(), 0);
                double size = RoundSamples.size(p);
                Vec3 o = at.point().plus(at.normal().times(clearance)).minus(d.times(10 * size));
                String verdict = RoundTruthTest.verdict(p, ExactSolid.of(p), o, d, size);
                if (verdict != null) {
                    wrong.add("k = " + k + ": " + verdict);
                }
            }
        }
        assertEquals(List.of(), wrong);
        assertTrue(tried > 14 * lines / 4, tried + " lines");
    }

    @ParameterizedTest
    @ValueSource(strings = {"sphere", "cylinder", "cone", "frustum", "flare"})
    void aUnitPrimitiveSeenFromFarAwayIsHitAsExactly(String kind) {
        hitFromAfar(kind, 20);
    }

    @Tag("full")
    @ParameterizedTest
    @ValueSource(strings = {"sphere", "cylinder", "cone", "frustum", "flare"})
    void aUnitPrimitiveSeenFromFarAwayIsHitByManyRaysAsExactly(String kind) {
        hitFromAfar(kind, 60);
    }

    private static void hitFromAfar(String kind, int rays) {
        RoundSamples s = new RoundSamples(13);
        for (double far : new double[] {1e3, 1e6, 1e9, 1e12}) {
            int hits = 0;
            for (int i = 0; i < rays; i++) {
                Primitive p = s.primitive(kind, 1, 0.5);
                Vec3 target = s.surfacePoint(p).point();
                Vec3 o = target.plus(s.direction().times(far));
                Vec3 d = target.plus(s.direction().times(0.3)).minus(o).times(1 / far);
                double size = RoundSamples.size(p);
                assertNull(RoundTruthTest.verdict(p, ExactSolid.of(p), o, d, size), kind + " from " + far);
                Hit hit = new Hit();
                if (!p.intersect(Ray.of(o, d), hit)) {
                    continue;
                }
                hits++;
                double ulp = IntersectionVectorsTest.pointUlp(p, hit.point());
                assertTrue(ExactSolid.of(p).distance(hit.point()) <= 8 * ulp);
                // Within the one rounding of the far coordinates, the point is on the ray too.
                double away = hit.point().minus(o).cross(d).length() / d.length();
                assertTrue(away <= 0x1p-51 * far, away + " off the ray from " + far);
            }
            assertTrue(hits > rays / 3, hits + " hits");
        }
    }

    @Test
    void aDiskSeenFromFarAwayIsHitInItsPlane() {
        RoundSamples s = new RoundSamples(14);
        for (double far : new double[] {1e3, 1e6, 1e9, 1e12}) {
            for (int i = 0; i < 300; i++) {
                DiskPrimitive p = (DiskPrimitive) s.primitive("disk", 1, 0.5);
                Vec3 o = p.center().plus(s.direction().times(far));
                Vec3 d = p.center().minus(o);
                Hit hit = new Hit();
                assertTrue(p.intersect(Ray.of(o, d), hit));
                assertEquals(1, hit.t, 1e-13);
                double ulp = IntersectionVectorsTest.pointUlp(p, hit.point());
                double off = Math.abs(hit.point().minus(p.center()).dot(p.normal()));
                assertTrue(off <= 8 * ulp, off + " off the plane");
            }
        }
    }
}
