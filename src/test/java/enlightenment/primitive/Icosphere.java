package enlightenment.primitive;

import enlightenment.math.Vec3;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;

/** A closed mesh: an icosahedron, each triangle cut into four again and again, its vertices displaced at random. */
final class Icosphere {
    private static final double DISPLACEMENT = 0.1;

    private final List<Vec3> vertices = new ArrayList<>();
    private final int[][] triangles;

    Icosphere(RandomRays random, int cuts) {
        double g = (1 + Math.sqrt(5)) / 2;
        for (int i = 0; i < 4; i++) {
            double one = (i & 1) == 0 ? -1 : 1;
            double golden = (i & 2) == 0 ? -g : g;
            vertices.add(new Vec3(0, one, golden).normalized());
            vertices.add(new Vec3(one, golden, 0).normalized());
            vertices.add(new Vec3(golden, 0, one).normalized());
        }
        int[][] faces = icosahedron();
        for (int i = 0; i < cuts; i++) {
            faces = cut(faces);
        }
        triangles = faces;
        vertices.replaceAll(v -> v.times(1 + DISPLACEMENT * random.signed()));
    }

    /** All triples of vertices that are each other's neighbours. */
    private int[][] icosahedron() {
        List<int[]> faces = new ArrayList<>();
        for (int a = 0; a < 12; a++) {
            for (int b = a + 1; b < 12; b++) {
                for (int c = b + 1; c < 12; c++) {
                    if (neighbours(a, b) && neighbours(b, c) && neighbours(c, a)) {
                        faces.add(new int[] {a, b, c});
                    }
                }
            }
        }
        return faces.toArray(new int[0][]);
    }

    private boolean neighbours(int a, int b) {
        return vertices.get(a).minus(vertices.get(b)).length() < 1.2;
    }

    private int[][] cut(int[][] faces) {
        Map<Long, Integer> middles = new HashMap<>();
        List<int[]> smaller = new ArrayList<>();
        for (int[] f : faces) {
            int ab = middle(middles, f[0], f[1]);
            int bc = middle(middles, f[1], f[2]);
            int ca = middle(middles, f[2], f[0]);
            smaller.add(new int[] {f[0], ab, ca});
            smaller.add(new int[] {ab, f[1], bc});
            smaller.add(new int[] {ca, bc, f[2]});
            smaller.add(new int[] {ab, bc, ca});
        }
        return smaller.toArray(new int[0][]);
    }

    private int middle(Map<Long, Integer> middles, int a, int b) {
        long key = (long) Math.min(a, b) << 32 | Math.max(a, b);
        return middles.computeIfAbsent(key, k -> {
            vertices.add(vertices.get(a).plus(vertices.get(b)).normalized());
            return vertices.size() - 1;
        });
    }

    int[][] triangles() {
        return triangles;
    }

    Vec3[] shiftedVertices(Vec3 by) {
        return vertices.stream().map(by::plus).toArray(Vec3[]::new);
    }

    TrianglePrimitive[] shifted(Vec3 by) {
        Vec3[] v = shiftedVertices(by);
        TrianglePrimitive[] all = new TrianglePrimitive[triangles.length];
        for (int i = 0; i < all.length; i++) {
            int[] f = triangles[i];
            all[i] = new TrianglePrimitive(v[f[0]], v[f[1]], v[f[2]]);
        }
        return all;
    }
}
