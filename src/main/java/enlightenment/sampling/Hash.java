package enlightenment.sampling;

/**
 * Random numbers as pure functions of what is sampled: there is no state, so neither order nor threads can change them.
 *
 * <p>The mixing function is the finaliser of MurmurHash3 in the variant 13 of D. Stafford ("Better bit mixing", 2011),
 * which SplitMix64 uses too (Steele, Lea and Flood 2014).
 */
public final class Hash {
    private static final long GOLDEN_GAMMA = 0x9E3779B97F4A7C15L;

    private Hash() {}

    /** A bijection of 64 bits in which every input bit changes every output bit with a probability of about one half. */
    public static long mix(long z) {
        z = (z ^ (z >>> 30)) * 0xBF58476D1CE4E5B9L;
        z = (z ^ (z >>> 27)) * 0x94D049BB133111EBL;
        return z ^ (z >>> 31);
    }

    /** A hash of two numbers. */
    public static long of(long a, long b) {
        return mix(mix(a + GOLDEN_GAMMA) + b * GOLDEN_GAMMA + 1);
    }

    /** The hash that follows another by this number of steps: for many numbers of one sequence, at half of the cost of {@link #of}. */
    public static long next(long hash, long steps) {
        return mix(hash + steps * GOLDEN_GAMMA);
    }

    /** A hash of three numbers. */
    public static long of(long a, long b, long c) {
        return of(of(a, b), c);
    }

    /** The upper 53 bits as a double in [0, 1). */
    public static double unit(long h) {
        return (h >>> 11) * 0x1p-53;
    }
}
