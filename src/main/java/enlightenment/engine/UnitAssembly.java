package enlightenment.engine;

import enlightenment.file.ContentHash;
import enlightenment.image.Image;
import java.util.List;
import java.util.Optional;

/** Where results of units become a picture, or many. For use by several threads at once. */
public interface UnitAssembly {
    /** Number of units, counted from 0. */
    int units();

    /** The greatest number of bytes that the result of a unit can have. */
    int longest(int unit);

    /** Why these bytes cannot be the result of this unit: wrong size, what is no number or out of range; empty if they can. */
    Optional<String> problem(int unit, byte[] bytes);

    /**
     * The hash by which results of a unit are compared: of all but their counters, which depend on what rendered them.
     *
     * @param bytes a result without {@linkplain #problem problems}
     */
    ContentHash digest(int unit, byte[] bytes);

    /**
     * Puts the result of a unit, in place of what is there of it.
     *
     * @throws IllegalArgumentException if that cannot be
     */
    void put(int unit, byte[] bytes);

    /** Takes a unit out again; nothing if it is not there. */
    void remove(int unit);

    /** Whether a unit is there. */
    boolean has(int unit);

    /** Number of units that are there. */
    int done();

    /** How much is there, in pixels: a unit that is a share of several pixels counts as that share of them. */
    long pixelsDone();

    /** Number of pixels in all. */
    long pixels();

    /**
     * The picture so far, or that of many which is made now, for those who look at it; what is missing is black. Where it is not in memory
     * only some of its columns and rows.
     */
    Image image();

    /** Whether {@link #remove}, and {@link #put} in place of something else, needs a {@linkplain #keepIn store}. */
    boolean needsStore();

    /** Keeps all results that are put from now on there, if they are needed. */
    void keepIn(ResultStore results);

    /** Units from this one on are not to be made yet; it never becomes less. */
    default int end() {
        return units();
    }

    /** Consecutive units, from {@code first} (included) to {@code last} (excluded). */
    record Range(int first, int last) {}

    /** The units that were lost with others since the last call, without {@link #remove}: they must be made again. */
    default List<Range> takeLost() {
        return List.of();
    }
}
