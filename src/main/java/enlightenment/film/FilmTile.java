package enlightenment.film;

import enlightenment.color.Color;
import enlightenment.color.DisplayCurve;
import java.util.Arrays;

/**
 * Sums of the samples of a rectangle of pixels, of which a billion samples lose nothing, and what the samples tell about their own
 * error.
 */
public final class FilmTile {
    /**
     * Side, in pixels, of the blocks that are surveyed, judged and handed out as one; a power of two. They are cut from the whole
     * picture's corner, so that no crop, tile or worker changes which pixels belong together.
     */
    public static final int BLOCK_SIDE = 8;

    private static final int PER_KNOWN = 4;

    /** Up to this many samples of a pixel are kept one by one. */
    private static final int FEW = 2;

    /** How many numbers are kept of each: place, red, green and blue. */
    static final int PER_SAMPLE = 5;

    public final int x;
    public final int y;
    public final int width;
    public final int height;

    private final PixelSums sums;

    /** Per pixel: the known part of red, green, blue, from which the samples are differences, and {@code ofLight}; null for none. */
    private double[] known;

    private final int[] counts;

    /** Per pixel: {@link SampleSpread#halves} and {@link SampleSpread#quarters}. */
    private final float[] spreads;

    /** Per pixel of one or two samples: place, red, green and blue of each ({@link SampleSpread#at}); null if there is none. */
    private float[] few;

    /** What those tell together; null until it is asked for. */
    private Neighbours neighbours;

    private final DisplayCurve curve;
    private final boolean isLinear;

    /** Per pixel of linear light: {@link QuarterMeans}, without the known part; null for display-referred pixels. */
    private final float[] quarterMeans;

    private long surveyRays;

    /** Samples that were no finite numbers. */
    private long lost;

    /** A tile of display-referred pixels without samples; given as below. */
    public FilmTile(int x, int y, int width, int height) {
        this(x, y, width, height, DisplayCurve.NONE);
    }

    /**
     * A tile without samples.
     *
     * @param x first column in the whole picture
     * @param y first row in the whole picture
     * @param width number of columns
     * @param height number of rows
     * @param curve what samples are, and how they become what a screen takes, whose values errors refer to
     */
    public FilmTile(int x, int y, int width, int height, DisplayCurve curve) {
        this.curve = curve;
        isLinear = curve.encoding() == Color.Encoding.LINEAR;
        quarterMeans = isLinear ? new float[QuarterMeans.PER_PIXEL * width * height] : null;
        this.x = x;
        this.y = y;
        this.width = width;
        this.height = height;
        sums = new PixelSums(width * height);
        counts = new int[width * height];
        spreads = new float[2 * width * height];
    }

    /** Another tile for samples of the same kind, without any. */
    public FilmTile like(int column, int row, int columns, int rows) {
        return new FilmTile(column, row, columns, rows, curve);
    }

    /** Whether samples are linear light. */
    public boolean isLinear() {
        return isLinear;
    }

    /**
     * How many samples of linear light were no finite numbers. They are left out as if they were black: so there must be none, and a
     * report that has some fails the render.
     */
    public long lostSamples() {
        return lost;
    }

    /** Whether a pixel, given by its place in the whole picture, belongs to the tile. */
    public boolean contains(int column, int row) {
        return column >= x && column < x + width && row >= y && row < y + height;
    }

    /** Adds a sample to the pixel in column and row of the whole picture. */
    public void add(int column, int row, double r, double g, double b) {
        int pixel = pixel(column, row);
        if (isLinear && !(Math.abs(r) + Math.abs(g) + Math.abs(b) < Double.POSITIVE_INFINITY)) {
            lost++;
            counts[pixel]++;
            return;
        }
        sums.add(pixel, r, g, b);
        counts[pixel]++;
    }

    /**
     * Says that the pixel's samples are differences from something whose mean over the pixel is known: this colour.
     *
     * @param ofLight the share of the variance of the differences that is expected to come from the choice of light points, 0..1
     */
    public void known(int column, int row, double r, double g, double b, double ofLight) {
        if (known == null) {
            known = new double[PER_KNOWN * width * height];
        }
        int k = PER_KNOWN * pixel(column, row);
        known[k] = r;
        known[k + 1] = g;
        known[k + 2] = b;
        known[k + 3] = ofLight;
    }

