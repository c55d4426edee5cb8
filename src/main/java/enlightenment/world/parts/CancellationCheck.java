package enlightenment.world.parts;

/**
 * Checks for cancellation once every {@link #INTERVAL} steps of compiling. A mutable counter, one per loop whose number of steps is not
 * known beforehand; loops over a known index use {@link #isDue}.
 */
public final class CancellationCheck {
    /** Steps between two checks: compiling this many objects takes about a millisecond. */
    public static final int INTERVAL = 1024;

    private final Runnable poll;
    private int steps;

    /** @param poll throws if compiling is cancelled */
    public CancellationCheck(Runnable poll) {
        this.poll = poll;
    }

    /** Whether a check is due at this index, counted from 0; never in loops shorter than {@link #INTERVAL}. */
    public static boolean isDue(int index) {
        return index % INTERVAL == INTERVAL - 1;
    }

    /** Counts one step. */
    public void step() {
        if (isDue(steps++)) {
            steps = 0;
            poll.run();
        }
    }

    /** Counts several steps. */
    public void steps(int count) {
        for (int i = 0; i < count; i++) {
            step();
        }
    }
}
