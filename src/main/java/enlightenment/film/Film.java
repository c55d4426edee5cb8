package enlightenment.film;

import enlightenment.color.Color;
import enlightenment.color.DisplayCurve;
import enlightenment.image.Image;

/** A film whose pixels are in memory. */
public final class Film implements TileFilm {
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
    public Color.Encoding encoding() {
        return curve.encoding();
    }

    private boolean isLinear() {
        return curve.encoding() == Color.Encoding.LINEAR;
    }

    @Override
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

    @Override
    public void put(int left, int top, int columns, int rows, Source source) {
        FilmPixel pixel = new FilmPixel();
        for (int row = top; row < top + rows; row++) {
            for (int column = left; column < left + columns; column++) {
                source.read(column, row, pixel);
                put(column, row, pixel.means, 0, pixel.halves, pixel.quarters, pixel.samples);
                if (isLinear()) {
                    keep(pixel(column, row), pixel.ofQuarters);
                }
            }
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

    private synchronized void add(long rays, boolean known, long lostSamples) {
        surveyRays += rays;
        differences |= known;
        lost += lostSamples;
    }

    @Override
    public synchronized void samplesAreLost(long number) {
        lost = number;
    }

    @Override
    public synchronized long lostSamples() {
        return lost;
    }

    @Override
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

    @Override
    public float[] quarterMeans() {
        if (quarterMeans == null) {
            throw new IllegalStateException("display-referred pixels have no quarters");
        }
        return quarterMeans.clone();
    }

    @Override
    public int count(int column, int row) {
        return counts[pixel(column, row)];
    }

    @Override
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
        return ErrorEstimate.of(
                PixelFigures.of(halves, quarters, counts, null), ErrorEstimate.kind(differences), contrast.get());
    }

    private ErrorEstimate lightError() {
        float[] first = new float[counts.length];
        float[] second = new float[counts.length];
        boolean[] rare = new boolean[counts.length];
        LightPass pass = new LightPass(curve, x, y, width, height);
        int[] next = new int[1];
        LinearFigures figures = pass.run(view(), pass.bandMeans(view()), (a, b, count, isRare) -> {
            int i = next[0]++;
            first[i] = a;
            second[i] = b;
            rare[i] = isRare;
        });
        boolean isGrowing = fewSplats != null && fewSplats.putTo(first, second, counts);
        return ErrorEstimate.ofLight(PixelFigures.of(first, second, counts, rare))
                .with(figures.error(isGrowing));
    }

    private FilmView view() {
        return new FilmView() {
            @Override
            public int count(int column, int row) {
                return counts[pixel(column, row)];
            }

            @Override
            public double component(int column, int row, int c) {
                return rgb[3 * pixel(column, row) + c];
            }

            @Override
            public float halves(int column, int row) {
                return halves[pixel(column, row)];
            }

            @Override
            public float quarters(int column, int row) {
                return quarters[pixel(column, row)];
            }

            @Override
            public void quarterMeans(int column, int row, double[] out) {
                int from = QuarterMeans.PER_PIXEL * pixel(column, row);
                for (int i = 0; i < QuarterMeans.PER_PIXEL; i++) {
                    out[i] = quarterMeans[from + i];
                }
            }
        };
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

    @Override
    public long cameraSamples() {
        long sum = surveyRays;
        for (int count : counts) {
            sum += count;
        }
        return sum;
    }

    @Override
    public Image toImage() {
        float[] pixels = new float[rgb.length];
        for (int i = 0; i < rgb.length; i++) {
            pixels[i] = FloatLight.of(rgb[i], curve);
        }
        return new Image(width, height, pixels, curve);
    }
}
