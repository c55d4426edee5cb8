package enlightenment.film;

import enlightenment.film.VarianceDecay.Samples;
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
 * what none of them may have met: features of the picture's own contrast in three pixels. That of linear light is a
 * {@link LightInterval}, and what it may have missed is white.
 */
public final class ErrorEstimate {
    /** 97.5 % of a normal distribution lie below this many deviations. */
    static final double TWO_SIDED_95 = 1.96;

    /**
     * This many pixels may hide something that none of their n samples has met; in one of 40 pictures it covers at least
     * ln 40/(3 n) of each.
     */
    private static final int HIDING = 3;

    private static final double HIDDEN = 1.23;

    /** The most that a screen shows. */
    private static final double WHITE = 1;

    /** Null where they do not fit in memory. */
    private final float[] variances;

    private final double meanSquare;

    /** Factors of the mean square. */
    private final double least;

    private final double most;

    /** Added to the upper end of the mean square's interval. */
    private final double unseen;

    private final long pixels;

    /** The error of linear light, or null. */
    private final LinearError linear;

    private ErrorEstimate(float[] variances, double meanSquare, double least, double most, double unseen, long pixels) {
        this(variances, meanSquare, least, most, unseen, pixels, null);
    }

    private ErrorEstimate(
            float[] variances,
            double meanSquare,
            double least,
            double most,
            double unseen,
            long pixels,
            LinearError linear) {
        this.variances = variances;
        this.meanSquare = meanSquare;
        this.least = least;
        this.most = most;
        this.unseen = unseen;
        this.pixels = pixels;
        this.linear = linear;
    }

    /** This estimate with that of the linear light. */
    ErrorEstimate with(LinearError light) {
        return new ErrorEstimate(variances, meanSquare, least, most, unseen, pixels, light);
    }

    /** The error of linear light; empty for display-referred pictures, and where it is not known. */
    public Optional<LinearError> linear() {
        return Optional.ofNullable(linear);
    }

    /** Sums over the pixels of a picture, and the variance of each where they fit in memory. */
    private static final class Sums implements PixelFigures.Visitor {
        final SampleLevel[] levels;
        final Samples kind;

        /** Null if they do not fit. */
        final float[] variances;

        double squares;
        long pixels;
        long samples;
        private int next;

        Sums(SampleLevel[] levels, Samples kind, PixelFigures figures) {
            this.levels = levels;
            this.kind = kind;
            variances = figures.pixelsInMemory() > 0 ? new float[figures.pixelsInMemory()] : null;
            figures.forEach(this);
        }

        @Override
        public void pixel(float first, float second, int count, boolean rare) {
            double v = count == 0 ? 0 : SampleLevel.of(levels, count, kind).share() * first;
            if (variances != null) {
                variances[next++] = (float) v;
            }
            if (count > 0) {
                // Once for the picture itself, and once for the estimate, or twice where pixels share what they tell.
                squares += (count > 2 ? 2 : 3) * v * v;
                samples += count;
                pixels++;
            }
        }
    }

    /**
     * The error of a picture of display-referred pixels.
     *
     * @param kind what the samples are: no linear light
     * @param contrast the difference between the largest and the smallest component of all pixels, as shown
     */
    static ErrorEstimate of(PixelFigures figures, Samples kind, double contrast) {
        SampleLevel[] levels = SampleLevel.of(figures, kind);
        Sums all = new Sums(levels, kind, figures);
        double sum = 0;
        double low = 0;
        double high = 0;
        for (SampleLevel level : levels) {
            sum += level.share() * level.first();
            low += level.least() * level.first();
            high += level.most() * level.first();
        }
        double n = Math.max(all.pixels, 1);
        double unseen = kind == Samples.DIFFERENCES ? 0 : unseen(all.pixels, all.samples, contrast);
        if (!(sum > 0)) {
            return new ErrorEstimate(all.variances, 0, 1, 1, unseen, all.pixels);
        }
        double chance = StrictMath.exp(TWO_SIDED_95 * deviation(all.squares / (2 * sum * sum)));
        return new ErrorEstimate(all.variances, sum / n, low / sum / chance, high / sum * chance, unseen, all.pixels);
    }

