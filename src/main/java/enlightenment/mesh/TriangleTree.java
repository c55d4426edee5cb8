package enlightenment.mesh;

import enlightenment.bvh.BvhBuilder;
import enlightenment.bvh.ItemBoxes;
import enlightenment.bvh.Nodes;
import enlightenment.frame.Bounds;
import enlightenment.math.Vec3;
import enlightenment.numeric.Scale;
import java.util.function.Consumer;

/**
 * The hierarchy of a mesh's triangles, in the mesh's own coordinates times a power of two that brings the largest into [1, 2): so its boxes are
 * floats whatever the mesh's unit is. One for all instances of the mesh. Immutable.
 *
 * <p>Boxes only cull; what a ray meets is decided by {@link MeshRay}, in doubles.
 */
public final class TriangleTree {
    /** Levels of the tree whose boxes, turned and joined, are the bounds of a mesh that is turned. */
    private static final int BOUND_LEVELS = 6;

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
    final Bounds bounds;

    TriangleTree(TriangleMesh mesh, Runnable poll) {
        this.mesh = mesh;
        bounds = mesh.bounds();
        largest = bounds.maxAbs();
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

    /** Gives the corners of boxes that enclose all triangles together, in the mesh's coordinates: tighter than one where the mesh is turned. */
    public void forEachCorner(Consumer<Vec3> receiver) {
        addParts(0, 1, receiver);
    }

    private void addParts(int node, int level, Consumer<Vec3> receiver) {
        for (int side = 0; side < 2; side++) {
            int link = child[2 * node + side];
            if (link >= 0 && level < BOUND_LEVELS) {
                addParts(link, level + 1, receiver);
            } else if (link != Nodes.EMPTY) {
                Bounds box = box(node, side);
                for (int k = 0; k < 8; k++) {
                    receiver.accept(box.corner(k));
                }
            }
        }
    }

    private Bounds box(int node, int side) {
        int at = Nodes.NODE * node + side;
        double[] low = new double[3];
        double[] high = new double[3];
        for (int axis = 0; axis < 3; axis++) {
            double center = boxes[at + 2 * axis];
            double half = boxes[at + 6 + 2 * axis];
            low[axis] =
                    Math.max(Scale.scalb(center - half, exponent), bounds.min().component(axis));
            high[axis] =
                    Math.min(Scale.scalb(center + half, exponent), bounds.max().component(axis));
        }
        return new Bounds(new Vec3(low[0], low[1], low[2]), new Vec3(high[0], high[1], high[2]));
    }

    /** The mesh whose tree it is. */
    public TriangleMesh mesh() {
        return mesh;
    }

    /** The bytes that it takes. */
    public long bytes() {
        return 4L * (boxes.length + child.length + order.length);
    }
}
