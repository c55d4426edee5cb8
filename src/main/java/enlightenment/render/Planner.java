package enlightenment.render;

import enlightenment.check.Check;
import enlightenment.compiled.CompiledScene;
import enlightenment.compiled.RayCounters;
import enlightenment.film.FilmTile;
import enlightenment.method.TileMethod;
import enlightenment.method.cluster.ClusterCost;
import enlightenment.sampling.Hash;
import enlightenment.scene.Budget;
import enlightenment.scene.Method;
import enlightenment.scene.RenderSettings;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.function.BooleanSupplier;
import java.util.function.IntConsumer;

/**
 * Turns a budget into a number of samples per pixel before the first tile is rendered, by a trial on some blocks of what is
 * rendered, with random numbers of its own: nothing that is decided depends on the samples that it is decided about. Every budget
 * becomes a number, whatever it asks; where that cannot keep it, {@link #notes} says so.
 */
final class Planner {
    /** Keeps the trial's random numbers apart from the picture's. */
    private static final long PURPOSE = 0x747269616cL;

    /**
     * With fewer samples per pixel than this, method {@code cluster} is exactly {@code raytrace}: its survey takes 1.27, one in each
     * pixel is the least, and what is left does not buy more than evenly spaced rays do. Measured: from 2.3 on fire and ice to 2.6
     * on the keyhole, docs/cluster-laboratory.md.
     */
    private static final double FEWEST_OF_CLUSTER = 2.45;

    /** The most, in three digits, that are still fewer. */
    private static final double MOST_OF_OTHERS = 2.44;

    /** Blocks that are surveyed to learn what an effort costs. */
    private static final int COST_BLOCKS = 512;

    private static final double PIXELS_OF_BLOCK = 64;

    /** Rays of a survey, per pixel. */
    private static final double SURVEY_RAYS = 81 / PIXELS_OF_BLOCK;

    /** What a search for an error begins with: evenly spaced rays, and surveyed ones. */
    private static final double FIRST_SAMPLES = 2;

    static final double FIRST_OF_CLUSTER = 4;

    /** A trial of speed has this share of the blocks, or this many if that is more. */
    private static final double SHARE_OF_TIME = 1.0 / 16;

    private static final double LEAST_BLOCKS_OF_TIME = 64;

    /** Where rounding takes more than this share of the squared error, a file with more bits would be much cheaper. */
    private static final double MUCH_ROUNDING = 0.5;

    private static final double NANO = 1e-9;

    private final CompiledScene scene;
    private final RenderSettings settings;
    private final BooleanSupplier cancelled;
    private final boolean cluster;
    private final List<String> notes = new ArrayList<>();
    /** How much time the render takes, in multiples of what its samples take. */
    private double passes = 1;

    private ClusterCost cost;
    private final Map<Double, Double> efforts = new HashMap<>();

    Planner(CompiledScene scene, RenderSettings settings, BooleanSupplier cancelled) {
        this.scene = scene;
        this.settings = settings;
        this.cancelled = cancelled;
        cluster = settings.method() == Method.CLUSTER;
    }

    /**
     * The plan for the settings' budget.
     *
     * @param start when the render began, of {@link System#nanoTime}
     * @param previewed the share of the samples that is spent on previews, and not on the picture
     * @throws enlightenment.math.InvalidValueException if rounding to the depth of the budget is a greater error than asked for, and
     *     nothing else limits the render
     */
    RenderPlan plan(long start, double previewed) {
        passes = 1 + previewed;
        Budget budget = settings.budget();
        double antialias = (double) settings.antialias() * settings.antialias();
        if (budget.isNone()) {
            return cluster
                    ? withSamples(antialias, "antialias")
                    : new RenderPlan(Method.RAYTRACE, 0, antialias, "antialias");
        }
        double samples = budget.samples().orElse(Budget.MAX_SAMPLES);
        String by = "samples";
        if (budget.error().isPresent()) {
            double n = samplesForError(samples, until(budget, start));
            by = n < samples ? "error" : by;
            samples = Math.min(samples, n);
        }
        if (budget.seconds().isPresent()) {
            double n = samplesForTime(budget.seconds().getAsDouble(), start);
            by = n < samples ? "time" : by;
            samples = Math.min(samples, n);
        }
        return withSamples(samples, by);
    }

    /** What cannot be kept of the budget, or only at a price, in plain words; known when it is planned. */
    List<String> notes() {
        return List.copyOf(notes);
    }

    /** A plan for so few samples per pixel, or null if the method cannot do with so few. */
    RenderPlan planFor(double samples) {
        return samples < (cluster ? FEWEST_OF_CLUSTER : 1) ? null : withSamples(samples, "preview");
    }

    /** The plan for so many samples per pixel. */
    RenderPlan withSamples(double samples, String by) {
        return isClustered(samples)
                ? new RenderPlan(Method.CLUSTER, effort(samples), samples, by)
                : new RenderPlan(Method.RAYTRACE, Math.max(samples, 1), samples, by);
    }

    private boolean isClustered(double samples) {
        return cluster && samples >= FEWEST_OF_CLUSTER;
    }

