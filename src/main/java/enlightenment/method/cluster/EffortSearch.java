package enlightenment.method.cluster;

import java.util.function.DoubleUnaryOperator;

/** Finds the effort that leads to a number of samples. */
public final class EffortSearch {
    public static final double LEAST_EFFORT = 1;

    /** Binary logarithm of the largest effort: smaller variances are below the rounding of pixels. */
    private static final int MOST_EFFORT = 128;

    /**
     * The number of bisections of the interval of logarithms: where all pixels need the same, a step of samples is crossed within 1/64 of
     * it.
     */
    private static final int HALVINGS = 19;

    private EffortSearch() {}

    /**
     * The largest effort that costs at most this many samples; at least the smallest one, whatever it costs.
     *
     * @param cost the number of samples that an effort costs; grows with it
     */
    public static double effort(DoubleUnaryOperator cost, double samples) {
        return power(search(cost, samples));
    }

    /** The effort that costs nearly this many samples, or one step more if that is nearer: with few pixels steps are large. */
    public static double nearest(DoubleUnaryOperator cost, double samples) {
        double low = search(cost, samples);
        double below = power(low);
        double above = power(low + Math.scalb((double) MOST_EFFORT, -HALVINGS));
        return cost.applyAsDouble(above) - samples < samples - cost.applyAsDouble(below) ? above : below;
    }

    private static double search(DoubleUnaryOperator cost, double samples) {
        double low = 0;
        double high = MOST_EFFORT;
        for (int k = 0; k < HALVINGS; k++) {
            double middle = (low + high) / 2;
            if (cost.applyAsDouble(power(middle)) <= samples) {
                low = middle;
            } else {
                high = middle;
            }
        }
        return low;
    }

    private static double power(double exponent) {
        int whole = (int) exponent;
        // Between powers of two it is linear in the exponent: the effort need only grow.
        return Math.scalb(1 + (exponent - whole), whole);
    }
}
