package enlightenment.render;

import enlightenment.compiled.CompiledScene;
import enlightenment.compiled.RayCounters;
import enlightenment.film.ErrorEstimate;
import enlightenment.film.FilmTile;
import enlightenment.method.SpreadPlaces;
import enlightenment.method.TileMethod;
import enlightenment.method.cluster.ClusterCost;
import enlightenment.sampling.Hash;
import enlightenment.scene.Budget;
import enlightenment.scene.RenderSettings;
import java.util.ArrayList;
import java.util.List;
import java.util.function.BooleanSupplier;
import java.util.function.IntConsumer;

/**
 * Turns a budget into a number of samples per pixel before the first tile is rendered, by a trial on some blocks of the whole
 * picture, with random numbers of its own: nothing that is decided depends on the samples that it is decided about.
 */
final class Planner {
    /** Keeps the trial's random numbers apart from the picture's. */
    private static final long PURPOSE = 0x747269616cL;

    private static final int SIDE = 8;

    /**
     * With fewer samples per pixel than this, method {@code cluster} is exactly {@code raytrace}: its survey takes 1.27, one in each
     * pixel is the least, and what is left does not buy more than evenly spaced rays do. Measured: from 2.3 on fire and ice to 2.6
     * on the keyhole, docs/cluster-sampler.md.
     */
    private static final double FEWEST_OF_CLUSTER = 2.45;

    /** The most, in three digits, that are still fewer. */
    private static final double MOST_OF_OTHERS = 2.44;

    /** Blocks that are surveyed to learn what an effort costs. */
    private static final int COST_BLOCKS = 512;

    /** Trial blocks: a share of the picture, but not less than this, or little is known. */
    private static final int LEAST_TRIAL = 320;

    private static final int TRIAL_SHARE = 16;

    /**
     * What is aimed at, as a share of the error asked for: the trial has seen only some of the picture. Evenly spread samples
     * leave most of the error to a few pixels, which a trial sees less well.
     */
    private static final double CLUSTER_AIM = 0.83;

    private static final double RAYTRACE_AIM = 0.82;

    /** Where a survey needs more samples than this, fewer than it takes would not do without it. */
    private static final double DEAR = 3.2;

    private static final int MOST_TRIALS = 7;

    /** The error falls at least as n^−½ and at best as 1/n with the number of samples. */
    private static final double FIRST_SAMPLES = 4;

    /** Blocks of a trial of speed: a share of the picture, within these limits. */
    private static final int LEAST_BLOCKS_OF_TIME = 64;

    /** The share of a time budget that one trial may take, that they all take at least, and at most. */
    private static final double ONE_TRIAL_TIME = 0.06;

    private static final double LEAST_TRIAL_TIME = 0.12;
    private static final double MOST_TRIAL_TIME = 0.4;

    /** So many trials, unless too much of the budget is gone. */
    private static final int LEAST_TRIALS = 4;

    private static final double LAST_CALL = 0.6;

    /**
     * Seconds after which the code is about as fast as it gets: even a long budget need not be tried for longer. Until then
     * its speed was measured to grow about with the square root of the time.
     */
    private static final double WARM = 2.5;

    /** A trial that is faster than those before by less than this factor is no faster, and after so many of them it is enough. */
    private static final double FASTER = 1.04;

    private static final int CALM = 3;

    /** The share of the time that is left that is planned with. */
    private static final double PLANNED_TIME = 0.93;

    private static final double NANO = 1e-9;

    private final CompiledScene scene;
    private final RenderSettings settings;
    private final BooleanSupplier cancelled;
    private final boolean cluster;
    /** How much time the render takes, in multiples of what its samples take. */
    private double passes = 1;

    private ClusterCost cost;

    Planner(CompiledScene scene, RenderSettings settings, BooleanSupplier cancelled) {
        this.scene = scene;
        this.settings = settings;
        this.cancelled = cancelled;
        cluster = settings.method().equals(RenderPlan.CLUSTER);
    }

