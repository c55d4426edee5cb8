package enlightenment.film;

import enlightenment.color.DisplayCurve;
import enlightenment.color.Encoding;
import enlightenment.image.Image;

/**
 * The picture in the making: the mean of each finished pixel, and what its samples tell about the error of that. Tiles
 * cover disjoint pixels, so the order in which threads put them does not matter.
 */
public final class Film {
    /** Of a pixel's light, to tell the slope of the curve there. */
    private static final double STEP = 1.0 / 64;

    public final int x;
    public final int y;
    public final int width;
    public final int height;
    private final DisplayCurve curve;
    private final double[] rgb;

    /** Per pixel; see {@link FilmTile#halves} and {@link FilmTile#quarters}. Of linear light only where there are one or two samples. */
    private final float[] halves;

    private final float[] quarters;
    private final int[] counts;

    /** Per pixel of linear light: means of the quarters of its samples; null for display-referred pixels. */
    private final float[] quarterMeans;

    /** What was splatted over pixels of one to three samples of linear light, of which those tell too little; null for nothing. */
    private FewSamplesSplats fewSplats;

    private long surveyRays;
    private long lost;
    private boolean differences;

    /** A film for a rectangle of the whole picture, display-referred. */
    public Film(int x, int y, int width, int height) {
        this(x, y, width, height, DisplayCurve.NONE);
    }

    /**
     * A film for a rectangle of the whole picture.
     *
     * @param curve what pixels are, and how they become what a screen takes
     */
    public Film(int x, int y, int width, int height, DisplayCurve curve) {
        this.curve = curve;
        this.x = x;
        this.y = y;
        this.width = width;
        this.height = height;
        int pixels = width * height;
        rgb = new double[Math.toIntExact(3L * width * height)];
        halves = new float[pixels];
        quarters = new float[pixels];
        counts = new int[pixels];
        quarterMeans = isLinear() ? new float[Math.multiplyExact(QuarterMeans.PER_PIXEL, pixels)] : null;
    }

    /** What the pixels mean. */
    public Encoding encoding() {
        return curve.encoding();
    }

    private boolean isLinear() {
        return curve.encoding() == Encoding.LINEAR;
    }

    /** Puts a finished tile. */
    public void put(FilmTile tile) {
        double[] means = new double[QuarterMeans.PER_PIXEL];
        for (int row = tile.y; row < tile.y + tile.height; row++) {
            for (int column = tile.x; column < tile.x + tile.width; column++) {
                put(tile, column, row, means);
            }
        }
        add(tile.surveyRays(), tile.hasKnown(), tile.lostSamples());
    }

    /** @param means for use */
    private void put(FilmTile tile, int column, int row, double[] means) {
        int pixel = pixel(column, row);
        for (int c = 0; c < 3; c++) {
            rgb[3 * pixel + c] = tile.mean(column, row, c);
        }
        int count = tile.count(column, row);
        counts[pixel] = count;
        if (isLinear()) {
            tile.quarterMeans(column, row, means);
            keep(pixel, means);
        }
        // Of more samples of linear light the figures follow from the quarters, in the end.
        if (!isLinear() || count <= 2) {
            halves[pixel] = tile.halves(column, row);
            quarters[pixel] = tile.quarters(column, row);
        }
    }

    private void keep(int pixel, double[] means) {
        for (int i = 0; i < QuarterMeans.PER_PIXEL; i++) {
            quarterMeans[QuarterMeans.PER_PIXEL * pixel + i] = (float) means[i];
        }
    }

    /**
     * Puts a finished pixel, given by its place in the whole picture; 0 samples make it unfinished.
     *
     * @param means the means of red, green and blue
     * @param from where in {@code means} they are
     */
    public void put(int column, int row, double[] means, int from, float half, float quarter, int samples) {
        int pixel = pixel(column, row);
        System.arraycopy(means, from, rgb, 3 * pixel, 3);
        halves[pixel] = half;
        quarters[pixel] = quarter;
        counts[pixel] = samples;
    }

    /**
     * Puts a finished pixel of linear light, as {@link #put(int, int, double[], int, float, float, int)}.
     *
     * @param ofQuarters as {@link FilmTile#quarterMeans} writes them
     */
    public void put(int column, int row, double[] means, float half, float quarter, double[] ofQuarters, int samples) {
        put(column, row, means, 0, half, quarter, samples);
        keep(pixel(column, row), ofQuarters);
    }

    private synchronized void add(long rays, boolean known, long lostSamples) {
        surveyRays += rays;
        differences |= known;
        lost += lostSamples;
    }