    /**
     * Adds the sums, counts and survey rays of a later pass over the same pixels; the sums stay exact to about twice the precision of
     * doubles. What pixels tell of their error is not kept: {@link TilePasses}.
     *
     * @throws IllegalArgumentException if it has other pixels, or the samples of either are differences from something known
     */
    public void merge(FilmTile later) {
        if (later.x != x || later.y != y || later.width != width || later.height != height) {
            throw new IllegalArgumentException("tiles of different places");
        }
        if (known != null || later.known != null) {
            throw new IllegalArgumentException("passes of differences");
        }
        lost += later.lost;
        sums.add(later.sums);
        for (int i = 0; i < counts.length; i++) {
            counts[i] = Math.addExact(counts[i], later.counts[i]);
        }
        surveyRays += later.surveyRays;
    }

    /** Makes this the sum of four parts, each a quarter of the samples, from which the spreads follow as in {@link SampleSpread}. */
    void setQuarters(FilmTile[] quarters) {
        if (surveyRays != 0 || known != null || counts.length > 0 && counts[0] != 0) {
            throw new IllegalArgumentException("a tile with samples");
        }
        double[] means = new double[3 * quarters.length];
        int[] sizes = new int[quarters.length];
        for (int i = 0; i < counts.length; i++) {
            for (int q = 0; q < quarters.length; q++) {
                sizes[q] = quarters[q].counts[i];
                for (int c = 0; c < 3; c++) {
                    means[3 * q + c] = quarters[q].sums.rounded(i, c);
                }
            }
            if (isLinear) {
                QuarterMeans.of(
                        means, sizes[0] + sizes[1] + sizes[2] + sizes[3], quarterMeans, QuarterMeans.PER_PIXEL * i);
            } else {
                spreads[2 * i] = (float) SampleSpread.halves(means, sizes);
                spreads[2 * i + 1] = (float) SampleSpread.quarters(means, sizes);
            }
        }
        FilmTile first = copyOf(quarters[0]);
        first.merge(quarters[1]);
        FilmTile second = copyOf(quarters[2]);
        second.merge(quarters[3]);
        merge(first);
        merge(second);
    }

    private static FilmTile copyOf(FilmTile tile) {
        FilmTile copy = tile.like(tile.x, tile.y, tile.width, tile.height);
        copy.merge(tile);
        return copy;
    }

    /** The sum of the samples of component 0, 1 or 2 of a pixel, rounded; {@link #compensation} has the rest. */
    public double sum(int column, int row, int component) {
        return sums.sum(pixel(column, row), component);
    }

    /** The compensation term of {@link #sum}, to be added to it. */
    public double compensation(int column, int row, int component) {
        return sums.compensation(pixel(column, row), component);
    }

    /**
     * Sets what a pass carries of a pixel.
     *
     * @param values sum and compensation of red, of green and of blue
     * @param from where in {@code values} they begin
     */
    public void put(int column, int row, double[] values, int from, int count) {
        int pixel = pixel(column, row);
        sums.put(pixel, values, from);
        counts[pixel] = count;
    }

    boolean hasPixelWithoutSamples() {
        for (int count : counts) {
            if (count < 1) {
                return true;
            }
        }
        return false;
    }

    /** Whether the samples are differences from something known. */
    public boolean hasKnown() {
        return known != null;
    }

    /** Keeps what the finished samples of a pixel tell about their error. */
    public void spread(int column, int row, SampleSpread spread) {
        int k = 2 * pixel(column, row);
        if (isLinear) {
            spread.quarterMeans(quarterMeans, QuarterMeans.PER_PIXEL / 2 * k);
        } else {
            spreads[k] = (float) spread.halves();
            spreads[k + 1] = (float) spread.quarters();
        }
        if (spread.samples() <= FEW) {
            if (few == null) {
                few = new float[FEW * PER_SAMPLE * width * height];
            }
            spread.samples(few, FEW * PER_SAMPLE * pixel(column, row));
        }
        neighbours = null;
    }

    /** Counts camera rays that are not samples of a pixel of their own. */
    public void addSurveyRays(long rays) {
        surveyRays += rays;
    }

    /** The mean of component 0, 1 or 2 of a pixel; 0 where there are no samples. */
    public double mean(int column, int row, int component) {
        int pixel = pixel(column, row);
        return counts[pixel] == 0 ? 0 : knownPart(pixel, component) + meanDifference(pixel, component);
    }

    private double knownPart(int pixel, int component) {
        return known == null ? 0 : known[PER_KNOWN * pixel + component];
    }

