package enlightenment.method;

import enlightenment.sampling.Hash;

/**
 * Assigns to each numbered sample one of the moments while the shutter is open. Consecutive samples form blocks of as many as there are
 * moments; in each block every moment occurs once, from a random first one on. Neighbours in a block are far apart in time, so that a part
 * of a block is spread over it.
 */
public final class Moments {
    /** Mixed into the seed, so that moments share no random numbers with samplers. */
    public static final long PURPOSE = 0x5348555454455221L;

    /** The step between neighbours in a block, as a share of it: the golden section leaves the most even gaps for any number of samples. */
    private static final double STEP = (Math.sqrt(5) - 1) / 2;

    private final int count;
    private final int step;

    /**
     * @param count the number of moments, at least 1
     */
    public Moments(int count) {
        this.count = count;
        step = step(count);
    }

    /** The largest number, not above the golden section of the count, that has no divisor in common with it. */
    private static int step(int count) {
        int step = Math.max((int) (STEP * count), 1);
        while (greatestCommonDivisor(step, count) > 1) {
            step--;
        }
        return step;
    }

    private static int greatestCommonDivisor(int a, int b) {
        return b == 0 ? a : greatestCommonDivisor(b, a % b);
    }

    /**
     * The index of the moment that a sample sees.
     *
     * @param hash of the sequence of samples, such as those of a pixel
     * @param sample its number in the sequence, at least 0
     */
    public int of(long hash, long sample) {
        long lot = Long.remainderUnsigned(Hash.next(hash, sample / count), count);
        return (int) ((lot + sample % count * step) % count);
    }
}
