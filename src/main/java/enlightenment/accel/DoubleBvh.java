package enlightenment.accel;

import enlightenment.bvh.ItemBoxes;
import enlightenment.bvh.Nodes;

/**
 * A hierarchy with boxes of doubles: for scenes with primitives so small, relative to their distance, that boxes of floats would be too
 * coarse.
 */
final class DoubleBvh extends Bvh {
    /** By node: the lower and the upper corner of the left child's box, then of the right one's. */
    private final double[] boxes;

    DoubleBvh(int[] child, Leaves leaves, double reach) {
        super(child, leaves, reach);
        boxes = exactBoxes();
    }

    @Override
    double entry(SlabTest slabs, int node, int side, double limit) {
        return slabs.entry(boxes, Nodes.NODE * node + ItemBoxes.BOX * side, limit);
    }

    @Override
    double bound(int node, int side, boolean upper, int axis) {
        return boxes[Nodes.NODE * node + ItemBoxes.BOX * side + (upper ? 3 : 0) + axis];
    }
}
