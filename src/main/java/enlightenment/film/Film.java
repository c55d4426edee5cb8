package enlightenment.film;

import enlightenment.color.Encoding;
import enlightenment.image.Image;

/**
 * The picture in the making: the mean of each finished pixel, and what its samples tell about the error of that. Tiles
 * cover disjoint pixels, so the order in which threads put them does not matter.
 */
public final class Film {
    public final int x;
    public final int y;
    public final int width;
    public final int height;
    private final Encoding encoding;
    private final double[] rgb;

    /** Per pixel; see {@link FilmTile#halves} and {@link FilmTile#quarters}. */
    private final float[] halves;

    private final float[] quarters;
    private final int[] counts;
    private long surveyRays;
    private boolean differences;

    /** A film for a rectangle of the whole picture, display-referred. */
    public Film(int x, int y, int width, int height) {
        this(x, y, width, height, Encoding.DISPLAY);
    }

    /** A film for a rectangle of the whole picture. */
    public Film(int x, int y, int width, int height, Encoding encoding) {
        this.encoding = encoding;
        this.x = x;
        this.y = y;
        this.width = width;
        this.height = height;
        int pixels = width * height;
        rgb = new double[Math.toIntExact(3L * width * height)];
        halves = new float[pixels];
        quarters = new float[pixels];
        counts = new int[pixels];
    }

    /** What the pixels mean. */
    public Encoding encoding() {
        return encoding;
    }

    /** Puts a finished tile. */
    public void put(FilmTile tile) {
        for (int row = tile.y; row < tile.y + tile.height; row++) {
            int pixel = pixel(tile.x, row);
            for (int column = tile.x; column < tile.x + tile.width; column++, pixel++) {
                for (int c = 0; c < 3; c++) {
                    rgb[3 * pixel + c] = tile.mean(column, row, c);
                }
                halves[pixel] = tile.halves(column, row);
                quarters[pixel] = tile.quarters(column, row);
                counts[pixel] = tile.count(column, row);
            }
        }
        add(tile.surveyRays(), tile.hasKnown());
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

    private synchronized void add(long rays, boolean known) {
        surveyRays += rays;
        differences |= known;
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

    /** The number of samples of the pixel in column and row of the whole picture; 0 if it is not finished. */
    public int count(int column, int row) {
        return counts[pixel(column, row)];
    }

    /** How far the samples say that the pixels are from the truth. */
    public ErrorEstimate error() {
        ErrorEstimate.Contrast contrast = new ErrorEstimate.Contrast();
        for (int k = 0; k < rgb.length; k++) {
            if (counts[k / 3] > 0) {
                contrast.add(rgb[k]);
            }
        }
        return ErrorEstimate.of(halves, quarters, counts, differences, contrast.get());
    }

    /**
     * This picture, with what paths bring that may end anywhere added to its finished pixels. Paths and samples do not depend on each
     * other: their squared errors add, and groups of paths stand beside quarters of the samples.
     *
     * @param splats of the same rectangle
     */
    public Film plus(SplatFilm splats) {
        Film sum = new Film(x, y, width, height, encoding);
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
        sum.surveyRays = surveyRays;
        sum.differences = differences;
        return sum;
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
            pixels[i] = (float) rgb[i];
        }
        return new Image(width, height, pixels, encoding);
    }
}
