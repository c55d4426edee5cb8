package enlightenment.emitter;

/** A light that a {@link LightSampler} has sampled. A mutable work object, one per thread. */
public final class SampledLight {
    /** The light's index in the sampler's list; −1 if no light can contribute. */
    public int light;

    /** The probability with which this light was sampled. */
    public double probability;

    /** The random number that chose, rescaled within the chosen interval so that it is again uniform in [0, 1) and can be reused. */
    public double rest;

    final double[] weights = new double[LightSampler.FEW];

    /** The nodes of a {@link LightTree} that the weights belong to, and their number. */
    final int[] nodes = new int[LightSampler.FEW];

    int count;

    /** Scratch for closed forms of near lights. */
    final LightSample near = new LightSample();

    /** Makes an object without a light. */
    public SampledLight() {}

    /** Samples one of the weights, of which this is the sum, and sets probability and rest; −1, and no light, if all are 0. */
    int pick(double sum, double number) {
        if (!(sum > 0)) {
            none(number);
            return -1;
        }
        double left = number * sum;
        int chosen = -1;
        for (int i = 0; i < count; i++) {
            double w = weights[i];
            if (w > 0) {
                chosen = i;
                if (left < w) {
                    break;
                }
                left -= w;
            }
        }
        probability = weights[chosen] / sum;
        rest = Math.min(left / weights[chosen], Math.nextDown(1.0));
        return chosen;
    }

    void none(double number) {
        light = -1;
        probability = 0;
        rest = number;
    }
}
