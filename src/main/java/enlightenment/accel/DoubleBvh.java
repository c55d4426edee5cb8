package enlightenment.accel;

/** A hierarchy with boxes of doubles: for scenes whose primitives are so small, seen from their distance, that floats would blur them. */
final class DoubleBvh extends Bvh {
    /** By node: the lower and the upper corner of the left child's box, then of the right one's. */
    private final double[] boxes;

    DoubleBvh(int[] child, Leaves leaves, double reach) {
        super(child, leaves, reach);
        boxes = exactBoxes();
    }

    @Override
    double entry(SlabTest slabs, int node, int side, double limit) {
        return slabs.entry(boxes, NODE * node + PrimitiveBoxes.BOX * side, limit);
    }

    @Override
    double bound(int node, int side, boolean upper, int axis) {
        return boxes[NODE * node + PrimitiveBoxes.BOX * side + (upper ? 3 : 0) + axis];
    }
}
