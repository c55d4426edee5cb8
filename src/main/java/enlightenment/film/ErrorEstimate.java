package enlightenment.film;

import enlightenment.compiled.ChanceError;
import enlightenment.film.VarianceDecay.Curve;
import enlightenment.film.VarianceDecay.Samples;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;

/**
 * An estimate of a picture's root mean square error from its own samples, with a 95 % confidence interval, in displayed units: 0..1, as a
 * screen shows it.
 *
 * <p>Pixels with the same number of samples, a power of two, are judged together: the sums A and B over their two figures
 * ({@link FilmTile#halves}, {@link FilmTile#quarters}) give the sum of their variances, A times a share that depends on B/A
 * ({@link VarianceDecay}).
 *
 * <p>The interval has three parts. What the shares may be: the smallest and the largest that were found for such a ratio on scenes
 * of many kinds, with the ratio itself as uncertain as its pixels show. Chance: a sum of squares of which few are large errs by
 * factors, once in the estimate and once in the picture, which is one of many. And, where all pixels have about as many samples,
 * what none of them may have met: features of the picture's own contrast in three pixels.
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
     * This many pixels may hide something that none of their n samples has met; in one of 40 pictures it covers at least
     * ln 40/(3 n) of each.
     */
    private static final int HIDING = 3;

    private static final double HIDDEN = 1.23;

    private final float[] variances;
    private final double meanSquare;

    /** Factors of the mean square. */
    private final double least;

    private final double most;

    /** What is added to the largest mean square. */
    private final double unseen;

    private final long pixels;

    /** Of a film of linear light, or null. */
    private final LinearError linear;

    /** The part of the mean square that the samples do not tell. */
    private final double shortfall;

    private ErrorEstimate(float[] variances, double meanSquare, double least, double most, double unseen, long pixels) {
        this(variances, meanSquare, least, most, unseen, pixels, null, 0);
    }

    private ErrorEstimate(
            float[] variances,
            double meanSquare,
            double least,
            double most,
            double unseen,
            long pixels,
            LinearError linear,
            double shortfall) {
        this.variances = variances;
        this.meanSquare = meanSquare;
        this.least = least;
        this.most = most;
        this.unseen = unseen;
        this.pixels = pixels;
        this.linear = linear;
        this.shortfall = shortfall;
    }

    /** The same where some light is left to chance: the samples tell of it only where it was found. */
    public ErrorEstimate with(ChanceError chance) {
        if (!(chance.most() > 0)) {
            return this;
        }
        double told = meanSquare + chance.shortfall();
        LinearError light = linear == null || chance.shortfall() < meanSquare
                ? linear
                : new LinearError(linear.relative(), linear.kurtosis(), true);
        return new ErrorEstimate(
                variances,
                told,
                meanSquare * least / told,
                // As far as it was found it is in what is told.
                Math.max(meanSquare * most, meanSquare + chance.most()) / told,
                unseen,
                pixels,
                light,
                chance.shortfall());
    }

    /** The same with what is told of linear light. */
    ErrorEstimate with(LinearError light) {
        return new ErrorEstimate(variances, meanSquare, least, most, unseen, pixels, light, shortfall);
    }

    /** What is told of linear light; empty for display-referred pictures, and where it is not known. */
    public Optional<LinearError> linear() {
        return Optional.ofNullable(linear);
    }

    /**
     * @param first per pixel {@link FilmTile#halves}
     * @param second per pixel {@link FilmTile#quarters}
     * @param counts per pixel the number of samples, 0 for an unfinished pixel
     * @param kind what the samples are
     * @param contrast the difference between the largest and the smallest component of all pixels, as shown
     */
    static ErrorEstimate of(float[] first, float[] second, int[] counts, Samples kind, double contrast) {
        Level[] levels = levels(first, second, counts, kind);
        float[] variances = new float[first.length];
        double squares = 0;
        long pixels = 0;
        long samples = 0;
        for (int i = 0; i < first.length; i++) {
            if (counts[i] == 0) {
                continue;
            }
            Level level = levels[level(counts[i], kind)];
            double v = level.share * first[i];
            variances[i] = (float) v;
            // Once for the picture itself, and once for the estimate, or twice where pixels share what they tell.
            squares += (counts[i] > 2 ? 2 : 3) * v * v;
            samples += counts[i];
            pixels++;
        }
        double sum = 0;
        double low = 0;
        double high = 0;
        for (Level level : levels) {
            sum += level.share * level.first;
            low += level.least * level.first;
            high += level.most * level.first;
        }
        double n = Math.max(pixels, 1);
        double hidden =
                kind == Samples.DIFFERENCES ? 0 : contrast * Math.min(HIDDEN * pixels / Math.max(samples, 1), 1);
        double unseen = HIDING * hidden * hidden / n;
        if (!(sum > 0)) {
            return new ErrorEstimate(variances, 0, 1, 1, unseen, pixels);
        }
        double chance = StrictMath.exp(TWO_SIDED_95 * deviation(squares / (2 * sum * sum)));
        return new ErrorEstimate(variances, sum / n, low / sum / chance, high / sum * chance, unseen, pixels);
    }

    /**
     * The deviation of the logarithm of the ratio of two sums of squares, each with as many squares of normal numbers as a χ² distribution
     * of 2 m − 1 degrees of freedom: √(2 ψ′(m − ½)).
     *
     * @param inverse 1/m, where m is the number of pixels that carry the sum
     */
    private static double deviation(double inverse) {
        double x = Math.max(1 / inverse, 1) - 0.5;
        // The trigamma function's asymptotic series, at ½ too great by 8 %.
        double trigamma = (1 + (0.5 + 1 / (6 * x)) / x) / x;
        return Math.sqrt(2 * trigamma);
    }

    /**
     * The error of pixels with these variances.
     *
     * @param inverse of the number of pixels that carry the error, as {@link #deviation} has it
     */
    static ErrorEstimate of(double[] variances, double inverse) {
        float[] rounded = new float[variances.length];
        double sum = 0;
        for (int i = 0; i < variances.length; i++) {
            rounded[i] = (float) variances[i];
            sum += variances[i];
        }
        if (!(sum > 0)) {
            return new ErrorEstimate(rounded, 0, 1, 1, 0, variances.length);
        }
        double chance = StrictMath.exp(TWO_SIDED_95 * deviation(inverse));
        return new ErrorEstimate(rounded, sum / variances.length, 1 / chance, chance, 0, variances.length);
    }

    /** The error of some tiles, as if they were all of the picture. */
    public static ErrorEstimate of(List<FilmTile> tiles) {
        int n = 0;
        boolean differences = false;
        boolean light = false;
        for (FilmTile tile : tiles) {
            n += tile.width * tile.height;
            differences |= tile.hasKnown();
            light |= tile.isLinear();
        }
        float[] first = new float[n];
        float[] second = new float[n];
        int[] counts = new int[n];
        Contrast contrast = new Contrast();
        int k = 0;
        for (FilmTile tile : tiles) {
            for (int y = tile.y; y < tile.y + tile.height; y++) {
                for (int x = tile.x; x < tile.x + tile.width; x++) {
                    first[k] = tile.halves(x, y);
                    second[k] = tile.quarters(x, y);
                    counts[k] = tile.count(x, y);
                    if (counts[k++] > 0) {
                        contrast.add(tile.displayed(x, y, 0));
                        contrast.add(tile.displayed(x, y, 1));
                        contrast.add(tile.displayed(x, y, 2));
                    }
                }
            }
        }
        return of(first, second, counts, kind(light, differences), contrast.get());
    }

    static Samples kind(boolean light, boolean differences) {
        return light ? Samples.LIGHT : differences ? Samples.DIFFERENCES : Samples.WHOLE;
    }

    /** The difference between the largest and the smallest of some numbers. */
    static final class Contrast {
        private double least = Double.POSITIVE_INFINITY;
        private double greatest = Double.NEGATIVE_INFINITY;

        void add(double value) {
            least = Math.min(least, value);
            greatest = Math.max(greatest, value);
        }

        double get() {
            return Math.max(greatest - least, 0);
        }
    }

    private static int level(int count, Samples kind) {
        if (count == 3 && kind == Samples.LIGHT) {
            // They tell no more than two.
            return 1;
        }
        return Integer.bitCount(count) == 1 ? Integer.numberOfTrailingZeros(count) : OTHERS;
    }

    private static Level[] levels(float[] first, float[] second, int[] counts, Samples kind) {
        Level[] levels = new Level[LEVELS];
        Arrays.setAll(levels, k -> new Level());
        Level pooled = new Level();
        int least = VarianceDecay.leastPooled(kind);
        for (int i = 0; i < first.length; i++) {
            if (counts[i] > 0) {
                int k = level(counts[i], kind);
                levels[k].add(first[i], second[i]);
                if (k >= least && k != OTHERS) {
                    pooled.add(first[i], second[i]);
                }
            }
        }
        for (int k = 0; k < LEVELS; k++) {
            boolean own = k < 2 || k == OTHERS || levels[k].pixels >= ENOUGH && levels[k].first > 0;
            levels[k].judge(k == OTHERS ? -1 : k, own ? levels[k] : pooled, kind);
        }
        return levels;
    }

    /** The sums over all pixels with the same number of samples, and what follows from them. */
    private static final class Level {
        private double first;
        private double second;
        private double firstSquared;
        private double product;
        private double secondSquared;
        private long pixels;

        /** What is left of the first figure, and at least and at most. */
        private double share = 1;

        private double least = 1;
        private double most = 1;

        void add(double a, double b) {
            first += a;
            second += b;
            firstSquared += a * a;
            product += a * b;
            secondSquared += b * b;
            pixels++;
        }

        double ratio() {
            return first > 0 ? second / first : 0;
        }

        /** How far chance may have taken the ratio, in 95 of 100 cases. */
        double uncertainty() {
            if (!(first > 0)) {
                return 0;
            }
            double r = ratio();
            double squares = secondSquared - 2 * r * product + r * r * firstSquared;
            return TWO_SIDED_95 * Math.sqrt(Math.max(squares, 0)) / first;
        }

        /** @param of the level whose ratio is taken */
        void judge(int level, Level of, Samples kind) {
            double ratio = of.ratio();
            double off = of.uncertainty();
            share = VarianceDecay.share(Curve.MIDDLE, level, ratio, kind);
            // Shares grow or fall with the ratio, or both.
            least = share;
            most = share;
            for (double at : new double[] {ratio - off, ratio + off}) {
                least = Math.min(VarianceDecay.share(Curve.LEAST, level, at, kind), least);
                most = Math.max(VarianceDecay.share(Curve.MOST, level, at, kind), most);
            }
        }
    }

    /** The estimated root mean square error over all finished pixels and components, in displayed units, at least 0. */
    public double rmse() {
        return Math.sqrt(meanSquare);
    }

    /** The part of {@link #rmse} that the samples do not tell, as they lack light: the root of the difference of squares. */
    public double leftToChance() {
        return Math.sqrt(shortfall);
    }

    /** The lower end of a 95 % confidence interval for the true RMSE, in displayed units. */
    public double low() {
        return Math.sqrt(meanSquare * least);
    }

    /** The upper end of that interval. */
    public double high() {
        return Math.sqrt(meanSquare * most + unseen);
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
