package enlightenment.mesh;

import java.util.Arrays;

/**
 * The edges of a mesh along which not as many triangles run one way as the other way: their number and, of few, their ends. Triangles without an
 * area count: they close gaps.
 */
final class OpenEdges {
    /** Of more open edges than this, or of one that two triangles lack, the ends are not kept. */
    private static final int MOST_KEPT = 4096;

    final long count;

    /**
     * The first vertices in the places of the ends of open edges, in the direction in which one triangle more runs than the other way; none if they
     * were not kept.
     */
    int[] from = {};

    int[] to = {};

    OpenEdges(TriangleMesh mesh) {
        int[] place = new Welding(mesh).first;
        int[] kept = mesh.data().indices;
        int[] flat = mesh.data().withoutArea;
        long[] edges = new long[kept.length + flat.length];
        add(kept, place, edges, 0);
        add(flat, place, edges, kept.length);
        Arrays.sort(edges);
        count = open(edges);
        if (count > 0 && count <= MOST_KEPT) {
            keep(edges);
        }
    }

    private void keep(long[] edges) {
        from = new int[(int) count];
        to = new int[(int) count];
        int kept = 0;
        for (int i = 0, end; i < edges.length; i = end) {
            end = endOfEdge(edges, i);
            int surplus = 2 * turned(edges, i, end) - (end - i);
            if (isPoint(edges[i]) || surplus == 0) {
                continue;
            }
            if (Math.abs(surplus) > 1) {
                from = new int[0];
                to = new int[0];
                return;
            }
            int low = (int) (edges[i] >>> 32);
            int high = (int) ((edges[i] & 0xffffffffL) >>> 1);
            from[kept] = surplus > 0 ? high : low;
            to[kept++] = surplus > 0 ? low : high;
        }
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
        for (int i = 0, end; i < edges.length; i = end) {
            end = endOfEdge(edges, i);
            open += isPoint(edges[i]) || 2 * turned(edges, i, end) == end - i ? 0 : 1;
        }
        return open;
    }

    private static int endOfEdge(long[] edges, int begin) {
        int end = begin + 1;
        while (end < edges.length && edges[end] >>> 1 == edges[begin] >>> 1) {
            end++;
        }
        return end;
    }

    private static int turned(long[] edges, int begin, int end) {
        int turned = 0;
        for (int k = begin; k < end; k++) {
            turned += (int) (edges[k] & 1);
        }
        return turned;
    }

    /** An edge from a place to the same place bounds nothing. */
    private static boolean isPoint(long edge) {
        return edge >>> 32 == (edge & 0xffffffffL) >>> 1;
    }
}
