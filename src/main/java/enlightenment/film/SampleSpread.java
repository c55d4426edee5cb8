package enlightenment.film;

import java.util.Arrays;

/**
 * What the samples of one pixel tell about the error of their mean, when they come from a sequence whose runs of 2^k points
 * are each as well distributed as the next.
 *
 * <p>Let V(n) be the variance of the mean of n = 2^k points. Two runs of n/2 that together make a run of n have means A and
 * B whose covariance follows from V(n) = (V(n/2) + Cov)/2; so the expectation of (A − B)²/4 is exactly V(n/2) − V(n),
 * however strongly the halves depend on each other. That of the quarters, in the same way, is V(n/4) − V(n/2). Their
 * ratio tells how fast V falls, and so V(n) itself: {@link ErrorEstimate}.
 */
public final class SampleSpread {
    private static final int QUARTERS = 4;

    private final double[] sums = new double[3 * QUARTERS];
    private final int[] sizes = new int[QUARTERS];
    private final double[] places = new double[4];
    private int count;
    private int taken;
    private int quarter;

    /** The spread of no samples. */
    public SampleSpread() {}

    /** Starts over, with a pixel of this many samples. */
    public void begin(int samples) {
        count = samples;
        taken = 0;
        quarter = 0;
        Arrays.fill(sums, 0);
        Arrays.fill(sizes, 0);
        Arrays.fill(places, Double.NaN);
    }

    /** Sets the place of the next sample in the pixel, 0..1 from the left and from above. The places of the first two are kept. */
    public void at(double x, double y) {
        if (taken < 2) {
            places[2 * taken] = x;
            places[2 * taken + 1] = y;
        }
    }

    /** Adds the next sample. */
    public void add(double r, double g, double b) {
        // The same as QUARTERS · taken / count, without a division for each sample.
        while ((long) QUARTERS * taken >= (quarter + 1L) * count) {
            quarter++;
        }
        taken++;
        int k = 3 * quarter;
        sums[k] += r;
        sums[k + 1] += g;
        sums[k + 2] += b;
        sizes[quarter]++;
    }

    /**
     * Takes the next samples from their sum: all of those that are to come of a quarter, or some of the first.
     *
     * @param number how many
     * @param from where in {@code sum} red, green and blue are
     */
    void goOn(int number, double[] sum, int from) {
        while ((long) QUARTERS * taken >= (quarter + 1L) * count) {
            quarter++;
        }
        System.arraycopy(sum, from, sums, 3 * quarter, 3);
        sizes[quarter] = number;
        taken += number;
    }

    /** (A − B)²/4 for the means A, B of the two halves, mean of the components; 0 for less than two samples. */
    public double halves() {
        return count < 2 ? 0 : halves(sums, sizes);
    }

    /** {@link #halves()} for sums and sizes of the four quarters, neither half empty. */
    static double halves(double[] sums, int[] sizes) {
        double first = 1.0 / (sizes[0] + sizes[1]);
        double second = 1.0 / (sizes[2] + sizes[3]);
        double sum = 0;
        for (int c = 0; c < 3; c++) {
            double d = (sums[c] + sums[3 + c]) * first - (sums[6 + c] + sums[9 + c]) * second;
            sum += d * d;
        }
        return sum / 12;
    }

    /** {@link #halves()} taken for the quarters of each half, mean of both; 0 for less than four samples. */
    public double quarters() {
        return count < QUARTERS ? 0 : quarters(sums, sizes);
    }

    /** {@link #quarters()} for sums and sizes of the four quarters, none of them empty. */
    static double quarters(double[] sums, int[] sizes) {
        return (difference(sums, sizes, 0) + difference(sums, sizes, 2)) / 24;
    }

    /** Writes the means of the four quarters, as {@link QuarterMeans#of}. */
    void quarterMeans(float[] out, int from) {
        QuarterMeans.of(sums, count, out, from);
    }

    /** The number of samples of the pixel. */
    int samples() {
        return count;
    }

    /** Writes place, red, green and blue of each of one or two samples. */
    void samples(float[] out, int from) {
        for (int s = 0; s < count; s++) {
            int k = from + 5 * s;
            out[k] = (float) places[2 * s];
            out[k + 1] = (float) places[2 * s + 1];
            // The second of two is the third quarter.
            for (int c = 0; c < 3; c++) {
                out[k + 2 + c] = (float) sums[6 * s + c];
            }
        }
    }

    private static double difference(double[] sums, int[] sizes, int quarter) {
        double sum = 0;
        for (int c = 0; c < 3; c++) {
            double d = sums[3 * quarter + c] / sizes[quarter] - sums[3 * quarter + 3 + c] / sizes[quarter + 1];
            sum += d * d;
        }
        return sum;
    }
}
