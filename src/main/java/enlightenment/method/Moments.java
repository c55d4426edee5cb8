package enlightenment.method;

import enlightenment.sampling.Hash;

/**
 * Which of the moments while the shutter is open a numbered sample sees. Of samples that follow each other, each block of as many as there
 * are moments sees every moment once; blocks begin at moments that are drawn by lot. Neighbours in a block are far apart in time, so that
 * a part of a block is spread over it.
 */
public final class Moments {
    /** Tells these lots from those of samplers. */
    public static final long PURPOSE = 0x5348555454455221L;

    /** What neighbours in a block are apart: the golden section leaves the most even gaps, however many there are. */
    private static final double STEP = (Math.sqrt(5) - 1) / 2;

    private final int count;
    private final int step;

    /** @param count of moments, at least 1 */
    public Moments(int count) {
        this.count = count;
        step = step(count);
    }

    /** The number next below the golden section of a number that has no divisor in common with it. */
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
     * @param hash of the row of samples, in which this is one
     * @param sample its number, at least 0
     */
    public int of(long hash, long sample) {
        long lot = Long.remainderUnsigned(Hash.next(hash, sample / count), count);
        return (int) ((lot + sample % count * step) % count);
    }
}
