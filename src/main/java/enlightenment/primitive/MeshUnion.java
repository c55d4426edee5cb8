package enlightenment.primitive;

import enlightenment.bvh.Nodes;
import enlightenment.frame.Bounds;
import enlightenment.mesh.MeshRay;
import enlightenment.mesh.TriangleMesh;
import enlightenment.mesh.TriangleTree;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

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

    private MeshUnion(Primitive[] all, List<Integer> chosen, Runnable poll) {
        ids = chosen.stream().mapToInt(i -> i).toArray();
        members = Arrays.stream(ids).mapToObj(i -> (MeshPrimitive) all[i]).toArray(MeshPrimitive[]::new);
        first = new int[members.length + 1];
        Bounds box = members[0].bounds();
        for (int k = 0; k < members.length; k++) {
            first[k + 1] = first[k] + members[k].mesh().triangles();
            box = box.union(members[k].bounds());
        }
        bounds = box;
        List<TriangleMesh> meshes =
                Arrays.stream(members).map(MeshPrimitive::mesh).toList();
        tree = meshes.get(0).unionWith(meshes.subList(1, meshes.size())).tree(poll);
    }

    /**
     * The union of those meshes that are placed alike and not turned or scaled, if there are at least two; of several such sets that with the most
     * triangles.
     *
     * @param poll called now and then; ends the building by what it throws
     * @return null if there is none
     */
    public static MeshUnion of(Primitive[] primitives, Runnable poll) {
        Map<List<Double>, List<Integer>> placed = new LinkedHashMap<>();
        for (int i = 0; i < primitives.length; i++) {
            if (primitives[i] instanceof MeshPrimitive m && m.isMoved() && !m.isExtreme()) {
                placed.computeIfAbsent(m.offset(), k -> new ArrayList<>()).add(i);
            }
        }
        List<Integer> best = null;
        long most = 0;
        for (List<Integer> alike : placed.values()) {
            long triangles = alike.stream()
                    .mapToLong(i -> ((MeshPrimitive) primitives[i]).mesh().triangles())
                    .sum();
            if (alike.size() > 1 && triangles > most && triangles < Nodes.MOST_ITEMS) {
                most = triangles;
                best = alike;
            }
        }
        return best == null ? null : new MeshUnion(primitives, best, poll);
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
     * Ray#member} the member. For ordinary rays that are not {@linkplain Ray#isSpecial special}.
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

    private int memberOf(int triangle) {
        int k = Arrays.binarySearch(first, triangle);
        return k >= 0 ? k : -k - 2;
    }

    private MeshRay local(Ray ray) {
        MeshRay local = ray.meshRay();
        members[0].place(local, tree.mesh(), ray);
        if (ray.start instanceof MeshPrimitive m) {
            for (int k = 0; k < members.length; k++) {
                if (members[k] == m) {
                    m.startOn(local, first[k] + ray.startElement, ray);
                }
            }
        }
        return local;
    }
}
