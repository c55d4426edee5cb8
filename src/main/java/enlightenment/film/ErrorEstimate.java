package enlightenment.film;

import java.util.Arrays;
import java.util.List;

/**
 * How far a picture is from the truth, told by its own samples, in display units (0..1).
 *
 * <p>Pixels with the same number of samples, a power of two, are judged together: the sums A and B over their two figures
 * ({@link FilmTile#halves}, {@link FilmTile#quarters}) give the sum of their variances, A times a share that depends on B/A
 * ({@link Remainder}). Pixels with other numbers of samples are taken as if their samples were independent, which errs on the
 * side of caution.
 */
public final class ErrorEstimate {
    /** Levels of 2^0 .. 2^30 samples, and one for other numbers. */
    private static final int LEVELS = 32;

    private static final int OTHERS = LEVELS - 1;

    /** With fewer pixels than this a ratio of their halves and quarters says little, and that of all pixels is taken. */
    private static final int ENOUGH = 200;

    /** 97.5 % of a normal distribution lie below this many deviations. */
    private static final double TWO_SIDED_95 = 1.96;

    /**
     * The relative deviation of the mean square that comes from the shares: another scene's samples fall otherwise than those
     * that they were fitted to.
     */
    private static final double OF_SHARES = 0.15;

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

    /**
     * @param first per pixel {@link FilmTile#halves}
     * @param second per pixel {@link FilmTile#quarters}
     * @param counts per pixel the number of samples, 0 for an unfinished pixel
     * @param differences whether the samples are differences from a known part
     */
    static ErrorEstimate of(float[] first, float[] second, int[] counts, boolean differences) {
        Level[] levels = levels(first, second, counts, differences);
        float[] variances = new float[first.length];
        double sum = 0;
        double squares = 0;
        long pixels = 0;
        for (int i = 0; i < first.length; i++) {
            if (counts[i] == 0) {
                continue;
            }
            Level level = levels[level(counts[i])];
            double v = level.share * first[i];
            variances[i] = (float) v;
            sum += v;
            double influence = level.ofFirst * first[i] + level.ofSecond * second[i];
            // Once for the estimate, once for the picture itself, which is one of many.
            squares += v * v + influence * influence;
            pixels++;
        }
        double n = Math.max(pixels, 1);
        double ofShares = OF_SHARES * sum;
        return new ErrorEstimate(variances, sum / n, Math.sqrt(squares + ofShares * ofShares) / n, pixels);
    }

    /** The error of some tiles, as if they were all of the picture. */
    public static ErrorEstimate of(List<FilmTile> tiles) {
        int n = 0;
        boolean differences = false;
        for (FilmTile tile : tiles) {
            n += tile.width * tile.height;
            differences |= tile.hasKnown();
        }
        float[] first = new float[n];
        float[] second = new float[n];
        int[] counts = new int[n];
        int k = 0;
        for (FilmTile tile : tiles) {
            for (int y = tile.y; y < tile.y + tile.height; y++) {
                for (int x = tile.x; x < tile.x + tile.width; x++) {
                    first[k] = tile.halves(x, y);
                    second[k] = tile.quarters(x, y);
                    counts[k++] = tile.count(x, y);
                }
            }
        }
        return of(first, second, counts, differences);
    }

    private static int level(int count) {
        return Integer.bitCount(count) == 1 ? Integer.numberOfTrailingZeros(count) : OTHERS;
    }

    private static Level[] levels(float[] first, float[] second, int[] counts, boolean differences) {
        Level[] levels = new Level[LEVELS];
        Arrays.setAll(levels, k -> new Level());
        Level pooled = new Level();
        int least = Remainder.leastPooled(differences);
        for (int i = 0; i < first.length; i++) {
            if (counts[i] > 0) {
                int k = level(counts[i]);
                levels[k].add(first[i], second[i]);
                if (k >= least && k != OTHERS) {
                    pooled.add(first[i], second[i]);
                }
            }
        }
        for (int k = 0; k < OTHERS; k++) {
            Level of = k < 2 || levels[k].pixels >= ENOUGH && levels[k].first > 0 ? levels[k] : pooled;
            levels[k].judge(k, k < 2 ? of.cautiousRatio() : of.ratio(), differences);
        }
        return levels;
    }

    /** The sums over all pixels with the same number of samples, and what follows from them. */
    private static final class Level {
        private double first;
        private double second;
        private double firstSquared;
        private long pixels;

        /** What is left of the first figure, and the derivatives of the sum of variances by the two sums. */
        private double share = 1;

        private double ofFirst = 1;
        private double ofSecond;

        void add(double a, double b) {
            first += a;
            second += b;
            firstSquared += a * a;
            pixels++;
        }

        double ratio() {
            return first > 0 ? second / first : 0;
        }

        /** The ratio with what chance may have taken from it, if so many pixels carry the sum. */
        double cautiousRatio() {
            return first > 0 ? ratio() + Math.sqrt(firstSquared) / first : 1;
        }

        void judge(int level, double ratio, boolean differences) {
            double step = 1.0 / (1 << 10);
            share = Remainder.share(level, ratio, differences);
            double slope = (Remainder.share(level, ratio + step, differences)
                            - Remainder.share(level, ratio - step, differences))
                    / (2 * step);
            ofFirst = share - ratio * slope;
            ofSecond = slope;
        }
    }

    /** Estimated root mean square error over all finished pixels and components. */
    public double rmse() {
        return Math.sqrt(meanSquare);
    }

    /** The lower end of an interval that holds the true error in 95 of 100 pictures. */
    public double low() {
        return rmse() / spread();
    }

    /** The upper end of that interval. */
    public double high() {
        return rmse() * spread();
    }

    /** The interval is one of the logarithm: a sum of squares of which few are great errs by factors. */
    private double spread() {
        double deviation = meanSquare > 0 ? deviationOfMeanSquare / meanSquare : 0;
        return StrictMath.exp(TWO_SIDED_95 * deviation / 2);
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