    /** The mean of a component of a pixel, by its index, without the known part; NaN without samples. */
    double meanDifference(int pixel, int component) {
        return sums.rounded(pixel, component) / counts[pixel];
    }

    /** The number of samples of a pixel. */
    public int count(int column, int row) {
        return counts[pixel(column, row)];
    }

    /** Writes place, red, green and blue of the first or second sample of a pixel, by its index. */
    void few(int pixel, int sample, float[] out, int from) {
        if (few == null) {
            Arrays.fill(out, from, from + PER_SAMPLE, Float.NaN);
        } else {
            System.arraycopy(few, PER_SAMPLE * (FEW * pixel + sample), out, from, PER_SAMPLE);
        }
        for (int c = 0; isLinear && c < 3; c++) {
            out[from + 2 + c] = (float) shown(pixel, c, Float.isFinite(out[from + 2 + c]) ? out[from + 2 + c] : 0);
        }
    }

    /** What a difference from the known part, or all of a pixel that has none, changes in what a screen shows. */
    private double shown(int pixel, int component, double value) {
        double part = knownPart(pixel, component);
        return !isLinear ? value : curve.nearly(part + value) - (known == null ? 0 : curve.nearly(part));
    }

    /** The display curve of the pixels. */
    DisplayCurve curve() {
        return curve;
    }

    /** The mean of component 0, 1 or 2 of a pixel as a screen takes it; 0 where there are no samples. */
    public double displayed(int column, int row, int component) {
        return curve.of(mean(column, row, component));
    }

    /**
     * Writes the means of a pixel's quarters, with the known part; only of linear light.
     *
     * @param out gets red, green and blue of each of the four quarters of its samples
     */
    public void quarterMeans(int column, int row, double[] out) {
        int pixel = pixel(column, row);
        for (int i = 0; i < QuarterMeans.PER_PIXEL; i++) {
            out[i] = quarterMeans[QuarterMeans.PER_PIXEL * pixel + i] + knownPart(pixel, i % 3);
        }
    }

    private float spread(int pixel, int column, int row, int figure) {
        if (!isLinear) {
            return spreads[2 * pixel + figure];
        }
        double[] means = new double[QuarterMeans.PER_PIXEL];
        quarterMeans(column, row, means);
        int samples = counts[pixel];
        return (float)
                (figure == 0
                        ? QuarterMeans.halves(curve, means, samples)
                        : QuarterMeans.quarters(curve, means, samples));
    }

    /** The square of the mean without the known part, mean of the components, of a pixel by its index. */
    double squaredMean(int pixel) {
        double sum = 0;
        for (int c = 0; c < 3; c++) {
            double mean = shown(pixel, c, meanDifference(pixel, c));
            sum += mean * mean;
        }
        return sum / 3;
    }

    /**
     * The first figure that the pixel tells of its error: {@link SampleSpread#halves}, or for a single sample
     * {@link Neighbours#single}; of differences as {@link VarianceDecay#ofDifferences} weighs them.
     */
    public float halves(int column, int row) {
        int pixel = pixel(column, row);
        double first = counts[pixel] == 1 ? neighbours().single(column, row) : spread(pixel, column, row, 0);
        return (float)
                (known == null || isLinear
                        ? first
                        : first * VarianceDecay.ofDifferences(counts[pixel], ofLight(pixel)));
    }

    /**
     * The second figure: {@link SampleSpread#quarters}; for a single sample the first again; for two {@link Neighbours#single} less
     * the first, what is left of the variance of one, which may be negative.
     */
    public float quarters(int column, int row) {
        int pixel = pixel(column, row);
        if (counts[pixel] > FEW || counts[pixel] == 0) {
            return spread(pixel, column, row, 1);
        }
        return counts[pixel] == 1
                ? halves(column, row)
                : neighbours().single(column, row) - spread(pixel, column, row, 0);
    }

    private Neighbours neighbours() {
        if (neighbours == null) {
            neighbours = new Neighbours(this);
        }
        return neighbours;
    }

    private double ofLight(int pixel) {
        return known[PER_KNOWN * pixel + 3];
    }

    /** Counts samples of linear light that were not finite and that the caller replaced by black. */
    public void addLostSamples(long samples) {
        lost += samples;
    }

    /** See {@link #addSurveyRays}. */
    public long surveyRays() {
        return surveyRays;
    }

    private int pixel(int column, int row) {
        return (row - y) * width + column - x;
    }
}
