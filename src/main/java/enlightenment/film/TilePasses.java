package enlightenment.film;

import java.util.ArrayList;
import java.util.BitSet;
import java.util.HashMap;
import java.util.List;
import java.util.Map;

/**
 * A tile in the making whose pixels' samples come in passes: in any order, each any number of times, from any threads.
 *
 * <p>The sums are added in pairs, the pairs in pairs, and so on: passes 0 and 1, 2 and 3, then 0 to 1 and 2 to 3. So the result is
 * one function of the passes, whatever their order, and a late pass keeps only those waiting that it is to be added up with: at most 4
 * tiles of sums are kept, and for each missing pass the logarithm of their number more. The last four are the quarters of the samples
 * that tell the error ({@link SampleSpread}).
 */
public final class TilePasses {
    private static final int QUARTERS = 4;

    private final int x;
    private final int y;
    private final int width;
    private final int height;
    private final int passes;

    /** Which passes are in. */
    private final BitSet done;

    /** Sums, by their place in the tree: the root would be 1, the two below k are 2 k and 2 k + 1, pass p is passes + p. */
    private final Map<Integer, FilmTile> sums = new HashMap<>();

    /**
     * A tile without passes yet.
     *
     * @param passes how many there will be: a power of two from 4 on
     * @throws IllegalArgumentException for another number
     */
    public TilePasses(int x, int y, int width, int height, int passes) {
        checkNumber(passes);
        this.x = x;
        this.y = y;
        this.width = width;
        this.height = height;
        this.passes = passes;
        done = new BitSet(passes);
    }

    private static void checkNumber(int passes) {
        if (passes < QUARTERS || Integer.bitCount(passes) != 1) {
            throw new IllegalArgumentException(passes + " passes: not a power of two from 4 on");
        }
    }

    /**
     * Refuses what cannot be a pass.
     *
     * @param fewest the least number of samples of a pixel
     * @throws IllegalArgumentException if there are more passes than that, or their number is neither 1 nor a power of two from 4 on
     */
    public static void check(int pass, int passes, int fewest) {
        if (passes != 1) {
            checkNumber(passes);
        }
        if (passes > fewest || pass < 0 || pass >= passes) {
            throw new IllegalArgumentException("pass " + pass + " of " + passes + ", with " + fewest + " samples");
        }
    }

    /**
     * Refuses all but a single pass.
     *
     * @throws IllegalArgumentException if there are more
     */
    public static void checkOne(int pass, int passes) {
        check(pass, passes, 1);
    }

    /** The index of the first of a pixel's samples that belong to a pass: ⌈samples · pass/passes⌉. */
    public static int firstSample(int samples, int pass, int passes) {
        return (int) ((long) samples * pass + passes - 1 >> Integer.numberOfTrailingZeros(passes));
    }

    /**
     * Adds a pass.
     *
     * @param tile of the same place, as {@code TileIntegrator.render} made it; it belongs to this from now on
     * @return whether it was missing; otherwise nothing has changed
     * @throws IllegalArgumentException if it is of another place, has a pixel without samples, or its samples are differences from
     *     something known
     */
    public synchronized boolean add(int pass, FilmTile tile) {
        if (pass < 0 || pass >= passes || tile.x != x || tile.y != y || tile.width != width || tile.height != height) {
            throw new IllegalArgumentException("pass " + pass + " of another tile");
        }
        if (tile.hasKnown() || tile.hasPixelWithoutSamples()) {
            throw new IllegalArgumentException("not a pass");
        }
        if (done.get(pass)) {
            return false;
        }
        done.set(pass);
        int node = passes + pass;
        FilmTile sum = tile;
        while (node >= 2 * QUARTERS && sums.containsKey(node ^ 1)) {
            FilmTile other = sums.remove(node ^ 1);
            FilmTile first = (node & 1) == 0 ? sum : other;
            first.merge(first == sum ? other : sum);
            sum = first;
            node /= 2;
        }
        sums.put(node, sum);
        return true;
    }

    /** Whether a pass is in. */
    public synchronized boolean has(int pass) {
        return done.get(pass);
    }

    /** The number of passes that are missing. */
    public synchronized int missing() {
        return passes - done.cardinality();
    }

    /** The number of tiles whose sums are kept. */
    synchronized int kept() {
        return sums.size();
    }

    /**
     * Removes a pass, with those that it was added up with: they have to be made again.
     *
     * @return all of these, in ascending order; empty if it was missing
     */
    public synchronized List<Integer> remove(int pass) {
        List<Integer> lost = new ArrayList<>();
        if (!done.get(pass)) {
            return lost;
        }
        int node = passes + pass;
        int span = 1;
        while (sums.remove(node) == null) {
            node /= 2;
            span *= 2;
        }
        int first = pass / span * span;
        for (int p = first; p < first + span; p++) {
            lost.add(p);
        }
        done.clear(first, first + span);
        return lost;
    }

    /**
     * Writes the finished tile.
     *
     * @param tile of the same place, without samples
     * @throws IllegalStateException if a pass is missing
     */
    public synchronized void into(FilmTile tile) {
        if (done.cardinality() < passes) {
            throw new IllegalStateException(missing() + " of " + passes + " passes are missing");
        }
        FilmTile[] quarters = new FilmTile[QUARTERS];
        for (int q = 0; q < QUARTERS; q++) {
            quarters[q] = sums.get(QUARTERS + q);
        }
        tile.setQuarters(quarters);
    }
}
