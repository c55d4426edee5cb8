package enlightenment.film;

import java.util.List;

/**
 * How far a picture is from the truth, told by its own samples, in display units (0..1).
 *
 * <p>The halves of a pixel give V(n/2) − V(n), its quarters V(n/4) − V(n/2) ({@link SampleSpread}). If V(n/2) = a V(n) and
 * V(n/4) = a b V(n), the halves are (a − 1) V(n) and the ratio of quarters to halves is R = a (b − 1)/(a − 1). Points in the
 * plane are better distributed if their number is a power of four: a and b differ, and change places from one power of two to
 * the next, where the ratio is R' = b (a − 1)/(b − 1). So R R' = a b, and a = (R R' + R)/(1 + R); R and R' are taken from sums
 * over all pixels with such numbers of samples. Independent samples have a = b = 2, well-distributed ones about 3. Pixels with
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

    /** A squared normal number has twice its squared mean as variance, and a third of the mean of its square is that. */
    private static final double OF_ONE_NORMAL = 2.0 / 3;

    /** The same for the mean of two of them: variance 1, mean of the square 2. */
    private static final double OF_TWO_NORMALS = 0.5;

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
        Ratio[] ratios = ratios(halves, quarters, counts);
        Ratio[] others = {pooled(halves, quarters, counts, 1), pooled(halves, quarters, counts, 0)};
        double[] sums = new double[LEVELS];
        float[] variances = new float[halves.length];
        double sum = 0;
        double squares = 0;
        long pixels = 0;
        for (int i = 0; i < halves.length; i++) {
            if (counts[i] == 0) {
                continue;
            }
            int level = level(counts[i]);
            double v = halves[i];
            if (level > 0) {
                v *= ratios[level].factor(others[level % 2]);
                sums[level] += v;
            }
            variances[i] = (float) v;
            sum += v;
            squares += v * v;
            pixels++;
        }
        // Once for the estimate, once for the picture itself, which is one of many.
        double square = 2 * OF_ONE_NORMAL * squares;
        for (int k = 1; k < LEVELS; k++) {
            square += sums[k] * sums[k] * ratios[k].uncertainty();
        }
        double n = Math.max(pixels, 1);
        return new ErrorEstimate(variances, sum / n, Math.sqrt(square) / n, pixels);
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

    /** How fast the variance falls, for each level: from its own pixels where they are many, from all elsewhere. */
    private static Ratio[] ratios(float[] halves, float[] quarters, int[] counts) {
        Ratio[] ratios = new Ratio[LEVELS];
        Ratio pooled = new Ratio();
        for (int k = 0; k < LEVELS; k++) {
            ratios[k] = new Ratio();
        }
        for (int i = 0; i < halves.length; i++) {
            int level = level(counts[i]);
            if (counts[i] >= 4 && level >= 0) {
                ratios[level].add(halves[i], quarters[i]);
                pooled.add(halves[i], quarters[i]);
            }
        }
        for (int k = 0; k < LEVELS; k++) {
            ratios[k] = ratios[k].pixels >= ENOUGH && ratios[k].halves > 0 ? ratios[k] : pooled;
        }
        return ratios;
    }

    /** The ratio over all pixels with an even or an odd power of two of samples, or null if they are few. */
    private static Ratio pooled(float[] halves, float[] quarters, int[] counts, int parity) {
        Ratio pool = new Ratio();
        for (int i = 0; i < halves.length; i++) {
            int level = level(counts[i]);
            if (level >= 2 && level % 2 == parity) {
                pool.add(halves[i], quarters[i]);
            }
        }
        return pool.pixels >= ENOUGH && pool.halves > 0 ? pool : null;
    }

    /** The sum of quarters over that of halves, and what is known about its own error. */
    private static final class Ratio {
        private double halves;
        private double quarters;
        private double halvesSquared;
        private double quartersSquared;
        private long pixels;

        void add(double h, double q) {
            halves += h;
            quarters += q;
            halvesSquared += h * h;
            quartersSquared += q * q;
            pixels++;
        }

        private double value() {
            double ratio = halves > 0 ? quarters / halves : INDEPENDENT;
            return Math.min(Math.max(ratio, INDEPENDENT), FASTEST);
        }

        /** What the halves are to be multiplied by to be the variance, given the ratio one power of two away, or null. */
        double factor(Ratio other) {
            double r = value();
            double fall = other == null ? r : (r * other.value() + r) / (1 + r);
            return 1 / (Math.min(Math.max(fall, INDEPENDENT), FASTEST) - 1);
        }

        /**
         * The squared relative error of a sum of halves times this factor, beyond that of the halves: with
         * V = H/(Q/H − 1) and s = ρ/(ρ − 1) it is dV/V = (1 + s) dH/H − s dQ/Q.
         */
        double uncertainty() {
            if (!(halves > 0 && quarters > 0)) {
                return 0;
            }
            double s = value() / (value() - 1);
            double ofHalves = OF_ONE_NORMAL * halvesSquared / (halves * halves);
            double ofQuarters = OF_TWO_NORMALS * quartersSquared / (quarters * quarters);
            return (s * s + 2 * s) * ofHalves + s * s * ofQuarters;
        }
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
