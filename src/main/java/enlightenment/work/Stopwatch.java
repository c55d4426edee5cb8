package enlightenment.work;

import enlightenment.machine.MachineFacts;
import java.util.function.LongSupplier;

/** The time since something began. */
public final class Stopwatch {
    private static final double NANO = 1e-9;

    private final LongSupplier nanos;
    private final LongSupplier processors;
    private final long start;

    /**
     * Starts now.
     *
     * @param nanos the clock, in nanoseconds from any origin
     */
    public Stopwatch(LongSupplier nanos) {
        this(nanos, () -> 0);
    }

    private Stopwatch(LongSupplier nanos, LongSupplier processors) {
        this.nanos = nanos;
        this.processors = processors;
        start = nanos.getAsLong();
    }

    /** Starts now, by {@link System#nanoTime}. */
    public static Stopwatch started() {
        return new Stopwatch(System::nanoTime, MachineFacts::processorNanos);
    }

    /** Seconds since the start. */
    public double seconds() {
        return (nanos.getAsLong() - start) * NANO;
    }

    /** Seconds of processor time that this process has taken since any moment; always 0 by other clocks than the system's. */
    public double processorSeconds() {
        return processors.getAsLong() * NANO;
    }

    /** Processor time of the calling thread since any moment, in seconds; 0 where the system does not report it. */
    public static double threadSeconds() {
        return MachineFacts.threadNanos() * NANO;
    }
}
