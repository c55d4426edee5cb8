package enlightenment.primitive;

import enlightenment.bvh.Nodes;
import enlightenment.frame.Bounds;
import enlightenment.mesh.TriangleMesh;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.IdentityHashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.IntStream;

/** Selects the meshes that may share a hierarchy: see {@link MeshUnion}. */
final class UnionMembers {
    /** A mesh with more triangles keeps a hierarchy of its own: that of placed triangles is rebuilt for each frame of a film. */
    private static final int MOST_TRIANGLES = 1 << 16;

    /** The largest number of triangles of all such meshes together. */
    private static final int MOST_OF_ALL = 1 << 18;

    /**
     * The largest distance of a placed mesh from the frame's origin, in multiples of its size: its vertices lose that many units in the
     * last place.
     */
    private static final double FARTHEST = 0x1p10;

    private UnionMembers() {}

    /**
     * The indices of meshes with the same placing, in ascending order: of several such sets that with the most triangles; empty if there is
     * none.
     */
    static int[] alike(Primitive[] primitives) {
        int[] best = {};
        long most = 0;
        for (int[] set : setsOfAlike(primitives)) {
            long triangles = triangles(primitives, set);
            boolean isBetter = triangles > most || triangles == most && set[0] < best[0];
            if (isBetter && triangles < Nodes.MOST_ITEMS) {
                most = triangles;
                best = set;
            }
        }
        return best;
    }

    /** The indices of small meshes with a single instance, in ascending order; empty if there are too many. */
    static int[] lone(Primitive[] primitives) {
        Map<TriangleMesh, Integer> uses = new IdentityHashMap<>();
        for (Primitive p : primitives) {
            if (p instanceof MeshPrimitive m) {
                uses.merge(m.mesh(), 1, Integer::sum);
            }
        }
        int[] lone = IntStream.range(0, primitives.length)
                .filter(i -> primitives[i] instanceof MeshPrimitive m && uses.get(m.mesh()) == 1 && isSmallAndNear(m))
                .toArray();
        return triangles(primitives, lone) <= MOST_OF_ALL ? lone : new int[0];
    }

    private static boolean isSmallAndNear(MeshPrimitive m) {
        Bounds box = m.bounds();
        return !m.isExtreme()
                && m.mesh().triangles() <= MOST_TRIANGLES
                && box.maxAbs() <= FARTHEST * box.extent().maxAbs();
    }

    private static long triangles(Primitive[] primitives, int[] ids) {
        return Arrays.stream(ids)
                .mapToLong(i -> ((MeshPrimitive) primitives[i]).mesh().triangles())
                .sum();
    }

    /** The indices of meshes with the same placing, for each such set of at least two, in ascending order. */
    private static List<int[]> setsOfAlike(Primitive[] primitives) {
        // Sorted by the hash of the placing: there may be a million instances, nearly all with a placing of their own.
        long[] order = IntStream.range(0, primitives.length)
                .filter(i -> primitives[i] instanceof MeshPrimitive m && !m.isExtreme())
                .mapToLong(i -> (long) placing(primitives, i).hashCode() << Integer.SIZE | i)
                .sorted()
                .toArray();
        List<int[]> sets = new ArrayList<>();
        for (int from = 0, to; from < order.length; from = to) {
            to = from + 1;
            while (to < order.length && order[to] >> Integer.SIZE == order[from] >> Integer.SIZE) {
                to++;
            }
            if (to - from > 1) {
                Map<Placing, List<Integer>> byPlacing = new LinkedHashMap<>();
                for (int k = from; k < to; k++) {
                    int i = (int) order[k];
                    byPlacing
                            .computeIfAbsent(placing(primitives, i), p -> new ArrayList<>())
                            .add(i);
                }
                byPlacing.values().stream()
                        .filter(set -> set.size() > 1)
                        .forEach(set -> sets.add(set.stream().mapToInt(i -> i).toArray()));
            }
        }
        return sets;
    }

    private static Placing placing(Primitive[] primitives, int i) {
        return ((MeshPrimitive) primitives[i]).placing();
    }
}
