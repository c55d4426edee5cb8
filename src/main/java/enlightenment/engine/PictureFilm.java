package enlightenment.engine;

import enlightenment.color.Color;
import enlightenment.film.ErrorEstimate;
import enlightenment.film.FilmTile;
import enlightenment.image.Image;
import enlightenment.scene.RenderSettings;
import java.util.BitSet;
import java.util.Objects;

/** The finished part of a picture, whatever its units of work are. For use by several threads at once. */
public abstract class PictureFilm {
    final WorkUnits units;
    final RenderSettings.Crop region;
    private final Color.Encoding encoding;

    /** The units that are there. */
    private final BitSet done = new BitSet();

    private int number;
    private long changes;

    PictureFilm(WorkUnits units, RenderOutline outline) {
        this.units = units;
        region = outline.settings().region();
        encoding = outline.display().encoding();
    }

    /**
     * A picture of which nothing is there yet, whose units are not taken out again.
     *
     * @param place where the finished pixels are
     */
    public static PictureFilm of(WorkUnits units, RenderOutline outline, FilmPlace place) {
        return of(units, outline, false, place);
    }

    /**
     * A picture of which nothing is there yet.
     *
     * @param isKept whether units can be taken out again
     * @throws IllegalArgumentException if pixels are not in memory, and all paths may end anywhere
     */
    static PictureFilm of(WorkUnits units, RenderOutline outline, boolean isKept, FilmPlace place) {
        if (!units.haveTiles()) {
            if (place.folder().isPresent()) {
                throw new IllegalArgumentException("paths that may all end anywhere need the picture in memory");
            }
            return new SplatPicture(units, outline, place);
        }
        TilePicture tiles = new TilePicture(units, outline, isKept, place);
        return units.batches() == 0
                ? tiles
                : new MixedPicture(units, tiles, new SplatPicture(units, outline, place), outline, place);
    }

    /** The film that a unit belongs to: this, or one of two films that are added. */
    PictureFilm part(int unit) {
        return this;
    }

    /**
     * Does a unit and puts what became of it, which must not be there.
     *
     * @return the tile that is finished by this; null for none
     */
    public abstract FilmTile render(int unit, UnitWork work);

    /** Marks a unit as present; false if it was. */
    final synchronized boolean mark(int unit) {
        boolean isNew = !done.get(Objects.checkIndex(unit, units.count()));
        done.set(unit);
        changes++;
        if (isNew) {
            number++;
            count(unit, 1);
        }
        return isNew;
    }

    /** Marks a unit as missing; false if it was. */
    final synchronized boolean unmark(int unit) {
        boolean was = done.get(Objects.checkIndex(unit, units.count()));
        done.clear(unit);
        changes++;
        if (was) {
            number--;
            count(unit, -1);
        }
        return was;
    }

    /** The number of additions and removals of units: while it stays equal, so does a picture that is complete. */
    final synchronized long changes() {
        return changes;
    }

    /** A unit has come (1) or gone (-1); called under the lock. */
    abstract void count(int unit, int by);

    /** The encoding of the pixels. */
    public final Color.Encoding encoding() {
        return encoding;
    }

    /** Whether a unit is there. */
    public synchronized boolean has(int unit) {
        return done.get(unit);
    }

    /** Number of units that are there. */
    public synchronized int done() {
        return number;
    }

    /** Whether all units are there. */
    public final boolean isComplete() {
        return done() == units.count();
    }

    /** Number of pixels in all. */
    public final long pixels() {
        return (long) region.width() * region.height();
    }

    /** The number of pixels that are done. A unit that is a share of several pixels counts as that share of them. */
    public abstract long pixelsDone();

    /** Number of pixels whose samples are all there; where pixels get finished together only, as {@link #pixelsDone}. */
    public abstract long finishedPixels();

    /** Number of pixels that are not black for want of samples. */
    public abstract long shownPixels();

    /** Camera rays, or paths, of what is there. */
    public abstract long cameraSamples();

    /** The number of samples of a pixel, by its place in the whole picture; 0 if it is not finished. */
    public abstract int samples(int column, int row);

    /** The error of the pixels as estimated from the samples. */
    public abstract ErrorEstimate error();

    /**
     * Means of four independent shares of each pixel's samples of linear light: red, green and blue of the first, then of the others, row by
     * row; 12 numbers per pixel, the caller's own. A share without samples repeats another.
     *
     * @throws IllegalStateException if pixels are display-referred
     */
    public abstract float[] quarterMeans();

    /** Sets whether the samples of pixels are differences from known values, by the present units. */
    void samplesAreDifferences(boolean are) {}

    /** Sets the number of samples that were not finite, by the present units. */
    void samplesAreLost(long number) {}

    /** The number of samples that were not finite; more than none fails the render. */
    public long lostSamples() {
        return 0;
    }

    /** Releases files; only images that were taken before can be used then. */
    public void release() {}

    /** The picture so far; what is missing is black. */
    public abstract Image image();

    /** The picture so far for those who look at it: where it is not in memory only some of its columns and rows. */
    public Image shown() {
        return image();
    }

    /** A stand-in for tiles that are missing, with what paths have brought so far that may end anywhere. */
    public Image completed(Image tiles) {
        return tiles;
    }
}
