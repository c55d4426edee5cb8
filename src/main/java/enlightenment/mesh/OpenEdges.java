package enlightenment.mesh;

import java.util.Arrays;

/** Counts the edges of a mesh that do not have one triangle on each side. */
final class OpenEdges {
    final long count;

    OpenEdges(TriangleMesh mesh) {
        int[] place = new Welding(mesh).first;
        int n = mesh.triangles();
        long[] edges = new long[3 * n];
        for (int t = 0; t < n; t++) {
            for (int k = 0; k < 3; k++) {
                edges[3 * t + k] = key(place[mesh.vertex(t, k)], place[mesh.vertex(t, (k + 1) % 3)]);
            }
        }
        Arrays.sort(edges);
        count = open(edges);
    }

    /** The two ends, the lower one first, and in the last bit whether the edge runs from the higher to the lower. */
    private static long key(int from, int to) {
        long low = Math.min(from, to);
        long high = Math.max(from, to);
        return low << 32 | high << 1 & 0xffffffffL | (from > to ? 1 : 0);
    }

    private static long open(long[] edges) {
        long open = 0;
        for (int i = 0; i < edges.length; ) {
            int end = i + 1;
            while (end < edges.length && edges[end] >>> 1 == edges[i] >>> 1) {
                end++;
            }
            boolean isClosed = end == i + 2 && edges[i] != edges[i + 1];
            open += isClosed ? 0 : 1;
            i = end;
        }
        return open;
    }
}
