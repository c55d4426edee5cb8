package enlightenment.primitive;

import enlightenment.frame.Bounds;
import enlightenment.mesh.TriangleMesh;
import enlightenment.mesh.tree.JoinedMesh;
import enlightenment.mesh.tree.MeshRay;
import enlightenment.mesh.tree.ShaftTriangles;
import enlightenment.mesh.tree.TriangleTree;
import java.util.Arrays;
import java.util.List;

/**
 * Meshes with one hierarchy of all their triangles: rays need not be transformed for each of them, and boxes do not overlap. Either all
 * have the same placing; or they are small and each is placed once, and the hierarchy has their placed triangles. The result of a query is
 * a triangle of a member, with the t that the member itself would return, up to the rounding of placed vertices. Immutable.
 */
public final class MeshUnion {
    private final MeshPrimitive[] members;
    private final int[] ids;

    /** By member: the number of its first triangle in the hierarchy; then the number of all. */
    private final int[] first;

    /** The placing of the hierarchy's coordinates in the frame. */
    private final Placing placing;

    private final TriangleTree tree;
    private final Bounds bounds;

    private MeshUnion(MeshPrimitive[] members, int[] ids, Placing placing, TriangleTree tree) {
        this.members = members;
        this.ids = ids;
        this.placing = placing;
        this.tree = tree;
        first = new int[members.length + 1];
        Bounds box = members[0].bounds();
        for (int k = 0; k < members.length; k++) {
            first[k + 1] = first[k] + members[k].mesh().triangles();
            box = box.union(members[k].bounds());
            members[k].likelyMember = k;
        }
        bounds = box;
    }

    /**
     * Makes the union of meshes with the same placing, or of small ones that are placed once: of the larger set, of at least two.
     *
     * @param poll called regularly; what it throws ends the building
     * @return null if there is none
     */
    public static MeshUnion of(Primitive[] primitives, Runnable poll) {
        int[] alike = UnionMembers.alike(primitives);
        int[] lone = UnionMembers.lone(primitives);
        MeshUnion union = lone.length > Math.max(1, alike.length) ? ofLone(primitives, lone, poll) : null;
        return union == null && alike.length > 1 ? ofAlike(primitives, alike, poll) : union;
    }

    private static MeshUnion ofAlike(Primitive[] primitives, int[] ids, Runnable poll) {
        MeshPrimitive[] members = members(primitives, ids);
        TriangleMesh joined = JoinedMesh.positionsOf(meshes(members));
        return new MeshUnion(members, ids, members[0].placing(), TriangleTree.of(joined, poll));
    }

    /**
     * Makes the union in the coordinates of the frame; null if rounding makes a triangle degenerate, since places in the leaves count
     * triangles.
     */
    private static MeshUnion ofLone(Primitive[] primitives, int[] ids, Runnable poll) {
        MeshPrimitive[] members = members(primitives, ids);
        List<TriangleMesh> meshes = meshes(members);
        List<Placing> placings =
                Arrays.stream(members).map(MeshPrimitive::placing).toList();
        TriangleMesh joined = JoinedMesh.positionsOf(meshes, placings);
        return joined.dropped() > 0
                ? null
                : new MeshUnion(members, ids, Placing.IDENTITY, TriangleTree.of(joined, poll));
    }

    private static MeshPrimitive[] members(Primitive[] primitives, int[] ids) {
        return Arrays.stream(ids).mapToObj(i -> (MeshPrimitive) primitives[i]).toArray(MeshPrimitive[]::new);
    }

    private static List<TriangleMesh> meshes(MeshPrimitive[] members) {
        return Arrays.stream(members).map(MeshPrimitive::mesh).toList();
    }

    /** The number of members. */
    public int size() {
        return members.length;
    }

    /** The id of a member. */
    public int id(int member) {
        return ids[member];
    }

    /** The mesh of a member. */
    public MeshPrimitive member(int member) {
        return members[member];
    }

    /** The union as one mesh for code on another device. */
    public FlatForm flatForm() {
        return new FlatForm(FlatForm.Kind.MESH, placing.flatForm(), tree.mesh());
    }

    /** By member: the number of its first triangle among all; then the number of all. */
    public int[] firstTriangles() {
        return first.clone();
    }

    /** By member: the id of its primitive. */
    public int[] ids() {
        return ids.clone();
    }

    /** The box around all members. */
    public Bounds bounds() {
        return bounds;
    }

    /**
     * The t of the nearest crossing with tMin ≤ t ≤ tMax, or {@link Primitive#MISS}; {@link Ray#element} is the triangle then, and
     * {@link Ray#member} the member. Only for rays that the union {@link #suits}.
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

    /** Whether there is a crossing with tMin ≤ t ≤ tMax. Only for rays that the union {@link #suits}. */
    public boolean blocks(Ray ray, double tMax) {
        return local(ray).isBlocked(tMax);
    }

    /**
     * Finds the triangles that may block segments from a point to others.
     *
     * @param ends a box around those others: least, then largest coordinates
     * @param into receives the triangles
     * @return whether they are few enough to be known
     */
    public boolean narrow(double x, double y, double z, double[] ends, ShaftTriangles into) {
        return placing.isMove
                && into.find(tree, x, y, z, ends, placing.offset(0), placing.offset(1), placing.offset(2));
    }

    /** Whether one of these triangles has a crossing with tMin ≤ t ≤ tMax. Only for rays that the union {@link #suits}. */
    public boolean blocks(Ray ray, ShaftTriangles some, double tMax) {
        return local(ray).isBlockedBy(some, tMax);
    }

    /** Whether the union can be queried with a ray: it is not extreme, and starts on at most two meshes. */
    public boolean suits(Ray ray) {
        return !ray.extreme && ray.otherMesh() > -2;
    }

    private int memberOf(int triangle) {
        int k = Arrays.binarySearch(first, triangle);
        return k >= 0 ? k : -k - 2;
    }

    private MeshRay local(Ray ray) {
        MeshRay local = ray.meshRay();
        MeshPrimitive.place(local, tree.mesh(), placing, ray);
        int start = memberOf(ray.start);
        if (start >= 0) {
            members[start].startOn(local, first[start] + ray.startElement, placing, ray);
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
        if (likely < 0 || likely < members.length && members[likely] == m) {
            return likely;
        }
        // It has been joined to another union since.
        return Arrays.asList(members).indexOf(m);
    }
}
