package enlightenment.primitive;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.frame.SceneFrame;
import enlightenment.geometry.Mesh;
import enlightenment.geometry.Transform;
import enlightenment.math.ExactPoint;
import enlightenment.math.Vec3;
import enlightenment.mesh.TestMeshes;
import enlightenment.mesh.TriangleMesh;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;

/** Rays that leave a mesh without an offset. */
class MeshLeavingTest {
    private static final int FEW = 1_000;

    /** By name: how an instance is placed. */
    static Map<String, Transform> placings() {
        Map<String, Transform> all = new TreeMap<>();
        Transform.Step turn = new Transform.Rotate(new Vec3(20, 50, -70));
        Transform.Step stretch = new Transform.Scale(new Vec3(0.3, 2, 1.1));
        Transform.Step move = new Transform.Translate(ExactPoint.of(0.1, -3.7, 2.3));
        all.put("as it stands", Transform.IDENTITY);
        all.put("moved", Transform.of(move));
        all.put("turned", Transform.of(turn));
        all.put("stretched", Transform.of(stretch, turn, move));
        all.put("mirrored", Transform.of(new Transform.Scale(new Vec3(-1, 1, 1)), turn));
        all.put("tiny", Transform.of(turn, new Transform.Scale(new Vec3(1e-3, 1e-3, 1e-3)), move));
        all.put(
                "sheared",
                Transform.of(new Transform.Matrix(
                        new Vec3(1, 0.7, 0), new Vec3(0, 1, -0.4), new Vec3(0.2, 0, 1), ExactPoint.of(1, 2, 3))));
        all.put("far", Transform.of(turn, new Transform.Translate(ExactPoint.of(1e4, 2e4, -3e4))));
        return all;
    }

    static MeshPrimitive placed(TriangleMesh mesh, Transform transform) {
        return (MeshPrimitive) Primitives.place(Mesh.of(mesh, transform), SceneFrame.WORLD);
    }

    /** Closed convex meshes: of floats, of doubles, with slivers, and one that is not around its origin. */
    private static Map<String, TriangleMesh> convex() {
        Map<String, TriangleMesh> all = new TreeMap<>();
        all.put("cube", TestMeshes.cube());
        all.put("ball", TestMeshes.icosphere(2));
        all.put("off", TestMeshes.moved(TestMeshes.icosphere(1), false, v -> v.plus(new Vec3(100.1, 30, 0.7))));
        all.put("flat", TestMeshes.moved(TestMeshes.icosphere(2), false, v -> new Vec3(v.x(), 1e-4 * v.y(), v.z())));
        all.put("long", TestMeshes.moved(TestMeshes.cube(), false, v -> new Vec3(1e5 * v.x() - 5e4, v.y(), v.z())));
        return all;
    }

    @Test
    void noRayThatLeavesAConvexMeshOutwardsMeetsItAndEveryOtherDoes() {
        check(FEW);
    }

    @Test
    @Tag("full")
    void noneOfManyRaysThatLeaveAConvexMeshMeetsIt() {
        check(200_000);
    }

    private static void check(int rays) {
        List<String> wrong = new ArrayList<>();
        placings().forEach((how, transform) -> convex().forEach((name, mesh) -> {
            MeshPrimitive placed = placed(mesh, transform);
            RandomRays random = new RandomRays(5);
            int outwards = 0;
            int inwards = 0;
            for (int k = 0; k < rays; k++) {
                Hit hit = hitFromOutside(mesh, placed, transform, random, k);
                if (hit == null) {
                    continue;
                }
                Vec3 n = hit.normal();
                double least = isNextToCorner(hit) ? -3 : -9;
                double cosine = k % 3 == 0 ? Math.abs(random.decade(least, -1)) : random.uniform();
                Vec3 out = random.leaving(n, cosine);
                Ray away = new Ray()
                        .set(hit.px, hit.py, hit.pz, out.x(), out.y(), out.z(), 0)
                        .from(hit, Ray.OUTSIDE);
                outwards += placed.nearest(away, Double.MAX_VALUE) < Primitive.MISS ? 1 : 0;
                Ray in = new Ray()
                        .set(hit.px, hit.py, hit.pz, -out.x(), -out.y(), -out.z(), 0)
                        .from(hit, Ray.INSIDE);
                inwards += placed.nearest(in, Double.MAX_VALUE) < Primitive.MISS ? 0 : 1;
            }
            if (outwards + inwards > 0) {
                wrong.add(name + ", " + how + ": " + outwards + " met, " + inwards + " missed");
            }
        }));
        assertEquals(List.of(), wrong);
    }

