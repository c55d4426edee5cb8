package enlightenment.film;

import enlightenment.image.Image;

/**
 * The picture in the making: the mean of each finished pixel, and what its samples tell about the error of that. Tiles cover disjoint
 * pixels, so the order in which threads put them does not matter. All columns and rows are those of the whole picture.
 */
public sealed interface TileFilm permits Film, FilmInFile {
    /** Gives pixels. */
    @FunctionalInterface
    interface Source {
        /** Makes {@code pixel} the one at a place; places are asked for row by row within blocks of 8 rows. */
        void read(int column, int row, FilmPixel pixel);
    }

    /** Puts a finished tile. */
    void put(FilmTile tile);

    /** Puts a rectangle of pixels. */
    void put(int left, int top, int columns, int rows, Source source);

    /** Leaves nothing of a rectangle of pixels. */
    default void clear(int left, int top, int columns, int rows) {
        put(left, top, columns, rows, (column, row, pixel) -> pixel.clear());
    }

    /** Says how many samples were no finite numbers, by what there is now. */
    void samplesAreLost(long number);

    /** How many samples were no finite numbers ({@link FilmTile#lostSamples}). */
    long lostSamples();

    /** Says whether the samples of pixels are differences from something known ({@link FilmTile#known}), by what there is now. */
    void samplesAreDifferences(boolean are);

    /** The number of samples of a pixel; 0 if it is not finished. */
    int count(int column, int row);

    /**
     * The means of the quarters of each pixel's samples of linear light: red, green and blue of the first quarter, then of the others, row by
     * row; 12 numbers per pixel, the caller's own. A quarter without samples repeats the one before it.
     *
     * @throws IllegalStateException if pixels are display-referred, or the film is in a file
     */
    float[] quarterMeans();

    /** How far the samples say that the pixels are from the truth, in what a screen shows. */
    ErrorEstimate error();

    /** Camera rays of all finished pixels: their samples, and those that only showed where samples are needed. */
    long cameraSamples();

    /** The picture as it stands. */
    Image toImage();

    /** The picture as it stands for those who look at it: where it is not in memory only some of its columns and rows. */
    default Image shown() {
        return toImage();
    }

    /** Gives up what is not in memory; only images that were taken before can be used then. */
    default void release() {}
}
