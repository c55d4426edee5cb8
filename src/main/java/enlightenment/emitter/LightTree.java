package enlightenment.emitter;

import enlightenment.numeric.Scale;

/**
 * A hierarchy of many lights: A. Conty Estevez and C. Kulla, "Importance sampling of many lights with adaptive tree splitting", 2018, with
 * the bounds of M. Pharr, W. Jakob and G. Humphreys, "Physically Based Rendering", 4th ed., 12.6.3. For each receiver the tree is split,
 * where the bound of the contribution is largest, into a few nodes; one of them is sampled in proportion to that bound, its children
 * likewise, and a light at the end by its own weight. Immutable.
 */
final class LightTree {
    /** Bounds the roundings of cosines: a light less than this below the horizon may be above it. */
    private static final double SLACK = Scale.gamma(64);

    /**
     * The number of nodes into which the tree is split; twice and half as many cost more for the same error (docs/notes/light-sampling.md).
     */
    private static final int CUT = 6;

    private static final int STRIDE = 10;

    private final LightWeights weights;

    /** By node: the ball's centre and radius, the cone's axis, cosine and sine, strength. */
    private final double[] data;

    /** By node: the index of its second child, the first one following the node itself; for a leaf −1 − its light. */
    private final int[] second;

    private final int[] parents;
    private final int[] leaves;

    LightTree(LightNode root, int lights, LightWeights weights) {
        this.weights = weights;
        int nodes = 2 * lights - 1;
        data = new double[STRIDE * nodes];
        second = new int[nodes];
        parents = new int[nodes];
        leaves = new int[lights];
        lay(root, 0, -1);
    }

    /** Writes a node and all below it from index {@code at} on; returns the next free index. */
    private int lay(LightNode n, int at, int parent) {
        parents[at] = parent;
        n.write(data, STRIDE * at);
        if (n.light >= 0) {
            second[at] = -1 - n.light;
            leaves[n.light] = at;
            return at + 1;
        }
        second[at] = lay(n.first, at + 1, at);
        return lay(n.second, second[at], at);
    }

    /** The tree for code on another device. */
    FlatSampler.Tree flatForm() {
        return new FlatSampler.Tree(data, second, parents, leaves);
    }

    /**
     * Splits, beginning with the root, the node with the largest bound, until there are enough nodes: a cut through the tree that depends
     * on the receiver alone. Returns the sum of their importances.
     */
    private double cut(double x, double y, double z, double nx, double ny, double nz, SampledLight c) {
        c.nodes[0] = 0;
        c.weights[0] = 1;
        c.count = 1;
        while (c.count < CUT) {
            int most = mostImportant(c);
            if (most < 0) {
                break;
            }
            int node = c.nodes[most];
            double a = importance(node + 1, x, y, z, nx, ny, nz, c.near);
            double b = importance(second[node], x, y, z, nx, ny, nz, c.near);
            c.nodes[most] = node + 1;
            c.weights[most] = a;
            c.nodes[c.count] = second[node];
            c.weights[c.count++] = b;
        }
        double sum = 0;
        for (int i = 0; i < c.count; i++) {
            sum += c.weights[i];
        }
        return sum;
    }

    /** The index of the most important node that can be split, or −1. */
    private int mostImportant(SampledLight c) {
        int most = -1;
        double largest = 0;
        for (int i = 0; i < c.count; i++) {
            if (c.weights[i] > largest && second[c.nodes[i]] >= 0) {
                largest = c.weights[i];
                most = i;
            }
        }
        return most;
    }

