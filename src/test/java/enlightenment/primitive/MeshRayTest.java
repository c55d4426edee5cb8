package enlightenment.primitive;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.math.Vec3;
import enlightenment.mesh.TestMeshes;
import enlightenment.mesh.TriangleMesh;
import enlightenment.mesh.tree.MeshRay;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;

/** A ray finds in the hierarchy of a mesh what it finds among all its triangles, one by one. */
class MeshRayTest {
    private static final int FEW = 1_500;

    /** By name: a mesh in the cube from −1 to 1. */
    static Map<String, TriangleMesh> meshes() {
        Map<String, TriangleMesh> all = new TreeMap<>();
        all.put("soup", TestMeshes.soup(300, 0.3, 1));
        all.put("dust", TestMeshes.soup(500, 1e-3, 2));
        all.put(
                "slivers",
                TestMeshes.moved(TestMeshes.soup(200, 1, 3), false, v -> new Vec3(v.x(), v.y(), 1e-7 * v.z())));
        all.put("ball", TestMeshes.icosphere(2));
        all.put("grid", TestMeshes.grid(8));
        all.put("grid on its side", TestMeshes.moved(TestMeshes.grid(7), false, v -> new Vec3(0.25, v.x(), v.y())));
        all.put("cube", TestMeshes.cube());
        all.put("one triangle", TestMeshes.of(new Vec3[] {Vec3.X, Vec3.Y, Vec3.Z}, 0, 1, 2));
        // Floats, where the others are doubles.
        all.put(
                "coarse soup",
                TestMeshes.moved(
                        TestMeshes.soup(300, 0.5, 4),
                        false,
                        v -> new Vec3((float) v.x(), (float) v.y(), (float) v.z())));
        return all;
    }

    @Test
    void itFindsWhatALoopOverTheTrianglesFinds() {
        compare(FEW);
    }

    @Test
    @Tag("full")
    void itFindsInManyTriesWhatALoopFinds() {
        compare(100_000);
    }

    private static void compare(int rays) {
        meshes().forEach((name, mesh) -> {
            for (double size : new double[] {1, 1e-25, 1e25}) {
                compare(name + " of size " + size, TestMeshes.times(mesh, size), size, size == 1 ? rays : rays / 10);
            }
        });
    }

    private static void compare(String name, TriangleMesh mesh, double size, int rays) {
        List<TriangleMesh> single = single(mesh);
        RandomRays random = new RandomRays(11);
        MeshRay ray = new MeshRay();
        int met = 0;
        for (int k = 0; k < rays; k++) {
            Vec3 to = aim(mesh, random, k);
            Vec3 from = from(random, k, to, size);
            Vec3 d = direction(random, k, to.minus(from));
            double tMax = random.index(3) == 0 ? 2 * random.uniform() : Double.MAX_VALUE;
            String what = name + ", ray " + k + " from " + from + " along " + d;
            int best = -1;
            double t = MeshRay.MISS;
            int side = 0;
            for (int i = 0; i < single.size(); i++) {
                ray.set(single.get(i), from.x(), from.y(), from.z(), d.x(), d.y(), d.z(), 0);
                // At equal t what leaves comes first, then the lower number.
                if (ray.closest(tMax) && (ray.t < t || ray.t == t && ray.side < side)) {
                    t = ray.t;
                    best = i;
                    side = ray.side;
                }
            }
            ray.set(mesh, from.x(), from.y(), from.z(), d.x(), d.y(), d.z(), 0);
            assertEquals(best >= 0, ray.isBlocked(tMax), what);
            assertEquals(best >= 0, ray.closest(tMax), what);
            if (best >= 0) {
                assertEquals(best, ray.triangle, what);
                assertEquals(t, ray.t, what);
                assertEquals(side, ray.side, what);
                met++;
            }
        }
        assertTrue(met > rays / 20 && met < rays, name + ": " + met);
    }