    /**
     * Next to a corner, but not so near that the origin is taken to be the corner: of triangles that share only that one, rays almost in the
     * plane can find the wrong one.
     */
    private static boolean isNextToCorner(Hit hit) {
        double a = 1 - hit.weightB - hit.weightC;
        return Math.max(a, Math.max(hit.weightB, hit.weightC)) > 1 - 1e-8;
    }

    /** A hit at an inner point, near or on an edge, or at a vertex; null if roundings let the ray pass beside. */
    private static Hit hitFromOutside(
            TriangleMesh mesh, MeshPrimitive placed, Transform transform, RandomRays random, int k) {
        int t = random.index(mesh.triangles());
        double b = k % 4 == 0 ? 0 : k % 4 == 1 ? Math.abs(random.decade(-17, -3)) : random.uniform();
        double c = k % 8 == 0 ? 0 : (1 - b) * random.uniform();
        Vec3 p = mesh.position(mesh.vertex(t, 0));
        Vec3 at = p.plus(mesh.position(mesh.vertex(t, 1)).minus(p).times(b))
                .plus(mesh.position(mesh.vertex(t, 2)).minus(p).times(c));
        Vec3 to = world(transform, at);
        Vec3 from = to.plus(random.direction().times(3));
        if (placed.contains(from.x(), from.y(), from.z())) {
            return null;
        }
        Hit hit = new Hit();
        return placed.intersect(Ray.of(from, to.minus(from)), hit) && hit.side == Ray.OUTSIDE ? hit : null;
    }

    static Vec3 world(Transform transform, Vec3 v) {
        ExactPoint p = transform.apply(v);
        return new Vec3(p.x().doubleValue(), p.y().doubleValue(), p.z().doubleValue());
    }

    /** A valley of two triangles with the edge from (0, 0, 0) to (1, 0, 0), in which a slope of the second one is given. */
    private static TriangleMesh valley(double y, double z, boolean turned) {
        Vec3[] v = {Vec3.ZERO, Vec3.X, new Vec3(0.4, -1, 0), new Vec3(0.3, y, z)};
        return turned ? TestMeshes.of(v, 0, 2, 1, 0, 3, 1) : TestMeshes.of(v, 0, 2, 1, 0, 1, 3);
    }

    /** From next to the edge, towards the slope or away from it: whatever roundings are, and whichever way the slope is turned. */
    @Test
    void aRayFromTheEdgeOfAValleyIsBlockedByTheSlopeThatItTurnsToAndByNothingElse() {
        List<String> wrong = new ArrayList<>();
        placings().forEach((how, transform) -> {
            for (boolean turned : new boolean[] {false, true}) {
                for (double[] slope : new double[][] {{1, 1}, {0, 1}, {-0.9, 0.5}, {1, 1e-6}, {1, -1}, {1, 0}}) {
                    TriangleMesh mesh = valley(slope[0], slope[1], turned);
                    String what = how + ", " + slope[0] + ", " + slope[1] + (turned ? ", turned" : "");
                    checkValley(mesh, transform, slope, what, wrong);
                }
            }
        });
        assertEquals(List.of(), wrong);
    }

