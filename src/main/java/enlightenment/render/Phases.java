package enlightenment.render;

import enlightenment.machine.MachineFacts;
import java.util.ArrayList;
import java.util.List;
import java.util.function.Supplier;

/** Times the phases of one render, for the report and for flight recordings. */
final class Phases {
    private static final double NANO = 1e-9;

    private final List<RenderReport.Phase> phases = new ArrayList<>();

    <T> T run(String name, Supplier<T> work) {
        RenderPhaseEvent event = new RenderPhaseEvent();
        event.phase = name;
        event.begin();
        long wall = System.nanoTime();
        long cpu = MachineFacts.processorNanos();
        T result = work.get();
        phases.add(new RenderReport.Phase(
                name, (System.nanoTime() - wall) * NANO, Math.max(MachineFacts.processorNanos() - cpu, 0) * NANO));
        event.commit();
        return result;
    }

    /** A phase that began at this {@link System#nanoTime} and ends now; the time of processors is not known. */
    void add(String name, long start) {
        phases.add(new RenderReport.Phase(name, (System.nanoTime() - start) * NANO, 0));
    }

    /** What was rendered is not exact enough and is rendered again: it becomes a phase of another name. */
    void again() {
        phases.replaceAll(p -> p.name().equals("render")
                ? new RenderReport.Phase("earlier render", p.wallSeconds(), p.cpuSeconds())
                : p);
        phases.removeIf(p -> p.name().equals("finish"));
    }

    /** These phases, to which others can be added. */
    Phases copy() {
        Phases copy = new Phases();
        copy.phases.addAll(phases);
        return copy;
    }

    void run(String name, Runnable work) {
        run(name, () -> {
            work.run();
            return null;
        });
    }

    List<RenderReport.Phase> list() {
        return phases;
    }
}
