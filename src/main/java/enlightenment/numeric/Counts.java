package enlightenment.numeric;

import java.util.stream.LongStream;

/** Sums of counts that saturate where they overflow. */
public final class Counts {
    private Counts() {}

    /**
     * The sum; the largest number there is where it is larger than that.
     *
     * @param counts at least 0 each
     */
    public static long sum(LongStream counts) {
        return counts.reduce(0, (a, b) -> a > Long.MAX_VALUE - b ? Long.MAX_VALUE : a + b);
    }
}
