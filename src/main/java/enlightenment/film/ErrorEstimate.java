package enlightenment.film;

import java.util.List;

/**
 * How far a picture is from the truth, told by its own samples, in display units (0..1).
 *
 * <p>The halves of a pixel give V(n/2) − V(n), its quarters V(n/4) − V(n/2) ({@link SampleSpread}). Pooled over all pixels of
 * as many samples, their ratio ρ says how fast the variance falls where samples double; with V(n/2) = ρ V(n) the halves give
 * V(n) = halves/(ρ − 1). Independent samples have ρ = 2, well-distributed ones about 3 at edges and 4 in between. Pixels with
 * one sample are compared with their neighbours, and those with numbers of samples that are no power of two are taken as if
 * their samples were independent: both err on the side of caution.
 */
public final class ErrorEstimate {
    /** Levels of 2^0 .. 2^30 samples. */
    private static final int LEVELS = 31;

    private static final double INDEPENDENT = 2;

    /** Faster than this the variance of a mean over a square cannot fall but by chance. */
    private static final double FASTEST = 8;

    /** With fewer pixels than this a ratio of their sums says little. */
    private static final int ENOUGH = 200;

    /** 97.5 % of a normal distribution lie below this many deviations. */
    private static final double TWO_SIDED_95 = 1.96;

    private final float[] variances;
    private final double meanSquare;
    private final double deviationOfMeanSquare;
    private final long pixels;

    private ErrorEstimate(float[] variances, double meanSquare, double deviation, long pixels) {
        this.variances = variances;
        this.meanSquare = meanSquare;
        deviationOfMeanSquare = deviation;
        this.pixels = pixels;
    }

    static ErrorEstimate of(float[] halves, float[] quarters, int[] counts) {
        double[] perLevel = factors(halves, quarters, counts);
        float[] variances = new float[halves.length];
        double sum = 0;
        double squares = 0;
        long pixels = 0;
        for (int i = 0; i < halves.length; i++) {
            if (counts[i] == 0) {
                continue;
            }
            int level = level(counts[i]);
            double v = halves[i] * (level < 0 ? 1 : perLevel[level]);
            variances[i] = (float) v;
            sum += v;
            squares += v * v;
            pixels++;
        }
        double n = Math.max(pixels, 1);
        // A squared normal number has twice its squared mean as variance, and a third of the mean of its square is
        // that.
        // Once for the estimate, once for the picture itself, which is one of many.
        double deviation = Math.sqrt(2 * squares * 2 / 3) / n;
        return new ErrorEstimate(variances, sum / n, deviation, pixels);
    }

    /** The error of some tiles, as if they were all of the picture. */
    public static ErrorEstimate of(List<FilmTile> tiles) {
        int n = 0;
        for (FilmTile tile : tiles) {
            n += tile.width * tile.height;
        }
        float[] halves = new float[n];
        float[] quarters = new float[n];
        int[] counts = new int[n];
        int k = 0;
        for (FilmTile tile : tiles) {
            for (int y = tile.y; y < tile.y + tile.height; y++) {
                for (int x = tile.x; x < tile.x + tile.width; x++) {
                    halves[k] = tile.halves(x, y);
                    quarters[k] = tile.quarters(x, y);
                    counts[k++] = tile.count(x, y);
                }
            }
        }
        return of(halves, quarters, counts);
    }

    private static int level(int count) {
        return Integer.bitCount(count) == 1 ? Integer.numberOfTrailingZeros(count) : -1;
    }

    /** What the halves are to be multiplied by, for each level. */
    private static double[] factors(float[] halves, float[] quarters, int[] counts) {
        double[] h = new double[LEVELS];
        double[] q = new double[LEVELS];
        long[] n = new long[LEVELS];
        for (int i = 0; i < halves.length; i++) {
            int level = level(counts[i]);
            if (counts[i] >= 4 && level >= 0) {
                h[level] += halves[i];
                q[level] += quarters[i];
                n[level]++;
            }
        }
        double[] factors = new double[LEVELS];
        factors[0] = 1;
        for (int k = 1; k < LEVELS; k++) {
            double ratio = n[k] >= ENOUGH && h[k] > 0 ? q[k] / h[k] : pooledRatio(h, q);
            factors[k] = 1 / (Math.min(Math.max(ratio, INDEPENDENT), FASTEST) - 1);
        }
        return factors;
    }

    private static double pooledRatio(double[] h, double[] q) {
        double sumH = 0;
        double sumQ = 0;
        for (int k = 0; k < LEVELS; k++) {
            sumH += h[k];
            sumQ += q[k];
        }
        return sumH > 0 ? sumQ / sumH : INDEPENDENT;
    }

    /** Estimated root mean square error over all finished pixels and components. */
    public double rmse() {
        return Math.sqrt(meanSquare);
    }

    /** The lower end of an interval that holds the true error in 95 of 100 pictures. */
    public double low() {
        return Math.sqrt(Math.max(meanSquare - TWO_SIDED_95 * deviationOfMeanSquare, 0));
    }

    /** The upper end of that interval. */
    public double high() {
        return Math.sqrt(meanSquare + TWO_SIDED_95 * deviationOfMeanSquare);
    }

    /** The estimated variance of each pixel, row by row; of a single pixel it is a rough guess. */
    public float[] variances() {
        return variances.clone();
    }

    /** How many pixels it is the error of. */
    public long pixels() {
        return pixels;
    }
}