    /** As {@link #of(PixelFigures, Samples, double)}, of linear light ({@link LightInterval}). */
    static ErrorEstimate ofLight(PixelFigures figures) {
        SampleLevel[] levels = SampleLevel.of(figures, Samples.LIGHT);
        Sums all = new Sums(levels, Samples.LIGHT, figures);
        double sum = 0;
        for (SampleLevel level : levels) {
            sum += level.share() * level.first();
        }
        double n = Math.max(all.pixels, 1);
        // What lights a picture is brighter than what it shows: even of a black one a pixel may be white.
        double unseen = unseen(all.pixels, all.samples, WHITE);
        LightInterval interval = LightInterval.of(levels, figures);
        if (!(sum > 0)) {
            return new ErrorEstimate(all.variances, 0, 1, 1, unseen + interval.high() / n, all.pixels);
        }
        double least = Math.min(interval.low() / sum, 1);
        double most = Math.max(interval.high() / sum, 1);
        return new ErrorEstimate(all.variances, sum / n, least, most, unseen, all.pixels);
    }

    /** The mean square of what no sample may have met. */
    private static double unseen(long pixels, long samples, double contrast) {
        double hidden = contrast * Math.min(HIDDEN * pixels / Math.max(samples, 1), 1);
        return Math.min(HIDING, pixels) * hidden * hidden / Math.max(pixels, 1);
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
        boolean[] rare = new boolean[n];
        double[] means = new double[QuarterMeans.PER_PIXEL];
        Contrast contrast = new Contrast();
        int k = 0;
        for (FilmTile tile : tiles) {
            for (int y = tile.y; y < tile.y + tile.height; y++) {
                for (int x = tile.x; x < tile.x + tile.width; x++) {
                    first[k] = tile.halves(x, y);
                    second[k] = tile.quarters(x, y);
                    counts[k] = tile.count(x, y);
                    if (light) {
                        tile.quarterMeans(x, y, means);
                        rare[k] = QuarterMeans.isRare(tile.curve(), means, counts[k]);
                    } else if (counts[k] > 0) {
                        contrast.add(tile.displayed(x, y, 0));
                        contrast.add(tile.displayed(x, y, 1));
                        contrast.add(tile.displayed(x, y, 2));
                    }
                    k++;
                }
            }
        }
        PixelFigures figures = PixelFigures.of(first, second, counts, rare);
        return light ? ofLight(figures) : of(figures, kind(differences), contrast.get());
    }

    /** The kind of samples of a display-referred film. */
    static Samples kind(boolean differences) {
        return differences ? Samples.DIFFERENCES : Samples.WHOLE;
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

    /** The estimated root mean square error over all finished pixels and components, in displayed units, at least 0. */
    public double rmse() {
        return Math.sqrt(meanSquare);
    }

    /** The lower end of a 95 % confidence interval for the true RMSE, in displayed units. */
    public double low() {
        return Math.sqrt(meanSquare * least);
    }

    /** The upper end of that interval. */
    public double high() {
        double square = meanSquare * most + unseen;
        // Nothing that a screen shows is off by more than white is from black; what is display-referred may be whiter
        // in a file.
        return Math.sqrt(linear == null ? square : Math.min(square, WHITE));
    }

    /**
     * The estimated variance of each pixel, row by row; of a single pixel it is a rough guess.
     *
     * @throws IllegalStateException if the film is in a file
     */
    public float[] variances() {
        if (variances == null) {
            throw new IllegalStateException("the pixels do not fit in memory");
        }
        return variances.clone();
    }

    /** The number of pixels that the estimate covers. */
    public long pixels() {
        return pixels;
    }
}
