package enlightenment.film;

import java.util.Arrays;

/**
 * Sums contributions by pixel without room for every pixel: what comes is written down in its order, sorted by pixel now and then
 * (by radix: T. H. Cormen et al., "Introduction to Algorithms", section 8.3), and added to what is there. Measured on pictures of 0.3
 * to 8 million pixels, this takes about 40 ns per contribution; an array of all pixels takes 15 to 70 and hundreds of megabytes for each
 * thread, a hash table that is sorted in the end 100 to 135.
 */
final class SplatLog {
    private static final int LEAST = 1 << 12;
    private static final int MOST = 1 << 22;
    private static final int DIGIT = 11;
    private static final int MASK = (1 << DIGIT) - 1;

    /** Binary digits of the index of a pixel. */
    private final int bits;

    /** The contributions in their order: pixels, units of red, green and blue, and their number. */
    private int[] logPixels = new int[LEAST];

    private long[] logUnits = new long[3 * LEAST];
    private int logged;

    /** The sorted contributions: pixels, ascending, and sums. */
    private int[] pixels = new int[0];

    private long[] sums = new long[0];

    /** For sorting. */
    private int[] places = new int[LEAST];

    private int[] otherPixels = new int[LEAST];
    private int[] otherPlaces = new int[LEAST];
    private final int[] counts = new int[MASK + 1];

    /** A pixel whose sum was too large, or a negative number. */
    private int overflow;

    /** @param size number of pixels */
    SplatLog(int size) {
        bits = Integer.SIZE - Integer.numberOfLeadingZeros(Math.max(size - 1, 1));
    }

    void clear() {
        logged = 0;
        pixels = new int[0];
        sums = new long[0];
        overflow = -1;
    }

    /** Adds to a pixel; {@code Long.MAX_VALUE} and {@code Long.MIN_VALUE} are too much. */
    void add(int pixel, long r, long g, long b) {
        if ((r | g | b) == 0) {
            return;
        }
        if (logged == logPixels.length) {
            settle();
        }
        int k = 3 * logged;
        logPixels[logged++] = pixel;
        logUnits[k] = r;
        logUnits[k + 1] = g;
        logUnits[k + 2] = b;
    }

    /**
     * The sums of pixels.
     *
     * @param paths the number of paths for the result
     */
    SplatSums sums(long paths) {
        settle();
        return new SplatSums(pixels, sums, paths);
    }

    /** A pixel whose sum was too large, the first of these; negative if there is none. */
    int overflow() {
        return overflow;
    }

    private void settle() {
        sort();
        merge();
        // Each time, at least as much is new as there was: so all merging takes no more than a logarithm of times.
        int wanted = Math.min(Math.max(pixels.length, logPixels.length), MOST);
        if (wanted > logPixels.length) {
            logPixels = new int[wanted];
            logUnits = new long[3 * wanted];
            places = new int[wanted];
            otherPixels = new int[wanted];
            otherPlaces = new int[wanted];
        }
        logged = 0;
    }

    /** Sorts pixels, and the places where their units are, digit by digit; what is of one pixel stays in its order. */
    private void sort() {
        for (int i = 0; i < logged; i++) {
            places[i] = i;
        }
        for (int shift = 0; shift < bits; shift += DIGIT) {
            findPlaces(logPixels, logged, shift, counts);
            for (int i = 0; i < logged; i++) {
                move(i, counts[logPixels[i] >>> shift & MASK]++);
            }
            int[] swap = logPixels;
            logPixels = otherPixels;
            otherPixels = swap;
            swap = places;
            places = otherPlaces;
            otherPlaces = swap;
        }
    }

    /**
     * Computes the place of the first item of each digit. A method of its own, as the just-in-time compiler is slow where a method has many
     * loops.
     */
    private static void findPlaces(int[] pixels, int length, int shift, int[] counts) {
        Arrays.fill(counts, 0);
        for (int i = 0; i < length; i++) {
            counts[pixels[i] >>> shift & MASK]++;
        }
        int before = 0;
        for (int d = 0; d <= MASK; d++) {
            int count = counts[d];
            counts[d] = before;
            before += count;
        }
    }

    private void move(int from, int to) {
        otherPixels[to] = logPixels[from];
        otherPlaces[to] = places[from];
    }

    /** Adds what was sorted to what is there. */
    private void merge() {
        int[] to = new int[pixels.length + logged];
        long[] toSums = new long[3 * to.length];
        int n = 0;
        int old = 0;
        int i = 0;
        while (old < pixels.length || i < logged) {
            int pixel = old == pixels.length
                    ? logPixels[i]
                    : i == logged ? pixels[old] : Math.min(pixels[old], logPixels[i]);
            if (old < pixels.length && pixels[old] == pixel) {
                System.arraycopy(sums, 3 * old, toSums, 3 * n, 3);
                old++;
            }
            for (; i < logged && logPixels[i] == pixel; i++) {
                addTo(toSums, 3 * n, 3 * places[i], pixel);
            }
            to[n++] = pixel;
        }
        pixels = Arrays.copyOf(to, n);
        sums = Arrays.copyOf(toSums, 3 * n);
    }

    private void addTo(long[] toSums, int k, int from, int pixel) {
        for (int c = 0; c < 3; c++) {
            long units = logUnits[from + c];
            boolean tooLarge =
                    units == Long.MAX_VALUE || units == Long.MIN_VALUE || SplatSums.overflows(toSums[k + c], units);
            if (tooLarge && (overflow < 0 || pixel < overflow)) {
                overflow = pixel;
            }
            toSums[k + c] = tooLarge ? Long.MAX_VALUE : toSums[k + c] + units;
        }
    }
}