    /** Each triangle as a mesh of its own. */
    private static List<TriangleMesh> single(TriangleMesh mesh) {
        return IntStream.range(0, mesh.triangles())
                .mapToObj(t -> TestMeshes.of(
                        new Vec3[] {
                            mesh.position(mesh.vertex(t, 0)),
                            mesh.position(mesh.vertex(t, 1)),
                            mesh.position(mesh.vertex(t, 2))
                        },
                        0,
                        1,
                        2))
                .toList();
    }

    /** Any point near the mesh, a vertex, or a point of an edge. */
    private static Vec3 aim(TriangleMesh mesh, RandomRays random, int k) {
        int t = random.index(mesh.triangles());
        Vec3 a = mesh.position(mesh.vertex(t, 0));
        Vec3 b = mesh.position(mesh.vertex(t, 1));
        Vec3 c = mesh.position(mesh.vertex(t, 2));
        return switch (k % 4) {
            case 0 -> a;
            case 1 -> a.plus(b.minus(a).times(random.index(9) / 8.0));
            case 2 -> a.plus(b.minus(a).times(random.uniform())).plus(c.minus(a).times(random.uniform()));
            default -> random.inCube().times(mesh.maxAbs());
        };
    }

    /** From next to the mesh, from within it, and from a million times its size away. */
    private static Vec3 from(RandomRays random, int k, Vec3 to, double size) {
        double far = k % 5 == 0 ? 1e6 : k % 5 == 1 ? 1e-6 : 2;
        Vec3 from = k % 5 == 2 ? to : Vec3.ZERO;
        return from.plus(random.inCube().times(far * size));
    }

    /** Of any length, and sometimes parallel to an axis or a plane of two. */
    private static Vec3 direction(RandomRays random, int k, Vec3 d) {
        Vec3 v = d.scaledBy(-d.exponent() + random.index(5));
        return switch (k % 7) {
            case 0 -> new Vec3(v.x(), v.y(), 0);
            case 1 -> new Vec3(0, v.y(), v.z());
            case 2 -> List.of(Vec3.X, Vec3.Y, Vec3.Z).get(random.index(3)).times(random.index(2) == 0 ? 1 : -3);
            default -> v;
        };
    }

    /** Both shear vertices alike; a triangle's plane is through its first corner in both, relative to the origin in the mesh. */
    @Test
    void itFindsTheTriangleThatIsAPrimitiveOfItsOwn() {
        meshes().forEach((name, mesh) -> {
            TrianglePrimitive[] triangles = new TrianglePrimitive[mesh.triangles()];
            for (int i = 0; i < triangles.length; i++) {
                triangles[i] = new TrianglePrimitive(
                        mesh.position(mesh.vertex(i, 0)),
                        mesh.position(mesh.vertex(i, 1)),
                        mesh.position(mesh.vertex(i, 2)));
            }
            RandomRays random = new RandomRays(12);
            for (int k = 0; k < FEW; k++) {
                Vec3 from = random.inCube().times(3);
                Vec3 to = aim(mesh, random, 2);
                Vec3 d = to.minus(from);
                double t = Primitive.MISS;
                int best = -1;
                for (int i = 0; i < triangles.length; i++) {
                    double s = triangles[i].nearest(Ray.of(from, d), Double.MAX_VALUE);
                    if (s < t) {
                        t = s;
                        best = i;
                    }
                }
                MeshRay ray = new MeshRay().set(mesh, from.x(), from.y(), from.z(), d.x(), d.y(), d.z(), 0);
                String what = name + ", ray " + k;
                assertEquals(best >= 0, ray.closest(Double.MAX_VALUE), what);
                if (best >= 0) {
                    // In a plane that is met at a cosine c roundings of coordinates become 1/c of them.
                    Vec3 n = mesh.areaNormal(ray.triangle).normalized();
                    double cosine = Math.abs(n.dot(d.normalized()));
                    assertEquals(t, ray.t, 64 * Math.ulp(4.0) / cosine, what);
                    boolean sameTriangle = best == ray.triangle;
                    assertTrue(sameTriangle || name.equals("slivers") || Math.abs(t - ray.t) <= Math.ulp(4.0), what);
                }
            }
        });
    }

