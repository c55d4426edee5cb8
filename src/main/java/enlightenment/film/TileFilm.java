package enlightenment.film;

import enlightenment.color.Color;
import enlightenment.color.DisplayCurve;
import enlightenment.image.Image;

/**
 * The picture in the making: the mean of each finished pixel, and what its samples tell about the error of that. Tiles cover disjoint
 * pixels, so the order in which threads put them does not matter. All columns and rows are those of the whole picture.
 */
public abstract sealed class TileFilm permits Film, FilmInFile {
    public final int x;
    public final int y;
    public final int width;
    public final int height;
    final DisplayCurve curve;

    /** Camera rays that only showed where samples are needed. */
    private long surveyRays;

    private long lost;
    private boolean differences;

    /**
     * A film for a rectangle of the whole picture.
     *
     * @param curve what pixels are, and how they become what a screen takes
     */
    TileFilm(int x, int y, int width, int height, DisplayCurve curve) {
        this.x = x;
        this.y = y;
        this.width = width;
        this.height = height;
        this.curve = curve;
    }

    /** A source of finished pixels. */
    @FunctionalInterface
    public interface Source {
        /** Reads the pixel at a place into {@code pixel}; places come row by row within blocks of 8 rows. */
        void read(int column, int row, FilmPixel pixel);
    }

    /** The encoding of the pixels. */
    public final Color.Encoding encoding() {
        return curve.encoding();
    }

    final boolean isLinear() {
        return curve.encoding() == Color.Encoding.LINEAR;
    }

    /** Puts a finished tile. */
    public void put(FilmTile tile) {
        put(tile.x, tile.y, tile.width, tile.height, (column, row, pixel) -> pixel.take(tile, column, row));
        count(tile.surveyRays(), tile.hasKnown(), tile.lostSamples());
    }

    private synchronized void count(long rays, boolean known, long lostSamples) {
        surveyRays += rays;
        differences |= known;
        lost += lostSamples;
    }

    /** Puts a rectangle of pixels. */
    public abstract void put(int left, int top, int columns, int rows, Source source);

    /** Leaves nothing of a rectangle of pixels. */
    public final void clear(int left, int top, int columns, int rows) {
        put(left, top, columns, rows, (column, row, pixel) -> pixel.clear());
    }

    /** Sets the number of samples that were not finite, by the present units. */
    public final synchronized void samplesAreLost(long number) {
        lost = number;
    }

    /** The number of samples that were not finite ({@link FilmTile#lostSamples}). */
    public final synchronized long lostSamples() {
        return lost;
    }

    /** Sets whether the samples of pixels are differences from known values ({@link FilmTile#known}), by the present units. */
    public final synchronized void samplesAreDifferences(boolean are) {
        differences = are;
    }

    final synchronized boolean areDifferences() {
        return differences;
    }

    /** The number of samples of a pixel; 0 if it is not finished. */
    public abstract int count(int column, int row);

    /**
     * The means of the quarters of each pixel's samples of linear light: red, green and blue of the first quarter, then of the others, row by
     * row; 12 numbers per pixel, the caller's own. A quarter without samples repeats the one before it.
     *
     * @throws IllegalStateException if pixels are display-referred, or the film is in a file
     */
    public abstract float[] quarterMeans();

    /** The error of the pixels as estimated from the samples, in displayed values. */
    public abstract ErrorEstimate error();

    /** Camera rays of all finished pixels: their samples, and those that only showed where samples are needed. */
    public final long cameraSamples() {
        long rays;
        synchronized (this) {
            rays = surveyRays;
        }
        return rays + samples();
    }

    /** The samples of all finished pixels. */
    abstract long samples();

    /**
     * This film with light that was splatted: exact means, and quarters each with a group of the paths' units, so that errors are those
     * of the sum. Pixels that are not finished stay so. It is where this is, in memory or in a file of its own.
     *
     * @param splats of the same rectangle; may go on growing
     * @throws IllegalArgumentException if it is of another rectangle, or one film's pixels are linear light and the other's are not
     */
    public TileFilm plus(Splats splats) {
        boolean same = splats.x == x && splats.y == y && splats.width == width && splats.height == height;
        if (!same || splats.encoding() != encoding()) {
            throw new IllegalArgumentException("films of different pixels");
        }
        FewSamplesSplats few = fewSamples();
        TileFilm sum = empty(few);
        synchronized (splats) {
            sum.put(x, y, width, height, new SplattedPixels(view(), splats.light(), curve, few));
        }
        synchronized (this) {
            sum.count(surveyRays, differences, lost);
        }
        return sum;
    }

    /** Keeps what was splatted over pixels with few samples, for a film as this. */
    abstract FewSamplesSplats fewSamples();

    /**
     * A film of the same rectangle of which nothing is there yet.
     *
     * @param few what was splatted over pixels with few samples, for the error
     */
    abstract TileFilm empty(FewSamplesSplats few);

    /** The pixels as they stand, to be read by one thread, row by row. */
    abstract FilmView view();

    /** The picture as it stands. */
    public abstract Image toImage();

    /** The picture as it stands for those who look at it: where it is not in memory only some of its columns and rows. */
    public Image shown() {
        return toImage();
    }

    /** Releases files; only images that were taken before can be used then. */
    public void release() {}
}