    void choose(double x, double y, double z, double nx, double ny, double nz, double number, SampledLight choice) {
        double all = cut(x, y, z, nx, ny, nz, choice);
        int chosen = choice.pick(all, number);
        if (chosen < 0) {
            return;
        }
        int node = choice.nodes[chosen];
        while (second[node] >= 0) {
            double a = importance(node + 1, x, y, z, nx, ny, nz, choice.near);
            double b = importance(second[node], x, y, z, nx, ny, nz, choice.near);
            double sum = a + b;
            if (!(sum > 0)) {
                choice.none(number);
                return;
            }
            double share = a / sum;
            double rest = choice.rest;
            boolean first = b == 0 || rest < share;
            double part = first ? share : b / sum;
            rest = Math.min(first ? rest / share : (rest - share) / part, Math.nextDown(1.0));
            choice.rest = Math.max(rest, 0);
            choice.probability *= part;
            node = first ? node + 1 : second[node];
        }
        choice.light = -1 - second[node];
    }

    double probability(int light, double x, double y, double z, double nx, double ny, double nz, SampledLight scratch) {
        double all = cut(x, y, z, nx, ny, nz, scratch);
        double probability = 1;
        int node = leaves[light];
        while (true) {
            for (int i = 0; i < scratch.count; i++) {
                if (scratch.nodes[i] == node) {
                    return all > 0 ? probability * (scratch.weights[i] / all) : 0;
                }
            }
            int parent = parents[node];
            boolean first = node == parent + 1;
            double own = importance(node, x, y, z, nx, ny, nz, scratch.near);
            if (!(own > 0)) {
                return 0;
            }
            int sibling = first ? second[parent] : parent + 1;
            probability *= own / (own + importance(sibling, x, y, z, nx, ny, nz, scratch.near));
            node = parent;
        }
    }

    private double importance(
            int node, double x, double y, double z, double nx, double ny, double nz, LightSample near) {
        if (second[node] < 0) {
            return weights.weight(-1 - second[node], x, y, z, nx, ny, nz, near);
        }
        int k = STRIDE * node;
        double dx = data[k] - x;
        double dy = data[k + 1] - y;
        double dz = data[k + 2] - z;
        double radius = data[k + 3];
        double square = dx * dx + dy * dy + dz * dz;
        double strength = data[k + 9] / Math.max(Math.max(square, radius * radius), LightWeights.LEAST_SQUARE);
        if (square <= radius * radius) {
            return strength;
        }
        double inverse = 1 / Math.sqrt(square);
        double sine = radius * inverse;
        double cosine = Math.sqrt(Math.max((1 - sine) * (1 + sine), 0));
        if (nx != 0 || ny != 0 || nz != 0) {
            strength *= atMost((nx * dx + ny * dy + nz * dz) * inverse, cosine, sine);
        }
        double spread = data[k + 7];
        if (spread > -1) {
            double towards = -(data[k + 4] * dx + data[k + 5] * dy + data[k + 6] * dz) * inverse;
            strength *= emitted(towards, spread, data[k + 8], cosine, sine);
        }
        return strength;
    }

    /** An upper bound of cos(max(θ − θb, 0)), clamped at 0, and above 0 where rounding leaves the sign in doubt. */
    private static double atMost(double cos, double ballCosine, double ballSine) {
        if (cos >= ballCosine) {
            return 1;
        }
        double sin = Math.sqrt(Math.max((1 - cos) * (1 + cos), 0));
        return positive(cos * ballCosine + sin * ballSine);
    }

    /** An upper bound of cos(max(θ − θo − θb, 0)), as {@link #atMost}, where θo bounds the angle between normals and axis. */
    private static double emitted(double cos, double cosO, double sinO, double ballCosine, double ballSine) {
        if (cos >= cosO) {
            return 1;
        }
        double sin = Math.sqrt(Math.max((1 - cos) * (1 + cos), 0));
        double less = cos * cosO + sin * sinO;
        if (less >= ballCosine) {
            return 1;
        }
        double lessSine = Math.max(sin * cosO - cos * sinO, 0);
        return positive(less * ballCosine + lessSine * ballSine);
    }

    private static double positive(double cosine) {
        return cosine > -SLACK ? Math.max(cosine, SLACK) : 0;
    }
}
