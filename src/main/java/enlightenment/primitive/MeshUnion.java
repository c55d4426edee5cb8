package enlightenment.primitive;

import enlightenment.bvh.Nodes;
import enlightenment.frame.Bounds;
import enlightenment.mesh.JoinedMesh;
import enlightenment.mesh.MeshRay;
import enlightenment.mesh.TriangleMesh;
import enlightenment.mesh.TriangleTree;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.IdentityHashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.IntStream;

/**
 * Meshes that were placed alike, with one hierarchy of all their triangles: rays need not be prepared for each of them, and boxes do not overlap.
 * What a ray meets is a triangle of a member, with the t that the member itself would give. Immutable.
 */
public final class MeshUnion {
    private final MeshPrimitive[] members;
    private final int[] ids;

    /** By member: the number of its first triangle in the hierarchy; then the number of all. */
    private final int[] first;

    private final TriangleTree tree;
    private final Bounds bounds;

    /** By member: its number. */
    private final Map<Primitive, Integer> numbers = new IdentityHashMap<>();

    private MeshUnion(Primitive[] all, int[] chosen, Runnable poll) {
        ids = chosen;
        members = Arrays.stream(ids).mapToObj(i -> (MeshPrimitive) all[i]).toArray(MeshPrimitive[]::new);
        first = new int[members.length + 1];
        Bounds box = members[0].bounds();
        for (int k = 0; k < members.length; k++) {
            first[k + 1] = first[k] + members[k].mesh().triangles();
            box = box.union(members[k].bounds());
            numbers.put(members[k], k);
            members[k].likelyMember = k;
        }
        bounds = box;
        List<TriangleMesh> meshes =
                Arrays.stream(members).map(MeshPrimitive::mesh).toList();
        tree = JoinedMesh.positionsOf(meshes).tree(poll);
    }

    /**
     * The union of meshes that are placed alike, if there are at least two; of several such sets that with the most triangles.
     *
     * @param poll called now and then; ends the building by what it throws
     * @return null if there is none
     */
    public static MeshUnion of(Primitive[] primitives, Runnable poll) {
        int[] best = null;
        long most = 0;
        for (int[] alike : alike(primitives)) {
            long triangles = Arrays.stream(alike)
                    .mapToLong(i -> ((MeshPrimitive) primitives[i]).mesh().triangles())
                    .sum();
            boolean isBetter = triangles > most || triangles == most && best != null && alike[0] < best[0];
            if (isBetter && triangles < Nodes.MOST_ITEMS) {
                most = triangles;
                best = alike;
            }
        }
        return best == null ? null : new MeshUnion(primitives, best, poll);
    }

    /** The indices of meshes that are placed alike, of each such set of at least two in ascending order. */
    private static List<int[]> alike(Primitive[] primitives) {
        // Sorted by the hash of how they are placed: there may be a million instances, of which nearly all stand alone.
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

    /** The number of members. */
    public int size() {
        return members.length;
    }

    /** The id of a member. */
    public int id(int member) {
        return ids[member];
    }

    /** A member. */
    public MeshPrimitive member(int member) {
        return members[member];
    }

    /** A box around all. */
    public Bounds bounds() {
        return bounds;
    }

    /**
     * The t of the nearest crossing with tMin ≤ t ≤ tMax, or {@link Primitive#MISS}; {@link Ray#element} is the triangle then, and {@link
     * Ray#member} the member. For rays that it {@link #suits}.
     */
    public double nearest(Ray ray, double tMax) {
        MeshRay local = local(ray);
        if (!local.closest(tMax)) {
            return Primitive.MISS;
        }
        int k = memberOf(local.triangle);
        ray.member = k;
        ray.element = local.triangle - first[k];
        return local.t;
    }

    /** Whether there is a crossing with tMin ≤ t ≤ tMax. For such rays, too. */
    public boolean blocks(Ray ray, double tMax) {
        return local(ray).isBlocked(tMax);
    }

    /** Whether a ray may be asked about: it is not extreme, and starts on two meshes at most. */
    public boolean suits(Ray ray) {
        return !ray.extreme && ray.otherMesh() > -2;
    }

    private int memberOf(int triangle) {
        int k = Arrays.binarySearch(first, triangle);
        return k >= 0 ? k : -k - 2;
    }

    private MeshRay local(Ray ray) {
        MeshRay local = ray.meshRay();
        members[0].place(local, tree.mesh(), ray);
        int start = memberOf(ray.start);
        if (start >= 0) {
            members[start].startOn(local, first[start] + ray.startElement, ray);
        }
        int also = ray.isSpecial() ? ray.otherMesh() : -1;
        int other = also < 0 ? -1 : memberOf(ray.alsoStart(also));
        if (other >= 0) {
            local.leaveOut(first[other] + ray.alsoElement(also));
        }
        return local;
    }

    /** The number of a member; −1 if it is none. */
    private int memberOf(Primitive primitive) {
        if (!(primitive instanceof MeshPrimitive m)) {
            return -1;
        }
        int likely = m.likelyMember;
        return likely < members.length && members[likely] == m ? likely : numbers.getOrDefault(m, -1);
    }
}