    /**
     * The plan for the settings' budget.
     *
     * @param start when the render began, of {@link System#nanoTime}
     * @param previewed the share of the samples that is spent on previews, and not on the picture
     */
    RenderPlan plan(long start, double previewed) {
        passes = 1 + previewed;
        Budget budget = settings.budget();
        double antialias = (double) settings.antialias() * settings.antialias();
        if (budget.isNone()) {
            return cluster
                    ? withSamples(antialias, "antialias")
                    : new RenderPlan(RenderPlan.RAYTRACE, 0, antialias, "antialias");
        }
        double samples = Budget.MAX_SAMPLES;
        String by = "samples";
        if (budget.samples().isPresent()) {
            samples = budget.samples().getAsDouble();
        }
        if (budget.error().isPresent()) {
            double n = samplesForError(budget.error().getAsDouble(), samples, until(budget, start));
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

    /** A plan for so few samples per pixel, or null if the method cannot do with so few. */
    RenderPlan planFor(double samples) {
        return samples < (cluster ? FEWEST_OF_CLUSTER : 1) ? null : withSamples(samples, "preview");
    }

    private RenderPlan withSamples(double samples, String by) {
        return isClustered(samples)
                ? new RenderPlan(RenderPlan.CLUSTER, cost().effort(samples), samples, by)
                : new RenderPlan(RenderPlan.RAYTRACE, Math.max(samples, 1), samples, by);
    }

    private boolean isClustered(double samples) {
        return cluster && samples >= FEWEST_OF_CLUSTER;
    }

    private ClusterCost cost() {
        if (cost == null) {
            cost = ClusterCost.of(scene, settings, COST_BLOCKS, cancelled);
        }
        return cost;
    }

    /** When to stop looking for the samples that an error takes: where there is not much time, time decides. */
    private BooleanSupplier until(Budget budget, long start) {
        if (budget.seconds().isEmpty()) {
            return cancelled;
        }
        double most = LEAST_TRIAL_TIME * budget.seconds().getAsDouble();
        return () -> cancelled.getAsBoolean() || (System.nanoTime() - start) * NANO > most;
    }

    /** The number of samples for which the error is this, but not more than the most, or that if it is stopped. */
    private double samplesForError(double error, double most, BooleanSupplier stop) {
        if (!isClustered(most)) {
            return search(error, 1, most, stop);
        }
        double surveyed = search(error, FEWEST_OF_CLUSTER, most, stop);
        if (surveyed > DEAR) {
            return surveyed;
        }
        // The error jumps where surveys begin: look on each side of it apart.
        double plain = search(error, 1, MOST_OF_OTHERS, stop);
        return plain < MOST_OF_OTHERS ? plain : surveyed;
    }

    private double search(double error, double least, double most, BooleanSupplier stop) {
        ErrorSearch search = new ErrorSearch(error, least, most);
        double n = Math.min(Math.max(FIRST_SAMPLES, least), most);
        for (int k = 0; k < MOST_TRIALS; k++) {
            double e = errorOfTrial(n, stop);
            if (stop.getAsBoolean()) {
                return most;
            }
            search.found(n, e / (isClustered(n) ? CLUSTER_AIM : RAYTRACE_AIM));
            if (search.isOver()) {
                break;
            }
            n = search.next();
        }
        double found = search.answer();
        return found < most ? tidy(found) : most;
    }

    /**
     * The number of samples that take so much time. Trials go on until they get no faster, because the just-in-time compiler
     * needs a while; each has about the number of samples that the one before proposed, because the first samples of a pixel
     * may cost more than others.
     */
    private double samplesForTime(double seconds, long start) {
        RenderSettings.Crop region = settings.region();
        double pixels = (double) region.width() * region.height();
        List<FilmTile> blocks = blocksOf(region, LEAST_BLOCKS_OF_TIME);
        double trialPixels = blocks.stream().mapToInt(b -> b.width * b.height).sum();
        // What is worked out only once must not count as part of a trial.
        if (cluster) {
            cost();
        }
        double n = 1;
        double fastest = 0;
        double previous = 0;
        double planned;
        double elapsed;
        int calm = 0;
        int trials = 0;
        boolean clustered = false;
        do {
            if (isClustered(n) != clustered) {
                // Other rays, other speed.
                clustered = !clustered;
                previous = 0;
                fastest = 0;
                calm = 0;
            }
            long before = System.nanoTime();
            trial(n, emptied(blocks), cancelled);
            long now = System.nanoTime();
            double perSecond = n * trialPixels / Math.max((now - before) * NANO, NANO);
            calm = perSecond < fastest * FASTER ? calm + 1 : 0;
            // Of two trials the faster: other programs slow down one now and then, but nothing makes it too fast.
            double speed = Math.max(perSecond, previous);
            previous = perSecond;
            fastest = Math.max(fastest, perSecond);
            elapsed = (now - start) * NANO;
            planned = PLANNED_TIME * (seconds - elapsed) * speed * warming(elapsed, seconds, calm) / (pixels * passes);
            double affordable = ONE_TRIAL_TIME * seconds * speed / trialPixels;
            double least = isClustered(planned) ? FEWEST_OF_CLUSTER : 1;
            n = Math.min(Math.max(Math.min(planned, affordable), least), Budget.MAX_SAMPLES);
            trials++;
        } while (!cancelled.getAsBoolean() && isWorthTrying(elapsed, seconds, trials, calm));
        if (isClustered(planned) && !clustered) {
            planned = MOST_OF_OTHERS;
        }
        return Math.min(Math.max(tidy(planned), 1), Budget.MAX_SAMPLES);
    }

    private static boolean isWorthTrying(double elapsed, double seconds, int trials, int calm) {
        if (trials < LEAST_TRIALS) {
            return elapsed < LAST_CALL * seconds;
        }
        return elapsed < Math.min(MOST_TRIAL_TIME * seconds, WARM)
                && (calm < CALM || elapsed < LEAST_TRIAL_TIME * seconds);
    }

    /** How many times as fast the render will be as the last trials, if they were still getting faster. */
    private static double warming(double elapsed, double seconds, int calm) {
        double middle = (elapsed + Math.min(seconds, WARM)) / 2;
        return calm >= CALM - 1 ? 1 : Math.sqrt(Math.max(middle / elapsed, 1));
    }

    /** Three digits, so that the number can be read from a log and given again. */
    private static double tidy(double samples) {
        double unit = 1;
        while (samples / unit >= 1000) {
            unit *= 10;
        }
        while (samples / unit < 100) {
            unit /= 10;
        }
        // Powers of ten below one are not exact: divide by their inverse.
        double digits = Math.max(Math.rint(samples / unit), 1);
        return unit >= 1 ? digits * unit : digits / Math.rint(1 / unit);
    }

    /** Renders some blocks of the whole picture with so many samples and returns their estimated error. */
    private double errorOfTrial(double samples, BooleanSupplier stop) {
        List<FilmTile> blocks =
                blocksOf(new RenderSettings.Crop(0, 0, settings.width(), settings.height()), LEAST_TRIAL);
        trial(samples, blocks, stop);
        return stop.getAsBoolean() ? 0 : ErrorEstimate.of(blocks).rmse();
    }

    /** Blocks spread over a part of the picture: a share of it, but not less than so many, if there are. */
    private static List<FilmTile> blocksOf(RenderSettings.Crop area, int least) {
        int left = area.x() / SIDE;
        int top = area.y() / SIDE;
        int right = area.x() + area.width();
        int bottom = area.y() + area.height();
        int across = (right - 1) / SIDE - left + 1;
        int down = (bottom - 1) / SIDE - top + 1;
        int all = across * down;
        List<FilmTile> blocks = new ArrayList<>();
        for (int[] place : SpreadPlaces.of(across, down, Math.max(Math.min(all, least), all / TRIAL_SHARE))) {
            int x = Math.max((left + place[0]) * SIDE, area.x());
            int y = Math.max((top + place[1]) * SIDE, area.y());
            int width = Math.min((left + place[0] + 1) * SIDE, right) - x;
            int height = Math.min((top + place[1] + 1) * SIDE, bottom) - y;
            blocks.add(new FilmTile(x, y, width, height));
        }
        return blocks;
    }

    private static List<FilmTile> emptied(List<FilmTile> blocks) {
        List<FilmTile> empty = new ArrayList<>();
        for (FilmTile b : blocks) {
            empty.add(new FilmTile(b.x, b.y, b.width, b.height));
        }
        return empty;
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