    @Test
    void aClosedMeshHasNoGap() {
        checkClosed(100_000);
    }

    @Test
    @Tag("full")
    void aClosedMeshHasNoGapForManyRays() {
        checkClosed(3_000_000);
    }

    private static void checkClosed(int rays) {
        Icosphere rough = new Icosphere(new RandomRays(17), 3);
        int[] indices =
                Arrays.stream(rough.triangles()).flatMapToInt(Arrays::stream).toArray();
        for (double shift : new double[] {0, 1e6}) {
            Vec3 center = new Vec3(shift, -shift, shift / 3);
            checkClosed(TestMeshes.of(rough.shiftedVertices(center), indices), center, rays / 4, false);
            TriangleMesh convex = TestMeshes.moved(TestMeshes.icosphere(3), false, center::plus);
            checkClosed(convex, center, rays / 4, true);
        }
    }

    private static void checkClosed(TriangleMesh mesh, Vec3 center, int rays, boolean isConvex) {
        RandomRays random = new RandomRays(18);
        MeshRay ray = new MeshRay();
        for (int k = 0; k < rays; k++) {
            Vec3 from = center.plus(random.inCube().times(0.4));
            Vec3 d = aim(mesh, random, k % 2).minus(from);
            ray.set(mesh, from.x(), from.y(), from.z(), d.x(), d.y(), d.z(), 0);
            String what = "ray " + k + " from " + from;
            assertTrue(ray.closest(Double.MAX_VALUE) && ray.isBlocked(Double.MAX_VALUE), what);
            if (isConvex) {
                // The roundings of vertices at 1e6, next to the curved silhouette.
                assertEquals(1, ray.t, 1e-8, what);
                assertEquals(-1, ray.side, what);
            }
        }
    }

    /** A ray in the plane of a grid is seen edge-on by all its triangles. */
    @Test
    void aRayInThePlaneOfTrianglesMeetsNone() {
        TriangleMesh mesh = TestMeshes.grid(4);
        MeshRay ray = new MeshRay();
        RandomRays random = new RandomRays(3);
        for (int k = 0; k < 1_000; k++) {
            ray.set(mesh, 3 * random.signed(), 3 * random.signed(), 0, random.signed(), random.signed(), 0, 0);
            assertTrue(!ray.closest(Double.MAX_VALUE) && !ray.isBlocked(Double.MAX_VALUE));
        }
    }

    @Test
    void weightsAreThoseOfThePointThatIsMet() {
        TriangleMesh mesh = TestMeshes.soup(100, 0.5, 5);
        RandomRays random = new RandomRays(6);
        MeshRay ray = new MeshRay();
        for (int k = 0; k < 2_000; k++) {
            int t = random.index(100);
            double b = random.uniform();
            double c = (1 - b) * random.uniform();
            Vec3 p = mesh.position(mesh.vertex(t, 0));
            Vec3 q = mesh.position(mesh.vertex(t, 1));
            Vec3 r = mesh.position(mesh.vertex(t, 2));
            Vec3 to = p.plus(q.minus(p).times(b)).plus(r.minus(p).times(c));
            Vec3 from = random.inCube().times(4);
            Vec3 d = to.minus(from);
            Vec3 n = mesh.areaNormal(t);
            if (Math.abs(n.normalized().dot(d.normalized())) < 0.01 || n.length() < 1e-3) {
                continue;
            }
            ray.set(mesh, from.x(), from.y(), from.z(), d.x(), d.y(), d.z(), 1 - 1e-9);
            assertTrue(ray.closest(1 + 1e-9));
            if (ray.triangle == t) {
                ray.complete(t);
                assertEquals(b, ray.weightB, 1e-9);
                assertEquals(c, ray.weightC, 1e-9);
            }
        }
    }
}
