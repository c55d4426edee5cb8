package enlightenment.film;

import enlightenment.color.Color;
import enlightenment.color.DisplayCurve;
import java.util.BitSet;

/**
 * A picture in the making by paths that may reach any pixel: sums of integers, so that units of work may come in any order, from any
 * threads, and go again, and the bytes are the same.
 *
 * <p>Units are of four groups, by their number; each group is a picture of its own. How far these differ tells the error.
 */
public abstract sealed class Splats permits SplatFilm, SplatFilmInFile {
    static final int GROUPS = 4;

    public final int x;
    public final int y;
    public final int width;
    public final int height;
    final DisplayCurve curve;
    private final long picturePixels;
    private final SplatScale scale;
    private final long[] paths = new long[GROUPS];

    /** The units that are in. */
    private final BitSet units = new BitSet();

    /**
     * A black film for a rectangle of the whole picture.
     *
     * @param picturePixels number of pixels of the whole picture
     * @param curve what pixels are, and how they become what a screen takes
     */
    Splats(int x, int y, int width, int height, long picturePixels, SplatScale scale, DisplayCurve curve) {
        this.x = x;
        this.y = y;
        this.width = width;
        this.height = height;
        this.picturePixels = picturePixels;
        this.scale = scale;
        this.curve = curve;
    }

    /** The encoding of the pixels. */
    public Color.Encoding encoding() {
        return curve.encoding();
    }

    /**
     * Adds a unit of work.
     *
     * @param unit its number, from 0
     * @return whether it was missing; otherwise nothing has changed
     * @throws ArithmeticException if a pixel's sum becomes too large, with the pixel. In memory that is at once, and nothing has changed; in
     *     a file it may be later, when sums are added up
     */
    public synchronized boolean add(int unit, SplatSums batch) {
        if (units.get(unit)) {
            return false;
        }
        put(unit % GROUPS, batch);
        paths[unit % GROUPS] += batch.paths;
        units.set(unit);
        return true;
    }

    /**
     * Removes a unit of work.
     *
     * @param batch its contribution
     * @return whether it was present; otherwise nothing has changed
     * @throws IllegalArgumentException if this has more paths than were added; then nothing has changed
     */
    public synchronized boolean remove(int unit, SplatSums batch) {
        if (!units.get(unit)) {
            return false;
        }
        if (paths[unit % GROUPS] < batch.paths) {
            throw new IllegalArgumentException("unit " + unit + " never added as much");
        }
        take(unit % GROUPS, batch);
        paths[unit % GROUPS] -= batch.paths;
        units.clear(unit);
        return true;
    }

    /** Adds the sums of a batch to a group. */
    abstract void put(int group, SplatSums batch);

    /** Subtracts the sums of a batch from a group. */
    abstract void take(int group, SplatSums batch);

    /** The sums as they stand; nothing may be added while they are read. */
    abstract SplatView view();

    /** The number of units that are in. */
    public synchronized int units() {
        return units.cardinality();
    }

    /** The number of paths of all units that are in. */
    public synchronized long paths() {
        long sum = 0;
        for (long n : paths) {
            sum += n;
        }
        return sum;
    }

    /** The light of the film; nothing may be added while it is read. */
    final synchronized SplatLight light() {
        return new SplatLight(view(), scale, picturePixels, paths);
    }

    /** Releases files; nothing can be read any more. */
    public void release() {}
}
