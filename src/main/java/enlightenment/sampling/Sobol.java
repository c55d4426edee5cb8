package enlightenment.sampling;

/**
 * The first two dimensions of Sobol's sequence with Owen scrambling: a randomised (0,2)-sequence. Every run of 2^k points
 * that starts at a multiple of 2^k has exactly one point in each of the 2^k boxes of any dyadic shape, and each single
 * point is uniformly distributed over the unit square.
 *
 * <p>Sources: I. M. Sobol 1967; A. B. Owen, "Randomly permuted (t,m,s)-nets", 1995; scrambling by hashing after Laine and
 * Karras 2011 with the constants of N. Vegdahl ("Building a better LK hash", 2021), as B. Burley, "Practical hash-based
 * Owen scrambling", JCGT 2020, describes. A point is a pure function of (index, seed).
 */
public final class Sobol {
    private static final double TO_UNIT = 0x1p-32;

    private Sobol() {}

    /** First coordinate, in [0, 1), of the point with this index under the scrambling chosen by the seed. */
    public static double x(int index, long seed) {
        // The bits of the index are the digits of the first coordinate, most significant digit first.
        return toUnit(scramble(index, (int) seed));
    }

    /** Second coordinate, in [0, 1), of the point with this index under the scrambling chosen by the seed. */
    public static double y(int index, long seed) {
        return toUnit(scramble(reversedY(index), (int) (seed >>> 32)));
    }

    /**
     * A random permutation of the indices, by which a sequence becomes independent of others. It keeps every aligned block of
     * 2^k together, so that prefixes stay stratified.
     */
    public static int shuffled(int index, long seed) {
        return scramble(Integer.reverse(index), (int) seed);
    }

    private static double toUnit(int bits) {
        return (bits & 0xFFFFFFFFL) * TO_UNIT;
    }

    /**
     * The bits of the second coordinate, least significant first. Its generator matrix is Pascal's triangle modulo 2, so
     * the product is a sum over subsets, done here by halving (a fast Möbius transform).
     */
    static int reversedY(int index) {
        int v = index;
        v ^= (v & 0xAAAAAAAA) >>> 1;
        v ^= (v & 0xCCCCCCCC) >>> 2;
        v ^= (v & 0xF0F0F0F0) >>> 4;
        v ^= (v & 0xFF00FF00) >>> 8;
        v ^= (v & 0xFFFF0000) >>> 16;
        return v;
    }

    /** Owen scrambling of a number given with its bits reversed; the result's bits are in the usual order. */
    private static int scramble(int reversed, int seed) {
        int v = reversed;
        v ^= v * 0x3d20adea;
        v += seed;
        v *= (seed >>> 16) | 1;
        v ^= v * 0x05526c56;
        v ^= v * 0x53a22864;
        return Integer.reverse(v);
    }
}
