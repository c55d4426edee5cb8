package enlightenment.net.schedule;

import java.util.PriorityQueue;
import java.util.SplittableRandom;
import java.util.function.BooleanSupplier;

/** Simulated time: things that will happen, in order. The same seed gives the same world. */
final class SimWorld {
    static final long SECOND = CoordinatorSettings.SECOND;
    static final long MILLI = 1_000_000;

    final SplittableRandom random;

    /** Starts far from zero, as clocks of machines do. */
    long now = Long.MAX_VALUE - 5 * SECOND;

    final long start = now;
    long events;

    private final PriorityQueue<Due> queue = new PriorityQueue<>();
    private long sequence;

    SimWorld(long seed) {
        random = new SplittableRandom(seed);
    }

    private record Due(long after, long sequence, Runnable what) implements Comparable<Due> {
        @Override
        public int compareTo(Due other) {
            return after != other.after ? Long.compare(after, other.after) : Long.compare(sequence, other.sequence);
        }
    }

    /** Nanoseconds since the start. */
    long elapsed() {
        return now - start;
    }

    void in(long delay, Runnable what) {
        queue.add(new Due(elapsed() + delay, sequence++, what));
    }

    /** A duration between the two, with the shorter ones more likely. */
    long between(long shortest, long longest) {
        double u = random.nextDouble();
        return shortest + (long) (u * u * (longest - shortest));
    }

    boolean chance(double probability) {
        return random.nextDouble() < probability;
    }

    /** Lets things happen; false if the end has not come in time. */
    boolean run(long limit, BooleanSupplier ended) {
        while (!ended.getAsBoolean()) {
            Due next = queue.poll();
            if (next == null || next.after > limit) {
                return false;
            }
            now = start + next.after;
            events++;
            next.what.run();
        }
        return true;
    }
}
