package enlightenment.emitter;

/**
 * A {@link LightSampler} as plain numbers, for code on another device that computes what it does, operation by operation. The arrays are not
 * to be changed.
 *
 * @param indices of the lights, in the sampler's own order
 * @param places in that order, by index
 * @param kinds in that order: 0 is a ball, 1 flat, 2 flat and shining to both sides, 3 curved, 4 a point
 * @param weights in that order, eight for each: centre and radius of the ball, normal, strength
 * @param tree null if all lights are weighed for every receiver
 */
public record FlatSampler(int[] indices, int[] places, int[] kinds, double[] weights, Tree tree) {
    /**
     * The tree of many lights.
     *
     * @param nodes ten numbers for each: centre and radius of the ball, axis of the normals, cosine and sine of their angle, strength
     * @param second the second child of each node, whose first one follows it; −1 − its light for a leaf
     * @param parents of each node; −1 for the root
     * @param leaves by light in the sampler's order
     */
    public record Tree(double[] nodes, int[] second, int[] parents, int[] leaves) {}
}
