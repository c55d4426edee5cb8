package enlightenment.plan;

import enlightenment.check.Check;
import enlightenment.film.FilmTile;
import enlightenment.scene.RenderSettings;
import enlightenment.work.Stopwatch;
import enlightenment.world.CompiledScene;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.CancellationException;
import java.util.function.BooleanSupplier;

/**
 * Turns a budget into a number of samples per pixel before the first tile is rendered, by trials on some blocks of what is
 * rendered, with random numbers of their own: nothing that is decided depends on the samples that it is decided about. Every
 * budget becomes a number, whatever it asks; where that cannot keep it, {@link #notes} says so.
 */
public final class Planner {
    /** The first picture of paths that may end anywhere has this many to a pixel where an error is asked for. */
    private static final double FIRST_PATHS = 4;

    private final CompiledScene scene;
    private final RenderSettings settings;
    private final BooleanSupplier cancelled;
    private final SamplePlans plans;
    private final Trial trial;
    private final List<String> notes = new ArrayList<>();

    /** @param cancelled asked from several threads at once; once true, nothing is planned any more */
    public Planner(CompiledScene scene, RenderSettings settings, BooleanSupplier cancelled) {
        this.scene = scene;
        this.settings = settings;
        this.cancelled = cancelled;
        plans = new SamplePlans(scene, settings, cancelled);
        trial = new Trial(scene, settings, plans);
    }

    /**
     * The plan for the settings' budget.
     *
     * @param time since the render began
     * @param previewed the share of the samples that is spent on previews, and not on the picture
     * @throws enlightenment.math.InvalidValueException if rounding to the depth of the budget is a greater error than asked for, and
     *     nothing else limits the render
     * @throws CancellationException if it is cancelled: what trials had told by then is no plan
     */
    public RenderPlan plan(Stopwatch time, double previewed) {
        return unlessCancelled(plan(time, previewed, false));
    }

    /**
     * A plan for a picture without further rounds, whatever error it ends with. {@link #plan} lets further rounds make up for it.
     *
     * @throws enlightenment.math.InvalidValueException also if an error is all that limits a method that has no trials
     * @throws CancellationException if it is cancelled
     */
    public RenderPlan planOnce(Stopwatch time) {
        return unlessCancelled(plan(time, 0, true));
    }

    /** Refuses the plan of cancelled trials. Its number of samples is not the budget's, and a resumed render would keep it. */
    private RenderPlan unlessCancelled(RenderPlan plan) {
        if (cancelled.getAsBoolean()) {
            throw new CancellationException("stopped before the render was planned");
        }
        return plan;
    }

    private RenderPlan plan(Stopwatch time, double previewed, boolean isLast) {
        RenderSettings.Budget budget = settings.budget();
        noteScene();
        if (budget.isNone()) {
            return plans.ofAntialias();
        }
        double samples = budget.samples().orElse(RenderSettings.Budget.MAX_SAMPLES);
        String by = "samples";
        if (budget.error().isPresent()) {
            double n = samplesForError(samples, time, isLast);
            by = n < samples ? "error" : by;
            samples = Math.min(samples, n);
        }
        if (budget.seconds().isPresent()) {
            double n = new TimePlanner(settings.threads(), plans, trial, cancelled, notes::add)
                    .samples(budget.seconds().getAsDouble(), time, 1 + previewed, samples);
            by = n < samples ? "time" : by;
            samples = Math.min(samples, n);
        }
        return plans.of(samples, by);
    }

    /**
     * A plan that was made for this budget before.
     *
     * @throws CancellationException if it is cancelled
     */
    public RenderPlan known(RenderPlan plan) {
        noteScene();
        return plan;
    }

    private void noteScene() {
        Integrators.blindSpot(settings.method(), scene).ifPresent(notes::add);
        notes.addAll(Integrators.limitations(scene));
        noteCrop();
    }

    private double samplesForError(double most, Stopwatch time, boolean isLast) {
        if (!plans.areMostlyPaths()) {
            return new ErrorPlanner(settings, plans, trial, endOfErrorTrials(time), notes::add, isLast).samples(most);
        }
        if (isLast) {
            Check.that(
                    most < RenderSettings.Budget.MAX_SAMPLES,
                    "samples",
                    "must be given beside the error: " + settings.method()
                            + " has no trials for an error, and this picture is rendered once");
            return most;
        }
        notes.add(settings.method() + " has no trials for an error: a first picture with " + Rounds.number(FIRST_PATHS)
                + " paths per pixel tells how many it takes");
        return Math.min(most, FIRST_PATHS);
    }

    private void noteCrop() {
        if (settings.crop().isEmpty()) {
            return;
        }
        if (plans.haveLightPaths()) {
            notes.add("a crop has the light paths of the whole picture"
                    + (plans.areMostlyPaths() ? " and saves little time" : "")
                    + ": they may end anywhere, and what they bring elsewhere is dropped");
        } else if (plans.traits().areBatches()) {
            notes.add("a crop saves no time with " + settings.method()
                    + ": its paths may end anywhere, and what they bring elsewhere is dropped");
        }
        int side = plans.traits().blockSide();
        if (side > FilmTile.BLOCK_SIDE) {
            notes.add("a crop renders whole blocks of " + side + "x" + side + " pixels with " + settings.method()
                    + ": what is beyond it is dropped");
        }
    }

    /** When to stop looking for the samples that an error takes: where there is not much time, time decides. */
    private BooleanSupplier endOfErrorTrials(Stopwatch time) {
        if (settings.budget().seconds().isEmpty()) {
            return cancelled;
        }
        double longest = Pace.LEAST_TRIAL_TIME * settings.budget().seconds().getAsDouble();
        return () -> cancelled.getAsBoolean() || time.seconds() > longest;
    }

    /** Adds to {@link #notes} what was decided before. */
    public void note(String text) {
        notes.add(text);
    }

    /** Parts of the budget that cannot be kept, or only at a price, in plain words; complete after planning. */
    public List<String> notes() {
        return List.copyOf(notes);
    }

    /** The plan for a preview with this many samples per pixel; empty if the method cannot do with so few, or it is cancelled. */
    public Optional<RenderPlan> preview(double samples) {
        try {
            return plans.isPossible(samples) ? Optional.of(plans.of(samples, "preview")) : Optional.empty();
        } catch (CancellationException e) {
            return Optional.empty();
        }
    }

    /**
     * The plan for this many samples per pixel.
     *
     * @param by which part of the budget was decisive
     * @throws CancellationException if it is cancelled
     */
    public RenderPlan withSamples(double samples, String by) {
        return unlessCancelled(plans.of(samples, by));
    }

    /** The plan for the report of a picture of which nothing is rendered, as planning was cancelled. */
    public RenderPlan none() {
        return new RenderPlan(settings.method(), 0, 0, "nothing");
    }
}
