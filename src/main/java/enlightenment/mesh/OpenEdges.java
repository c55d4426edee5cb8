package enlightenment.mesh;

import java.util.Arrays;

/** Counts the edges of a mesh along which not as many triangles run one way as the other way. Triangles without an area count: they close gaps. */
final class OpenEdges {
    final long count;

    OpenEdges(TriangleMesh mesh) {
        int[] place = new Welding(mesh).first;
        int[] kept = mesh.data().indices;
        int[] flat = mesh.data().withoutArea;
        long[] edges = new long[kept.length + flat.length];
        add(kept, place, edges, 0);
        add(flat, place, edges, kept.length);
        Arrays.sort(edges);
        count = open(edges);
    }

    private static void add(int[] indices, int[] place, long[] edges, int at) {
        for (int i = 0; i < indices.length; i += 3) {
            for (int k = 0; k < 3; k++) {
                edges[at + i + k] = key(place[indices[i + k]], place[indices[i + (k + 1) % 3]]);
            }
        }
    }

    /** The two ends, the lower one first, and in the last bit whether the edge runs from the higher to the lower. */
    private static long key(int from, int to) {
        long low = Math.min(from, to);
        long high = Math.max(from, to);
        return low << 32 | high << 1 | (from > to ? 1 : 0);
    }

    private static long open(long[] edges) {
        long open = 0;
        for (int i = 0; i < edges.length; ) {
            int end = i + 1;
            while (end < edges.length && edges[end] >>> 1 == edges[i] >>> 1) {
                end++;
            }
            int turned = 0;
            for (int k = i; k < end; k++) {
                turned += (int) (edges[k] & 1);
            }
            // An edge from a place to the same place bounds nothing.
            boolean isPoint = edges[i] >>> 32 == (edges[i] & 0xffffffffL) >>> 1;
            open += isPoint || 2 * turned == end - i ? 0 : 1;
            i = end;
        }
        return open;
    }
}
