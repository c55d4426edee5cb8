package enlightenment.mesh.tree;

import enlightenment.bvh.BvhBuilder;
import enlightenment.bvh.ItemBoxes;
import enlightenment.bvh.Nodes;
import enlightenment.mesh.TriangleMesh;
import enlightenment.mesh.data.MeshData;
import enlightenment.numeric.Scale;

/**
 * The hierarchy of a mesh's triangles, in the mesh's own coordinates times a power of two that brings the largest into [1, 2): so its boxes are
 * floats whatever the mesh's unit is. One for all instances of the mesh. Immutable.
 *
 * <p>Boxes only cull; what a ray meets is decided by {@link MeshRay}, in doubles.
 */
public final class TriangleTree {
    /** Bytes a triangle takes usually. */
    private static final long USUAL_BYTES = 32;

    /** Levels of the tree whose boxes, turned and joined, are the bounds of a mesh that is turned. */
    private static final int BOUND_LEVELS = 5;

    /** The exponent of the scale that boxes are kept in. */
    final int exponent;

    /** The largest absolute coordinate of any box. */
    final double reach;

    /** That reach in the mesh's coordinates. */
    final double largest;

    /** By axis, the box around all triangles, in the mesh's coordinates. */
    final double[] low;

    final double[] high;

    /** What the mesh's coordinates are multiplied by. */
    final double unit;

    final float[] boxes;
    final int[] child;

    /** By place in the leaves: the triangle. */
    final int[] order;

    final TriangleMesh mesh;

    /** The boxes of its upper levels in the mesh's coordinates, which each turned instance of the mesh needs. */
    private final double[] upper;

    private final int upperSize;

    private TriangleTree(TriangleMesh mesh, Runnable poll) {
        this.mesh = mesh;
        largest = mesh.maxAbs();
        low = new double[] {mesh.min().x(), mesh.min().y(), mesh.min().z()};
        high = new double[] {mesh.max().x(), mesh.max().y(), mesh.max().z()};
        exponent = Scale.exponent(largest);
        unit = Math.scalb(1.0, -exponent);
        ItemBoxes items = new ItemBoxes(mesh.triangles(), this::setBox);
        BvhBuilder builder = new BvhBuilder(items, poll);
        boxes = builder.floats();
        child = builder.child();
        order = builder.order();
        reach = builder.reach();
        upper = new double[ItemBoxes.BOX << BOUND_LEVELS];
        upperSize = addBoxes(0, 1, 0);
    }

    /**
     * The hierarchy of a mesh's triangles, made when it is first asked for and kept with the mesh.
     *
     * @param poll called now and then; ends the building by what it throws
     */
    public static TriangleTree of(TriangleMesh mesh, Runnable poll) {
        MeshData data = mesh.data();
        synchronized (data) {
            if (data.hierarchy() == null) {
                data.keepHierarchy(new TriangleTree(mesh, poll));
            }
            return (TriangleTree) data.hierarchy();
        }
    }

    /** The hierarchy of a mesh's triangles; who traces rays has made it before. */
    static TriangleTree of(TriangleMesh mesh) {
        Object made = mesh.data().hierarchy();
        return made == null ? of(mesh, () -> {}) : (TriangleTree) made;
    }

    /** The bytes of memory that a mesh's hierarchy takes: about as many where it is not made yet. */
    public static long bytesOf(TriangleMesh mesh) {
        Object made = mesh.data().hierarchy();
        return made == null ? USUAL_BYTES * mesh.triangles() : ((TriangleTree) made).bytes();
    }

    private void setBox(int triangle, double[] out, int at) {
        int a = mesh.vertex(triangle, 0);
        int b = mesh.vertex(triangle, 1);
        int c = mesh.vertex(triangle, 2);
        for (int axis = 0; axis < 3; axis++) {
            double p = mesh.coordinate(a, axis);
            double q = mesh.coordinate(b, axis);
            double r = mesh.coordinate(c, axis);
            out[at + axis] = Scale.scalb(Math.min(p, Math.min(q, r)), -exponent);
            out[at + 3 + axis] = Scale.scalb(Math.max(p, Math.max(q, r)), -exponent);
        }
    }

    /** Takes boxes, each by its least and greatest coordinates. */
    public interface Boxes {
        void accept(double x0, double y0, double z0, double x1, double y1, double z1);
    }

    /** Gives boxes that enclose all triangles together, in the mesh's coordinates: tighter than one where the mesh is turned. */
    public void forEachBox(Boxes receiver) {
        double[] b = upper;
        for (int k = 0; k < upperSize; k += ItemBoxes.BOX) {
            receiver.accept(b[k], b[k + 1], b[k + 2], b[k + 3], b[k + 4], b[k + 5]);
        }
    }

    /** Appends the boxes below a node to {@link #upper}, from this place on; returns the place after the last one. */
    private int addBoxes(int node, int level, int from) {
        double back = Scale.scalb(1, exponent);
        int end = from;
        for (int side = 0; side < 2; side++) {
            int link = child[2 * node + side];
            int at = Nodes.NODE * node + side;
            if (link >= 0 && level < BOUND_LEVELS) {
                end = addBoxes(link, level + 1, end);
            } else if (link != Nodes.EMPTY) {
                for (int axis = 0; axis < 3; axis++) {
                    double center = boxes[at + 2 * axis];
                    float half = boxes[at + 6 + 2 * axis];
                    upper[end + axis] = Math.max((center - half) * back, low[axis]);
                    upper[end + 3 + axis] = Math.min((center + half) * back, high[axis]);
                }
                end += ItemBoxes.BOX;
            }
        }
        return end;
    }

    /** The mesh whose tree it is. */
    public TriangleMesh mesh() {
        return mesh;
    }

    /** The bytes that it takes. */
    private long bytes() {
        return 4L * (boxes.length + child.length + order.length);
    }
}
