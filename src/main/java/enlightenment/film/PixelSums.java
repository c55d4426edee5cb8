package enlightenment.film;

/**
 * For each of some pixels the sums of its samples' red, green and blue, each with a compensation of what rounding took from it: so a
 * billion samples lose nothing (A. Neumaier, "Rounding error analysis of some methods for summing finite sums", 1974).
 */
final class PixelSums {
    private static final int PER_PIXEL = 6;

    /** Per pixel: sum and compensation of red, green, blue. */
    private final double[] sums;

    /** Sums of nothing yet. */
    PixelSums(int pixels) {
        sums = new double[PER_PIXEL * pixels];
    }

    /** Adds a sample of a pixel. */
    void add(int pixel, double r, double g, double b) {
        int k = PER_PIXEL * pixel;
        accumulate(k, r);
        accumulate(k + 2, g);
        accumulate(k + 4, b);
    }

    private void accumulate(int k, double v) {
        double sum = sums[k];
        double t = sum + v;
        sums[k + 1] += Math.abs(sum) >= Math.abs(v) ? (sum - t) + v : (v - t) + sum;
        sums[k] = t;
    }

    /**
     * Adds the sums of other samples of the same pixels. They stay exact to about twice the precision of doubles (T. J. Dekker, "A
     * floating-point technique for extending the available precision", 1971; the exact sum of two is D. E. Knuth's).
     */
    void add(PixelSums later) {
        for (int k = 0; k < sums.length; k += 2) {
            double a = sums[k];
            double b = later.sums[k];
            double t = a + b;
            double c = t - a;
            sums[k] = t;
            sums[k + 1] += later.sums[k + 1] + ((a - (t - c)) + (b - c));
        }
    }

    /** The sum of component 0, 1 or 2 of a pixel, as a single number. */
    double rounded(int pixel, int component) {
        int k = PER_PIXEL * pixel + 2 * component;
        return sums[k] + sums[k + 1];
    }

    /** The sum without what has to be added to it. */
    double sum(int pixel, int component) {
        return sums[PER_PIXEL * pixel + 2 * component];
    }

    /** The compensation term of {@link #sum}, to be added to it. */
    double compensation(int pixel, int component) {
        return sums[PER_PIXEL * pixel + 2 * component + 1];
    }

    /**
     * Sets the sums of a pixel.
     *
     * @param values sum and compensation of red, of green and of blue
     * @param from where in {@code values} they begin
     */
    void put(int pixel, double[] values, int from) {
        System.arraycopy(values, from, sums, PER_PIXEL * pixel, PER_PIXEL);
    }
}
