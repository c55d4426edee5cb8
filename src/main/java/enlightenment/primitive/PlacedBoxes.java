package enlightenment.primitive;

import enlightenment.frame.Bounds;
import enlightenment.math.Vec3;
import enlightenment.mesh.tree.TriangleTree;

/** The box around a mesh's boxes after placing. */
final class PlacedBoxes implements TriangleTree.Boxes {
    private final Placing placing;
    private final double[] low = {Double.POSITIVE_INFINITY, Double.POSITIVE_INFINITY, Double.POSITIVE_INFINITY};
    private final double[] high = {Double.NEGATIVE_INFINITY, Double.NEGATIVE_INFINITY, Double.NEGATIVE_INFINITY};

    PlacedBoxes(Placing placing) {
        this.placing = placing;
    }

    @Override
    public void accept(double x0, double y0, double z0, double x1, double y1, double z1) {
        for (int axis = 0; axis < 3; axis++) {
            low[axis] = Math.min(low[axis], placing.least(axis, x0, y0, z0, x1, y1, z1));
            high[axis] = Math.max(high[axis], placing.least(axis, x1, y1, z1, x0, y0, z0));
        }
    }

    /**
     * @param slack bound of the roundings, by axis
     */
    Bounds bounds(Vec3 slack) {
        return new Bounds(
                new Vec3(low[0], low[1], low[2]).minus(slack), new Vec3(high[0], high[1], high[2]).plus(slack));
    }
}
