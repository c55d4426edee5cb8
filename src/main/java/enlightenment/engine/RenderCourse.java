package enlightenment.engine;

import enlightenment.plan.Planner;
import enlightenment.plan.RenderPlan;
import enlightenment.plan.Rounds;
import enlightenment.report.RenderReport;
import enlightenment.scene.RenderSettings;
import enlightenment.scene.Scene;
import enlightenment.work.Cancellation;
import enlightenment.work.Phases;
import enlightenment.work.Stopwatch;
import enlightenment.world.CompiledScene;
import enlightenment.world.SceneCompiler;
import java.util.OptionalDouble;
import java.util.function.BooleanSupplier;
import java.util.function.Consumer;

/** The course of a render without its scene. It has the place of the results, and decides on further rounds with more samples. */
public final class RenderCourse {
    private final RenderOutline outline;
    private final Phases phases;
    private final Rounds rounds;
    private final int round;

    /** Since the picture was asked for. */
    private final Stopwatch time;

    private final FilmRoom room;

    /** @param room where finished pixels may be */
    RenderCourse(RenderOutline outline, Phases phases, Rounds rounds, int round, Stopwatch time, FilmRoom room) {
        this.room = room;
        this.outline = outline;
        this.phases = phases;
        this.rounds = rounds;
        this.round = round;
        this.time = time;
    }

    /**
     * A picture of which nothing is there yet.
     *
     * @param canLose whether units may have to be taken out again, which takes more memory
     * @throws enlightenment.math.InvalidValueException if there is too little memory, or too little space on the disk
     */
    public FilmAssembly assembly(boolean canLose) {
        return new FilmAssembly(outline, phases, round, canLose, FilmAssembly.place(outline, room));
    }

    /** A picture of which nothing is there yet, whose units are not taken out again, with finished pixels in this place. */
    FilmAssembly assembly(FilmPlace place) {
        return new FilmAssembly(outline, phases, round, false, place);
    }

    /** Which render of the picture this is: 1, or more where those before were not as exact as asked. */
    public int round() {
        return round;
    }

    /**
     * The number of samples per pixel of the next round. Empty if this one is not complete, is as exact as its budget asks, or the budget
     * allows no more. To be called once.
     *
     * @param result the result of {@link FilmAssembly#result}
     * @param log receives the reason for a further round
     */
    public OptionalDouble next(Rendered result, Consumer<String> log) {
        if (!result.complete()) {
            return OptionalDouble.empty();
        }
        RenderReport report = result.report();
        double took = report.phases().stream()
                .filter(p -> p.name().equals("render"))
                .mapToDouble(RenderReport.Phase::wallSeconds)
                .sum();
        OptionalDouble samples = rounds.next(report, took, time.seconds());
        samples.ifPresent(n -> log.accept(rounds.note(report, n)));
        return samples;
    }

    /**
     * The render that follows.
     *
     * @param scene the same scene again
     * @param images is asked for image files
     * @param samples what {@link #next} said
     * @throws java.util.concurrent.CancellationException if it is cancelled, or the calling thread interrupted, before it is planned
     */
    public DividedRender again(Scene scene, SharedImages images, double samples, BooleanSupplier cancelled) {
        RenderSettings settings = outline.settings();
        BooleanSupplier stopped = Cancellation.of(cancelled);
        CompiledScene compiled = SceneCompiler.compile(scene, settings, images.images, stopped);
        return again(compiled, new Planner(compiled, settings, stopped), samples);
    }

    DividedRender again(CompiledScene compiled, Planner planner, double samples) {
        Phases further = phases.copy();
        further.again();
        RenderPlan more = further.run("plan", () -> planner.withSamples(samples, rounds.decidedBy(samples)));
        RenderOutline next = RenderOutline.of(outline.sceneName(), compiled, outline.settings(), more);
        return new DividedRender(compiled, next, further, planner, rounds, round + 1, time, room);
    }
}
