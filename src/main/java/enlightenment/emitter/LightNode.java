package enlightenment.emitter;

import enlightenment.frame.Bounds;
import enlightenment.math.Vec3;
import enlightenment.numeric.Scale;
import java.util.ArrayList;
import java.util.List;

/** A node of a {@link LightTree} in the making: built from the top by the surface area orientation heuristic. */
final class LightNode {
    private static final int BUCKETS = 12;

    /** Below this depth lights are halved by number, so that the tree cannot become a list. */
    private static final int DEEPEST = 48;

    /** Who waits for the end of the building is asked before so many lights are divided. */
    private static final int POLLED = 1024;

    final Bounds box;
    final NormalCone normals;
    final double strength;

    /** Its light, or −1. */
    final int light;

    final LightNode first;
    final LightNode second;

    private LightNode(Bounds box, NormalCone normals, double strength, int light, LightNode first, LightNode second) {
        this.box = box;
        this.normals = normals;
        this.strength = strength;
        this.light = light;
        this.first = first;
        this.second = second;
    }

    /** A light by itself; without a normal it shines to all sides. */
    static LightNode leaf(Vec3 center, double radius, Vec3 normal, double strength, int light) {
        Bounds box = Bounds.around(center, new Vec3(radius, radius, radius));
        NormalCone cone = normal.maxAbs() > 0 ? new NormalCone(normal, 0) : NormalCone.ALL;
        return new LightNode(box, cone, strength, light, null, null);
    }

    /**
     * A point with a profile by itself. The bound of the tree falls with the cosine of the angle to the axis beyond the cone that is given here, to 0 a
     * quarter turn beyond it: so no direction of the profile has the bound 0.
     */
    static LightNode leaf(Vec3 center, IntensityProfile profile, double strength, int light) {
        double angle = Math.max(profile.coneAngle() - 0.5 * Math.PI, 0);
        NormalCone cone = new NormalCone(profile.axis(), Math.min(angle + NormalCone.SLACK, Math.PI));
        return new LightNode(Bounds.of(center), cone, strength, light, null, null);
    }

    private LightNode(LightNode first, LightNode second) {
        this(
                first.box.union(second.box),
                first.normals.union(second.normals),
                first.strength + second.strength,
                -1,
                first,
                second);
    }

    /**
     * The tree of these lights.
     *
     * @param poll called now and then; ends the building by what it throws
     */
    static LightNode tree(List<LightNode> leaves, int depth, Runnable poll) {
        if (leaves.size() == 1) {
            return leaves.get(0);
        }
        if (leaves.size() >= POLLED) {
            poll.run();
        }
        List<LightNode> low = new ArrayList<>();
        List<LightNode> high = new ArrayList<>();
        if (depth > DEEPEST || !split(leaves, low, high)) {
            low = leaves.subList(0, leaves.size() / 2);
            high = leaves.subList(leaves.size() / 2, leaves.size());
        }
        return new LightNode(tree(low, depth + 1, poll), tree(high, depth + 1, poll));
    }

    /** Divides the lights where that is cheapest; false if all centres coincide. */
    private static boolean split(List<LightNode> leaves, List<LightNode> low, List<LightNode> high) {
        Bounds centers = Bounds.of(leaves.get(0).box.center());
        for (LightNode n : leaves) {
            centers = centers.union(Bounds.of(n.box.center()));
        }
        double longest = centers.extent().maxAbs();
        double least = Double.POSITIVE_INFINITY;
        int bestAxis = -1;
        int bestBucket = 0;
        for (int axis = 0; axis < 3; axis++) {
            double extent = centers.extent().component(axis);
            if (!(extent > 0)) {
                continue;
            }
            double[] costs = costs(leaves, centers, axis, longest / extent);
            for (int b = 0; b < costs.length; b++) {
                if (costs[b] < least) {
                    least = costs[b];
                    bestAxis = axis;
                    bestBucket = b;
                }
            }
        }
        if (bestAxis < 0) {
            return false;
        }
        for (LightNode n : leaves) {
            (bucket(n, centers, bestAxis) <= bestBucket ? low : high).add(n);
        }
        return !low.isEmpty() && !high.isEmpty();
    }

    private static int bucket(LightNode n, Bounds centers, int axis) {
        double lo = centers.min().component(axis);
        double share = (n.box.center().component(axis) - lo) / (centers.max().component(axis) - lo);
        return Math.min((int) (BUCKETS * share), BUCKETS - 1);
    }

    /** What dividing behind each bucket but the last costs; infinite where that divides nothing. */
    private static double[] costs(List<LightNode> leaves, Bounds centers, int axis, double elongation) {
        LightNode[] buckets = new LightNode[BUCKETS];
        for (LightNode n : leaves) {
            int b = bucket(n, centers, axis);
            buckets[b] = buckets[b] == null ? n : new LightNode(buckets[b], n);
        }
        double[] costs = new double[BUCKETS - 1];
        for (int b = 0; b < costs.length; b++) {
            LightNode low = union(buckets, 0, b);
            LightNode high = union(buckets, b + 1, BUCKETS - 1);
            costs[b] = low == null || high == null ? Double.POSITIVE_INFINITY : elongation * (low.cost() + high.cost());
        }
        return costs;
    }

    private static LightNode union(LightNode[] buckets, int from, int to) {
        LightNode all = null;
        for (int b = from; b <= to; b++) {
            if (buckets[b] != null) {
                all = all == null ? buckets[b] : new LightNode(all, buckets[b]);
            }
        }
        return all;
    }

    private double cost() {
        Vec3 e = box.extent();
        double surface = 2 * (e.x() * e.y() + e.y() * e.z() + e.z() * e.x());
        return strength * normals.measure() * surface;
    }

    /** Writes the numbers that {@link LightTree} needs. */
    void write(double[] data, int k) {
        Vec3 c = box.center();
        data[k] = c.x();
        data[k + 1] = c.y();
        data[k + 2] = c.z();
        data[k + 3] = 0.5 * box.extent().length() * (1 + Scale.gamma(16)) + Scale.gamma(16) * box.maxAbs();
        data[k + 4] = normals.axis().x();
        data[k + 5] = normals.axis().y();
        data[k + 6] = normals.axis().z();
        data[k + 7] = normals.angle() >= Math.PI ? -1 : StrictMath.cos(normals.angle());
        data[k + 8] = StrictMath.sin(normals.angle());
        data[k + 9] = strength;
    }
}
