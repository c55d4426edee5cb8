package enlightenment.work;

import java.util.function.LongSupplier;

/** The time since something began. */
public final class Stopwatch {
    private static final double NANO = 1e-9;

    private final LongSupplier nanos;
    private final long start;

    /**
     * Starts now.
     *
     * @param nanos the clock, in nanoseconds from any origin
     */
    public Stopwatch(LongSupplier nanos) {
        this.nanos = nanos;
        start = nanos.getAsLong();
    }

    /** Starts now, by {@link System#nanoTime}. */
    public static Stopwatch started() {
        return new Stopwatch(System::nanoTime);
    }

    /** Seconds since the start. */
    public double seconds() {
        return (nanos.getAsLong() - start) * NANO;
    }
}
