package enlightenment.accel;

import enlightenment.bvh.ItemBoxes;
import enlightenment.bvh.Nodes;
import enlightenment.frame.BallCone;
import enlightenment.numeric.Scale;

/**
 * Decides whether primitives of a hierarchy reach into a cone, always with the same verdict: it depends only on the cone, the judge and the
 * tree's boxes without their roundings to floats. A primitive reaches into the cone if the judge says so and the balls around all boxes
 * that contain it do.
 *
 * <p>The surveys of the cluster method depend on this verdict. For pictures {@link Accelerator#narrow} suffices, and is faster. Immutable.
 */
public final class ConeSearch {
    /** Bounds the rounding of half a box's diagonal. */
    private static final double DIAGONAL_ERROR = Scale.gamma(8);

    private final Bvh bvh;
    private final double[] boxes;

    private ConeSearch(Bvh bvh) {
        this.bvh = bvh;
        boxes = bvh.exactBoxes();
    }

    /** Makes the search of an accelerator; null if its {@link Accelerator#narrow} is as definite. */
    public static ConeSearch of(Accelerator accelerator) {
        return accelerator instanceof Bvh bvh ? new ConeSearch(bvh) : null;
    }

    /**
     * As {@link Accelerator#narrow} for at least two rays, but definite: 0 if no primitive reaches into the cone,
     * {@link Accelerator#BLOCKED} if one blocks everything, else a positive number.
     */
    public int narrow(BallCone cone, ConeJudge judge, BvhQuery query) {
        if (!anyReaches(cone, judge, query)) {
            return 0;
        }
        int left = bvh.narrow(cone, judge, 2, query);
        return left == Accelerator.BLOCKED || bvh.blocksAll(cone, judge, query) ? Accelerator.BLOCKED : 1;
    }

    private boolean anyReaches(BallCone cone, ConeJudge judge, BvhQuery query) {
        double[] root = query.box;
        ItemBoxes.clear(root, 0);
        ItemBoxes.merge(boxes, 0, root, 0);
        ItemBoxes.merge(boxes, ItemBoxes.BOX, root, 0);
        if (misses(root, 0, cone)) {
            return false;
        }
        int[] stack = query.stack();
        int depth = 1;
        stack[0] = 0;
        while (depth > 0) {
            int node = stack[--depth];
            if (node < 0) {
                if (bvh.leaves.judge(Nodes.first(node), Nodes.end(node), judge) != ConeJudge.CLEAR) {
                    return true;
                }
                continue;
            }
            for (int side = 0; side < 2; side++) {
                if (!misses(boxes, Nodes.NODE * node + ItemBoxes.BOX * side, cone)) {
                    stack[depth++] = bvh.child[2 * node + side];
                }
            }
        }
        return false;
    }

    private static boolean misses(double[] b, int k, BallCone cone) {
        double hx = (b[k + 3] - b[k]) / 2;
        double hy = (b[k + 4] - b[k + 1]) / 2;
        double hz = (b[k + 5] - b[k + 2]) / 2;
        double radius = Math.sqrt(hx * hx + hy * hy + hz * hz) * (1 + DIAGONAL_ERROR);
        return cone.misses(b[k] + hx, b[k + 1] + hy, b[k + 2] + hz, radius);
    }
}