    private static void checkValley(
            TriangleMesh mesh, Transform transform, double[] slope, String what, List<String> wrong) {
        MeshPrimitive placed = placed(mesh, transform);
        RandomRays random = new RandomRays(7);
        int missed = 0;
        int met = 0;
        // Towards the slope, which is met; from its plane, away from it.
        Vec3 across = new Vec3(0, slope[0], slope[1]).normalized();
        Vec3 up = new Vec3(0, -slope[1], slope[0]).normalized();
        for (int k = 0; k < 400; k++) {
            double x = 0.2 + 0.3 * random.uniform();
            double y = k % 2 == 0 ? 0 : -Math.abs(random.decade(-18, -12));
            Vec3 at = new Vec3(x, y, 0);
            Vec3 local = up.times(random.uniform() + 0.05)
                    .plus(across.times(random.signed()))
                    .plus(Vec3.X.times(random.signed()));
            boolean isUp = local.z() > 0;
            if (!isUp) {
                continue;
            }
            Vec3 from = world(transform, at.plus(new Vec3(0.1, -0.3, 0.8)));
            Vec3 to = world(transform, at);
            Hit hit = new Hit();
            if (!placed.intersect(Ray.of(from, to.minus(from)), hit) || hit.element != 0) {
                continue;
            }
            // The direction away from the slope is above both planes.
            Vec3 d = transform.applyLinear(local);
            Ray away = new Ray()
                    .set(hit.px, hit.py, hit.pz, d.x(), d.y(), d.z(), 0)
                    .from(hit, hit.side);
            met += placed.nearest(away, Double.MAX_VALUE) < Primitive.MISS ? 1 : 0;
            if (slope[1] <= 0) {
                continue;
            }
            // Between the slope's plane and that of the triangle.
            double part = 0.05 + 0.9 * random.uniform();
            Vec3 below = across.times(part).plus(Vec3.Y.times(1 - part));
            below = below.z() > 0 ? below : across.plus(Vec3.Y.times(0.5));
            d = transform.applyLinear(below.plus(Vec3.X.times(0.2 * random.signed())));
            Ray towards = new Ray()
                    .set(hit.px, hit.py, hit.pz, d.x(), d.y(), d.z(), 0)
                    .from(hit, hit.side);
            missed += placed.nearest(towards, Double.MAX_VALUE) < Primitive.MISS ? 0 : 1;
        }
        if (met + missed > 0) {
            wrong.add(what + ": " + met + " met, " + missed + " missed");
        }
    }

    /** Whatever is cut out of a plane lies in one surface. */
    @Test
    void trianglesOfOnePlaneDoNotShadowEachOther() {
        List<String> wrong = new ArrayList<>();
        placings().forEach((how, transform) -> {
            for (double z : new double[] {0, 0.1}) {
                TriangleMesh mesh = TestMeshes.moved(TestMeshes.grid(5), false, v -> new Vec3(v.x(), v.y(), z));
                MeshPrimitive placed = placed(mesh, transform);
                RandomRays random = new RandomRays(9);
                int met = 0;
                for (int k = 0; k < FEW; k++) {
                    Vec3 at = new Vec3(
                            k % 3 == 0 ? 0.2 : 0.9 * random.signed(), k % 2 == 0 ? -0.6 : 0.9 * random.signed(), z);
                    Vec3 from = world(transform, at.plus(new Vec3(random.signed(), random.signed(), 1)));
                    Hit hit = new Hit();
                    assertTrue(
                            placed.intersect(Ray.of(from, world(transform, at).minus(from)), hit));
                    for (int side = -1; side <= 1; side += 2) {
                        Vec3 d = random.leaving(hit.normal().times(side), Math.abs(random.decade(-12, 0)));
                        Ray ray = new Ray()
                                .set(hit.px, hit.py, hit.pz, d.x(), d.y(), d.z(), 0)
                                .from(hit, side);
                        met += placed.blocks(ray, Double.MAX_VALUE) ? 1 : 0;
                    }
                }
                if (met > 0) {
                    wrong.add(how + " at " + z + ": " + met);
                }
            }
        });
        assertEquals(List.of(), wrong);
    }

    /** Meshes have triangles twice, once for each side. */
    @Test
    void aTriangleThatIsThereTwiceDoesNotShadowItself() {
        Vec3[] v = {new Vec3(0.1, 0.2, 0.3), new Vec3(1.1, 0.3, 0.2), new Vec3(0.2, 0.9, 0.7)};
        MeshPrimitive both =
                placed(TestMeshes.of(v, 0, 1, 2, 0, 2, 1), placings().get("turned"));
        RandomRays random = new RandomRays(4);
        Vec3 to = world(placings().get("turned"), v[0].plus(v[1]).plus(v[2]).times(1 / 3.0));
        for (int k = 0; k < FEW; k++) {
            Vec3 from = to.plus(random.direction());
            Hit hit = new Hit();
            assertTrue(both.intersect(Ray.of(from, to.minus(from)), hit));
            Vec3 d = random.leaving(hit.normal().times(hit.side), random.uniform());
            assertFalse(both.blocks(
                    new Ray()
                            .set(hit.px, hit.py, hit.pz, d.x(), d.y(), d.z(), 0)
                            .from(hit, hit.side),
                    1e9));
        }
    }
}
