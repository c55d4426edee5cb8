package enlightenment.world.light;

import enlightenment.frame.Bounds;
import enlightenment.math.Vec3;
import enlightenment.numeric.MedianCut;
import enlightenment.primitive.SpherePrimitive;
import enlightenment.world.parts.CancellationCheck;

/**
 * The lights that mirrors may reflect, in a binary tree of boxes around their centres, to find those that send a mirror the most power
 * without testing all. Immutable but for the count of its work.
 *
 * <p>The bound of a node on the power that any of its lights sends to a mirror is computed by the same operations as that power, each of
 * them monotone also in rounding: no light of the node has more, to the last bit.
 */
public final class MirroredLights {
    private static final int LEAF = 4;

    private final PhysicalLight[] lights;
    private final CancellationCheck work;

    /** Indices of lights: a node has a range of them, its children the halves of that. */
    private final int[] order;

    /** By light: mean radiance times area. */
    private final double[] strength;

    /**
     * By node, 1 for the root and 2k, 2k + 1 for the children of k: a box around its lights' centres, its largest strength, its first
     * light.
     */
    private final Bounds[] box;

    private final double[] strongest;
    private final int[] first;

    /**
     * Puts lights into a tree.
     *
     * @param lights of a scene
     * @param some indices of those that may be reflected, at least one
     * @param visibleOfUltraviolet see {@code PhysicalScene}
     * @param work counts each step
     */
    public MirroredLights(PhysicalLight[] lights, int[] some, double visibleOfUltraviolet, CancellationCheck work) {
        this.lights = lights;
        this.work = work;
        order = some.clone();
        strength = new double[lights.length];
        for (int i : some) {
            PhysicalLight l = lights[i];
            double brightest = Math.max(Math.max(l.r, Math.max(l.g, l.b)), visibleOfUltraviolet * l.ultraviolet);
            strength[i] = brightest * l.form.area();
        }
        int nodes = 2;
        for (int most = some.length; most > LEAF; most = (most + 1) / 2) {
            nodes *= 2;
        }
        box = new Bounds[nodes];
        strongest = new double[nodes];
        first = new int[nodes];
        build(1, 0, order.length);
    }

    /** The number of lights. */
    public int count() {
        return order.length;
    }

    private void build(int node, int from, int to) {
        work.steps(to - from);
        Vec3 center = center(order[from]);
        Vec3 min = center;
        Vec3 max = center;
        double most = strength[order[from]];
        int least = order[from];
        for (int k = from + 1; k < to; k++) {
            Vec3 c = center(order[k]);
            min = new Vec3(Math.min(min.x(), c.x()), Math.min(min.y(), c.y()), Math.min(min.z(), c.z()));
            max = new Vec3(Math.max(max.x(), c.x()), Math.max(max.y(), c.y()), Math.max(max.z(), c.z()));
            most = Math.max(most, strength[order[k]]);
            least = Math.min(least, order[k]);
        }
        box[node] = new Bounds(min, max);
        strongest[node] = most;
        first[node] = least;
        if (to - from > LEAF) {
            Vec3 extent = box[node].extent();
            int axis = extent.x() >= extent.y() && extent.x() >= extent.z() ? 0 : extent.y() >= extent.z() ? 1 : 2;
            int middle = middle(from, to);
            MedianCut.select(order, from, to, middle, light -> along(light, axis), work::steps);
            build(2 * node, from, middle);
            build(2 * node + 1, middle, to);
        }
    }

    private static int middle(int from, int to) {
        return (from + to + 1) >>> 1;
    }

    private Vec3 center(int light) {
        return new Vec3(lights[light].ballX, lights[light].ballY, lights[light].ballZ);
    }

    private double along(int light, int axis) {
        PhysicalLight l = lights[light];
        return axis == 0 ? l.ballX : axis == 1 ? l.ballY : l.ballZ;
    }

    /** Offers the pairs of a mirror and each light that is no face of it, without those that are certainly not kept. */
    public void offer(SpherePrimitive mirror, int id, StrongestPairs best) {
        offer(1, 0, order.length, mirror, id, best);
    }

    private void offer(int node, int from, int to, SpherePrimitive mirror, int id, StrongestPairs best) {
        work.step();
        if (!best.takes(most(node, mirror), id, first[node])) {
            return;
        }
        if (to - from <= LEAF) {
            for (int k = from; k < to; k++) {
                int light = order[k];
                if (lights[light].id != id) {
                    best.offer(power(mirror, light), id, light);
                }
            }
            return;
        }
        int middle = middle(from, to);
        // The stronger child first, so that more of the other is skipped.
        if (most(2 * node, mirror) >= most(2 * node + 1, mirror)) {
            offer(2 * node, from, middle, mirror, id, best);
            offer(2 * node + 1, middle, to, mirror, id, best);
        } else {
            offer(2 * node + 1, middle, to, mirror, id, best);
            offer(2 * node, from, middle, mirror, id, best);
        }
    }

    /** Roughly the power that a light sends to a mirror, up to a factor. */
    private double power(SpherePrimitive mirror, int light) {
        PhysicalLight l = lights[light];
        double share = share(mirror, mirror.x() - l.ballX, mirror.y() - l.ballY, mirror.z() - l.ballZ);
        return strength[light] * share;
    }

    /** An upper bound of {@link #power} for the lights of a node. */
    private double most(int node, SpherePrimitive mirror) {
        Vec3 min = box[node].min();
        Vec3 max = box[node].max();
        double x = apart(mirror.x(), min.x(), max.x());
        double y = apart(mirror.y(), min.y(), max.y());
        double z = apart(mirror.z(), min.z(), max.z());
        return strongest[node] * share(mirror, x, y, z);
    }

    /** A lower bound of the distance of a coordinate from all in a range. */
    private static double apart(double at, double min, double max) {
        return at > max ? at - max : at < min ? at - min : 0;
    }

    /** The share of the light at a distance that hits the mirror, up to a factor: squared radius over squared distance, at most 1. */
    private static double share(SpherePrimitive mirror, double x, double y, double z) {
        double rr = mirror.radius() * mirror.radius();
        double dd = x * x + y * y + z * z;
        return rr >= dd ? 1 : rr / dd;
    }
}
