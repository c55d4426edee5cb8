package enlightenment.mesh;

import enlightenment.math.Vec3;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.SplittableRandom;
import java.util.function.UnaryOperator;
import java.util.stream.IntStream;

/** Meshes that tests of several packages share. */
public final class TestMeshes {
    private TestMeshes() {}

    /** A mesh of these vertices and triangles. */
    public static TriangleMesh of(Vec3[] vertices, int... indices) {
        double[] p = new double[3 * vertices.length];
        for (int i = 0; i < vertices.length; i++) {
            p[3 * i] = vertices[i].x();
            p[3 * i + 1] = vertices[i].y();
            p[3 * i + 2] = vertices[i].z();
        }
        return TriangleMesh.of(p, indices);
    }

    /** The unit ball as an icosahedron, cut n times: 20·4^n triangles, each vertex on the sphere. */
    public static TriangleMesh icosphere(int cuts) {
        List<Vec3> vertices = new ArrayList<>();
        double g = (1 + Math.sqrt(5)) / 2;
        for (int i = 0; i < 4; i++) {
            double one = (i & 1) == 0 ? -1 : 1;
            double golden = (i & 2) == 0 ? -g : g;
            vertices.add(new Vec3(0, one, golden).normalized());
            vertices.add(new Vec3(one, golden, 0).normalized());
            vertices.add(new Vec3(golden, 0, one).normalized());
        }
        List<int[]> faces = icosahedron(vertices);
        for (int i = 0; i < cuts; i++) {
            faces = cut(vertices, faces);
        }
        int[] indices = faces.stream().flatMapToInt(IntStream::of).toArray();
        return of(vertices.toArray(Vec3[]::new), indices);
    }

    /** {@link #icosphere} with the normals of the sphere. */
    public static TriangleMesh ball(int cuts) {
        TriangleMesh mesh = icosphere(cuts);
        float[] normals = new float[3 * mesh.vertices()];
        for (int i = 0; i < normals.length; i++) {
            normals[i] = (float) mesh.coordinate(i / 3, i % 3);
        }
        return mesh.withNormals(normals);
    }

    private static List<int[]> icosahedron(List<Vec3> v) {
        List<int[]> faces = new ArrayList<>();
        for (int a = 0; a < 12; a++) {
            for (int b = a + 1; b < 12; b++) {
                for (int c = b + 1; c < 12; c++) {
                    if (near(v, a, b) && near(v, b, c) && near(v, c, a)) {
                        boolean out = v.get(b)
                                        .minus(v.get(a))
                                        .cross(v.get(c).minus(v.get(a)))
                                        .dot(v.get(a))
                                > 0;
                        faces.add(out ? new int[] {a, b, c} : new int[] {a, c, b});
                    }
                }
            }
        }
        return faces;
    }

    private static boolean near(List<Vec3> v, int a, int b) {
        return v.get(a).minus(v.get(b)).length() < 1.2;
    }

    private static List<int[]> cut(List<Vec3> v, List<int[]> faces) {
        Map<Long, Integer> middles = new HashMap<>();
        List<int[]> smaller = new ArrayList<>();
        for (int[] f : faces) {
            int[] m = new int[3];
            for (int k = 0; k < 3; k++) {
                int a = f[k];
                int b = f[(k + 1) % 3];
                m[k] = middles.computeIfAbsent((long) Math.min(a, b) << 32 | Math.max(a, b), key -> {
                    v.add(v.get(a).plus(v.get(b)).normalized());
                    return v.size() - 1;
                });
            }
            smaller.add(new int[] {f[0], m[0], m[2]});
            smaller.add(new int[] {m[0], f[1], m[1]});
            smaller.add(new int[] {m[2], m[1], f[2]});
            smaller.add(new int[] {m[0], m[1], m[2]});
        }
        return smaller;
    }

    /** The box from 0 to 1 in all coordinates, closed, of twelve triangles. */
    public static TriangleMesh cube() {
        Vec3[] v = new Vec3[8];
        for (int i = 0; i < 8; i++) {
            v[i] = new Vec3(i & 1, i >> 1 & 1, i >> 2);
        }
        return of(
                v, 0, 2, 3, 0, 3, 1, 4, 5, 7, 4, 7, 6, 0, 1, 5, 0, 5, 4, 2, 6, 7, 2, 7, 3, 0, 4, 6, 0, 6, 2, 1, 3, 7, 1,
                7, 5);
    }

    /** A closed tetrahedron. */
    public static TriangleMesh tetrahedron() {
        return of(new Vec3[] {Vec3.ZERO, Vec3.X, Vec3.Y, Vec3.Z}, 0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3);
    }

    /** Triangles in no order at all, in the cube from −1 to 1. */
    public static TriangleMesh soup(int triangles, double size, long seed) {
        SplittableRandom random = new SplittableRandom(seed);
        Vec3[] v = new Vec3[3 * triangles];
        int[] indices = new int[v.length];
        for (int i = 0; i < v.length; i++) {
            Vec3 any = new Vec3(signed(random), signed(random), signed(random));
            v[i] = i % 3 == 0 ? any : v[i - i % 3].plus(any.times(size));
            indices[i] = i;
        }
        return of(v, indices);
    }

    private static double signed(SplittableRandom random) {
        return 2 * random.nextDouble() - 1;
    }

    /** A square of 2·n·n triangles in the plane z = 0, from −1 to 1, with its outside towards +z. */
    public static TriangleMesh grid(int n) {
        Vec3[] v = new Vec3[(n + 1) * (n + 1)];
        List<Integer> indices = new ArrayList<>();
        for (int i = 0; i < v.length; i++) {
            int x = i % (n + 1);
            int y = i / (n + 1);
            v[i] = new Vec3(2.0 * x / n - 1, 2.0 * y / n - 1, 0);
            if (x < n && y < n) {
                indices.addAll(List.of(i, i + 1, i + n + 2, i, i + n + 2, i + n + 1));
            }
        }
        return of(v, indices.stream().mapToInt(i -> i).toArray());
    }

    /** A mesh with its vertices elsewhere, in doubles; what runs against the clock from outside does so still if the map mirrors. */
    public static TriangleMesh moved(TriangleMesh mesh, boolean mirrors, UnaryOperator<Vec3> map) {
        Vec3[] v = new Vec3[mesh.vertices()];
        for (int i = 0; i < v.length; i++) {
            v[i] = map.apply(mesh.position(i));
        }
        int[] indices = new int[3 * mesh.triangles()];
        for (int i = 0; i < indices.length; i++) {
            int corner = i % 3;
            indices[i] = mesh.vertex(i / 3, mirrors ? (3 - corner) % 3 : corner);
        }
        return of(v, indices);
    }

    /** A mesh times a number. */
    public static TriangleMesh times(TriangleMesh mesh, double factor) {
        return moved(mesh, false, v -> v.times(factor));
    }
}
