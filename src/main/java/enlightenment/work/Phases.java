package enlightenment.work;

import enlightenment.machine.MachineFacts;
import java.util.ArrayList;
import java.util.List;
import java.util.function.Supplier;
import jdk.jfr.FlightRecorder;

/** Times the phases of one render, for the report and for flight recordings. */
public final class Phases {
    private static final double NANO = 1e-9;

    /**
     * How long a phase took.
     *
     * @param wallSeconds by the clock
     * @param cpuSeconds of all threads together, 0 where the machine cannot tell
     */
    public record Timing(String name, double wallSeconds, double cpuSeconds) {}

    private final List<Timing> phases = new ArrayList<>();

    /** Does a phase, and gives what it gives. */
    public <T> T run(String name, Supplier<T> work) {
        // An event's class costs a fifth of a second when it is first used: only where somebody records.
        RenderPhaseEvent event = FlightRecorder.isInitialized() ? new RenderPhaseEvent() : null;
        if (event != null) {
            event.phase = name;
            event.begin();
        }
        Stopwatch wall = Stopwatch.started();
        long cpu = MachineFacts.processorNanos();
        T result = work.get();
        phases.add(new Timing(name, wall.seconds(), Math.max(MachineFacts.processorNanos() - cpu, 0) * NANO));
        if (event != null) {
            event.commit();
        }
        return result;
    }

    /** A phase that took this long by the clock; the time of processors is not known. */
    public void add(String name, double seconds) {
        phases.add(new Timing(name, seconds, 0));
    }

    /** What was rendered is not exact enough and is rendered again: it becomes a phase of another name. */
    public void again() {
        phases.replaceAll(
                p -> p.name().equals("render") ? new Timing("earlier render", p.wallSeconds(), p.cpuSeconds()) : p);
        phases.removeIf(p -> p.name().equals("finish") || p.name().equals("denoise"));
    }

    /** These phases, to which others can be added. */
    public Phases copy() {
        Phases copy = new Phases();
        copy.phases.addAll(phases);
        return copy;
    }

    /** Does a phase. */
    public void run(String name, Runnable work) {
        run(name, () -> {
            work.run();
            return null;
        });
    }

    /** What is over, in order. */
    public List<Timing> list() {
        return List.copyOf(phases);
    }
}