    /** Says how many samples were no finite numbers, by what there is now. */
    public synchronized void samplesAreLost(long number) {
        lost = number;
    }

    /** How many samples were no finite numbers ({@link FilmTile#lostSamples}). */
    public synchronized long lostSamples() {
        return lost;
    }

    /** Says whether the samples of pixels are differences from something known ({@link FilmTile#known}), by what there is now. */
    public synchronized void samplesAreDifferences(boolean are) {
        differences = are;
    }

    private int pixel(int column, int row) {
        return (row - y) * width + column - x;
    }

    /** Component 0, 1 or 2 of the pixel in column and row of the whole picture, in full precision. */
    public double component(int column, int row, int c) {
        return rgb[3 * pixel(column, row) + c];
    }

    /**
     * A copy of the means of the quarters of each pixel's samples of linear light: red, green and blue of the first quarter, then of the
     * others, row by row; 12 numbers per pixel. A quarter without samples repeats the one before it.
     *
     * @throws IllegalStateException if pixels are display-referred
     */
    public float[] quarterMeans() {
        if (quarterMeans == null) {
            throw new IllegalStateException("display-referred pixels have no quarters");
        }
        return quarterMeans.clone();
    }

    /** The number of samples of the pixel in column and row of the whole picture; 0 if it is not finished. */
    public int count(int column, int row) {
        return counts[pixel(column, row)];
    }

    /** How far the samples say that the pixels are from the truth, in what a screen shows. */
    public ErrorEstimate error() {
        if (isLinear()) {
            return lightError();
        }
        ErrorEstimate.Contrast contrast = new ErrorEstimate.Contrast();
        for (int k = 0; k < rgb.length; k++) {
            if (counts[k / 3] > 0) {
                contrast.add(rgb[k]);
            }
        }
        return ErrorEstimate.of(halves, quarters, counts, ErrorEstimate.kind(differences), contrast.get());
    }

    private ErrorEstimate lightError() {
        float[] first = new float[counts.length];
        float[] second = new float[counts.length];
        double[] means = new double[QuarterMeans.PER_PIXEL];
        boolean[] rare = new boolean[counts.length];
        double[] local = new double[3];
        LinearFigures figures = new LinearFigures(curve, x, y, width, height, bandMeans());
        for (int i = 0; i < counts.length; i++) {
            if (counts[i] > 0) {
                for (int k = 0; k < means.length; k++) {
                    means[k] = quarterMeans[means.length * i + k];
                }
                light(i, local);
                figures.add(x + i % width, y + i / width, local, means, counts[i]);
                // A single sample's quarters are all the same, but for what was splatted.
                first[i] = (float) (figures.first() + (counts[i] == 1 ? halves[i] : 0));
                second[i] = switch (counts[i]) {
                    case 1 -> first[i];
                    case 2 -> quarters[i] + first[i] - halves[i];
                    default -> (float) figures.second();
                };
                rare[i] = QuarterMeans.isRare(curve, means, counts[i]);
            }
        }
        boolean isGrowing = fewSplats != null && fewSplats.putTo(first, second, counts);
        return ErrorEstimate.ofLight(first, second, counts, rare).with(figures.error(isGrowing));
    }

    /**
     * This film with light that was splatted: exact means, and quarters each with a group of the paths' units, so that errors are those
     * of the sum. Pixels that are not finished stay so.
     *
     * @param splats of the same rectangle; may go on growing
     * @throws IllegalArgumentException if it is of another rectangle, or one film's pixels are linear light and the other's are not
     */
    public Film plus(SplatFilm splats) {
        boolean same = splats.x == x && splats.y == y && splats.width == width && splats.height == height;
        if (!same || splats.encoding() != encoding()) {
            throw new IllegalArgumentException("films of different pixels");
        }
        if (!isLinear()) {
            return plusShown(splats);
        }
        Film sum = new Film(x, y, width, height, curve);
        System.arraycopy(rgb, 0, sum.rgb, 0, rgb.length);
        System.arraycopy(quarterMeans, 0, sum.quarterMeans, 0, quarterMeans.length);
        System.arraycopy(counts, 0, sum.counts, 0, counts.length);
        splats.addTo(sum.rgb, sum.quarterMeans, sum.counts);
        sum.fewSplats = FewSamplesSplats.of(curve, counts);
        for (int i = 0; i < counts.length; i++) {
            double scale = counts[i] == 1 || counts[i] == 2 ? steepness(rgb, sum.rgb, 3 * i) : 1;
            sum.halves[i] = (float) (scale * halves[i]);
            sum.quarters[i] = (float) (scale * quarters[i]);
            if (FewSamplesSplats.areFew(counts[i])) {
                sum.fewSplats.add(i, counts[i], this, sum);
            }
        }
        synchronized (this) {
            sum.add(surveyRays, differences, lost);
        }
        return sum;
    }

