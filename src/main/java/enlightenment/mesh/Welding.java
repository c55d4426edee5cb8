package enlightenment.mesh;

import java.util.Arrays;

/** Numbers the places where a mesh has vertices: several vertices in one place have one number. */
final class Welding {
    /** By vertex: the first vertex in its place. */
    final int[] first;

    Welding(TriangleMesh mesh) {
        int n = mesh.vertices();
        first = new int[n];
        int capacity = Integer.highestOneBit(Math.max(2, n)) << 1;
        int[] table = new int[capacity];
        Arrays.fill(table, -1);
        for (int v = 0; v < n; v++) {
            int slot = hash(mesh, v) & capacity - 1;
            while (table[slot] >= 0 && !mesh.data().vertices.areInOnePlace(table[slot], v)) {
                slot = slot + 1 & capacity - 1;
            }
            if (table[slot] < 0) {
                table[slot] = v;
            }
            first[v] = table[slot];
        }
    }

    /** Minus zero hashes as zero does. */
    private static int hash(TriangleMesh mesh, int v) {
        long h = 0;
        for (int axis = 0; axis < 3; axis++) {
            h = (h ^ Double.doubleToLongBits(mesh.coordinate(v, axis) + 0.0)) * 0x9E3779B97F4A7C15L;
            h ^= h >>> 32;
        }
        return (int) (h ^ h >>> 17);
    }
}