    /** What was worked out for a trial need not be worked out again for the render. */
    private double effort(double samples) {
        return efforts.computeIfAbsent(samples, n -> cost().effort(n));
    }

    private ClusterCost cost() {
        if (cost == null) {
            cost = ClusterCost.of(scene, settings, COST_BLOCKS, cancelled);
        }
        return cost;
    }

    private static double since(long start) {
        return (System.nanoTime() - start) * NANO;
    }

    /** When to stop looking for the samples that an error takes: where there is not much time, time decides. */
    private BooleanSupplier until(Budget budget, long start) {
        if (budget.seconds().isEmpty()) {
            return cancelled;
        }
        double most = Pace.LEAST_TRIAL_TIME * budget.seconds().getAsDouble();
        return () -> cancelled.getAsBoolean() || since(start) > most;
    }

    /** The number of samples for which the error is as asked, but not more than the most, or that if it is stopped. */
    private double samplesForError(double most, BooleanSupplier stop) {
        ErrorTrials trials = new ErrorTrials(settings, (n, blocks) -> trial(n, blocks, stop), stop);
        if (trials.areTooFew()) {
            // The first round is the trial.
            return 1;
        }
        double found = search(trials, most);
        if (!stop.getAsBoolean()) {
            checkRounding(trials);
        }
        return Math.min(found, most);
    }

    private double search(ErrorTrials trials, double most) {
        if (!isClustered(most)) {
            return trials.search(1, FIRST_SAMPLES, most, 0);
        }
        // The error jumps where surveys begin: look on each side of it apart. Where evenly spaced rays are enough, they
        // are fewer.
        double plain = trials.search(1, 1, MOST_OF_OTHERS, 0);
        return plain <= MOST_OF_OTHERS || trials.isHopeless()
                ? plain
                : trials.search(FEWEST_OF_CLUSTER, FIRST_OF_CLUSTER, most, planningRays());
    }

    /** What it costs to know the effort of another number of samples, at most, per pixel of what is rendered. */
    private double planningRays() {
        RenderSettings.Crop region = settings.region();
        double surveyed = Math.min((double) settings.width() * settings.height(), COST_BLOCKS * PIXELS_OF_BLOCK);
        return SURVEY_RAYS * surveyed / ((double) region.width() * region.height());
    }

    /** Refuses what only another file could keep. */
    private void checkRounding(ErrorTrials trials) {
        Budget budget = settings.budget();
        double asked = budget.error().orElseThrow();
        double part = trials.rounding() / asked;
        if (part * part <= MUCH_ROUNDING) {
            return;
        }
        String said = String.format(
                Locale.ROOT,
                "rounding to %d bits makes an error of about %.2g, of %s that is asked for",
                budget.depth(),
                trials.rounding(),
                Rounds.number(asked));
        boolean isLimited = budget.samples().isPresent() || budget.seconds().isPresent();
        Check.that(isLimited || !trials.isHopeless(), "error", "cannot be kept: " + said);
        notes.add(said + (trials.isHopeless() ? ": it cannot be kept" : ": more bits would take far fewer samples"));
    }

    /** The number of samples that take so much time: that of the fastest trials, and 1 where there is no time for any. */
    private double samplesForTime(double seconds, long start) {
        TrialBlocks trial = new TrialBlocks(settings);
        double share = Math.max(SHARE_OF_TIME, LEAST_BLOCKS_OF_TIME / trial.count());
        RenderSettings.Crop region = settings.region();
        int trialPixels =
                trial.phase(0, share).stream().mapToInt(b -> b.width * b.height).sum();
        Pace pace = new Pace(seconds, (double) region.width() * region.height() * passes, trialPixels);
        BooleanSupplier over = () -> cancelled.getAsBoolean() || since(start) >= seconds;
        boolean clustered = false;
        do {
            double n = pace.next();
            if (isClustered(n) != clustered) {
                clustered = !clustered;
                pace.otherRays();
                // What is worked out only once must not count as part of a trial.
                cost();
            }
            List<FilmTile> blocks = trial.phase(0, share);
            double before = since(start);
            trial(n, blocks, over);
            double now = since(start);
            if (!over.getAsBoolean()) {
                pace.tried(n, now - before, now);
            }
        } while (!over.getAsBoolean() && pace.isWorthTrying());
        double planned = pace.planned(since(start));
        if (planned < 1 && !cancelled.getAsBoolean()) {
            notes.add("time " + Rounds.number(seconds) + " s is too short: the least is taken, one sample per pixel");
        }
        return isClustered(planned) && !clustered ? MOST_OF_OTHERS : Tidy.of(planned);
    }

    /** Renders these blocks with so many samples, and random numbers that are not the picture's. */
    private void trial(double samples, List<FilmTile> blocks, BooleanSupplier stop) {
        RenderSettings apart = settings.withSeed(Hash.of(settings.seed(), PURPOSE));
        RenderPlan plan = withSamples(samples, "trial");
        Workers.run(settings.threads(), blocks.size(), stop, () -> {
            TileMethod method = plan.method(scene, apart, new RayCounters(scene.kindNames.size()));
            method.stopWhen(stop);
            return (IntConsumer) i -> method.render(blocks.get(i));
        });
    }
}