    /** The mean of component c of a pixel by its index. */
    double mean(int pixel, int c) {
        return rgb[3 * pixel + c];
    }

    /** A number of {@link QuarterMeans} of a pixel of linear light by its index. */
    double ofQuarter(int pixel, int i) {
        return quarterMeans[QuarterMeans.PER_PIXEL * pixel + i];
    }

    /** The first figure of a pixel by its index, as it was put. */
    float halves(int pixel) {
        return halves[pixel];
    }

    /** The second. */
    float quarters(int pixel) {
        return quarters[pixel];
    }

    /** Of display-referred pixels: paths and samples do not depend on each other, so their squared errors add. */
    private Film plusShown(SplatFilm splats) {
        Film sum = new Film(x, y, width, height, curve);
        double[] means = new double[3];
        double[] groups = new double[3 * SplatFilm.GROUPS];
        int[] sizes = {1, 1, 1, 1};
        for (int pixel = 0; pixel < counts.length; pixel++) {
            if (counts[pixel] > 0) {
                int column = x + pixel % width;
                int row = y + pixel / width;
                for (int c = 0; c < 3; c++) {
                    means[c] = rgb[3 * pixel + c] + splats.component(column, row, c);
                    for (int g = 0; g < SplatFilm.GROUPS; g++) {
                        groups[3 * g + c] = splats.component(column, row, c, g);
                    }
                }
                double first = SampleSpread.halves(groups, sizes);
                // Of one or two samples the second figure is a variance, too.
                double second = counts[pixel] > 2 ? SampleSpread.quarters(groups, sizes) : first;
                float half = (float) (halves[pixel] + first);
                sum.put(column, row, means, 0, half, (float) (quarters[pixel] + second), counts[pixel]);
            }
        }
        synchronized (this) {
            sum.add(surveyRays, differences, lost);
        }
        return sum;
    }

    /** By how much squared differences of what is shown shrink where there is more light; what neighbours told knew only the less. */
    private double steepness(double[] less, double[] more, int k) {
        double before = 0;
        double after = 0;
        for (int c = 0; c < 3; c++) {
            double step = STEP * (less[k + c] + more[k + c]);
            double a = curve.nearly(less[k + c] + step) - curve.nearly(less[k + c]);
            double b = curve.nearly(more[k + c] + step) - curve.nearly(more[k + c]);
            before += a * a;
            after += b * b;
        }
        return before > 0 ? Math.min(after / before, 1) : 1;
    }

    /** The light of a pixel by its index: the least of its own and of the mean of its 3 × 3 pixels, of each band. */
    private void light(int pixel, double[] out) {
        int column = pixel % width;
        int row = pixel / width;
        for (int c = 0; c < 3; c++) {
            double sum = 0;
            int n = 0;
            for (int r = Math.max(row - 1, 0); r <= Math.min(row + 1, height - 1); r++) {
                for (int q = Math.max(column - 1, 0); q <= Math.min(column + 1, width - 1); q++) {
                    if (counts[r * width + q] > 0) {
                        sum += rgb[3 * (r * width + q) + c];
                        n++;
                    }
                }
            }
            out[c] = Math.min(rgb[3 * pixel + c], sum / n);
        }
    }

    /** The mean of each band over the finished pixels. */
    private double[] bandMeans() {
        double[] sums = new double[3];
        long pixels = 0;
        for (int i = 0; i < counts.length; i++) {
            if (counts[i] > 0) {
                pixels++;
                for (int c = 0; c < 3; c++) {
                    sums[c] += rgb[3 * i + c];
                }
            }
        }
        for (int c = 0; c < 3; c++) {
            sums[c] /= Math.max(pixels, 1);
        }
        return sums;
    }

    /** Camera rays of all finished pixels: their samples, and those that only showed where samples are needed. */
    public long cameraSamples() {
        long sum = surveyRays;
        for (int count : counts) {
            sum += count;
        }
        return sum;
    }

    /** The picture as it stands. */
    public Image toImage() {
        float[] pixels = new float[rgb.length];
        for (int i = 0; i < rgb.length; i++) {
            pixels[i] = FloatLight.of(rgb[i], curve);
        }
        return new Image(width, height, pixels, curve);
    }
}
