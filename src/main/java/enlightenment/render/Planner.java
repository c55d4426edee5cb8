package enlightenment.render;

import enlightenment.compiled.CompiledScene;
import enlightenment.compiled.RayCounters;
import enlightenment.film.ErrorEstimate;
import enlightenment.film.FilmTile;
import enlightenment.method.RenderPlan;
import enlightenment.method.SpreadPlaces;
import enlightenment.method.TileMethod;
import enlightenment.method.cluster.ClusterCost;
import enlightenment.sampling.Hash;
import enlightenment.scene.Budget;
import enlightenment.scene.RenderSettings;
import java.util.Arrays;
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

    /** Blocks that are surveyed to learn what an effort costs. */
    private static final int COST_BLOCKS = 512;

    /** Trial blocks: a share of the picture, but not less than this, or little is known. */
    private static final int LEAST_TRIAL = 320;

    private static final int TRIAL_SHARE = 16;

    /** What is aimed at, as a share of the error asked for: the trial has seen only some of the picture. */
    private static final double AIM = 0.85;

    private static final int MOST_TRIALS = 7;

    private static final double FIRST_SAMPLES = 4;

    /** The share of a time budget that the trial may take, and the share that is planned with. */
    private static final double TRIAL_TIME = 0.15;

    private static final double PLANNED_TIME = 0.9;
    private static final double NANO = 1e-9;

    private final CompiledScene scene;
    private final RenderSettings settings;
    private final BooleanSupplier cancelled;
    private final boolean cluster;
    private ClusterCost cost;

    Planner(CompiledScene scene, RenderSettings settings, BooleanSupplier cancelled) {
        this.scene = scene;
        this.settings = settings;
        this.cancelled = cancelled;
        cluster = settings.method().equals("cluster");
    }

    RenderPlan plan() {
        long start = System.nanoTime();
        Budget budget = settings.budget();
        double antialias = (double) settings.antialias() * settings.antialias();
        if (budget.isNone()) {
            return cluster ? withSamples(antialias, "antialias") : new RenderPlan(0, antialias, "antialias");
        }
        double samples = Budget.MAX_SAMPLES;
        String by = "samples";
        if (budget.samples().isPresent()) {
            samples = budget.samples().getAsDouble();
        }
        if (budget.error().isPresent()) {
            double n = samplesForError(AIM * budget.error().getAsDouble(), samples, until(budget, start));
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

    /** When to stop looking for the samples that an error takes: where there is not much time, time decides. */
    private BooleanSupplier until(Budget budget, long start) {
        if (budget.seconds().isEmpty()) {
            return cancelled;
        }
        double most = TRIAL_TIME * budget.seconds().getAsDouble();
        return () -> cancelled.getAsBoolean() || (System.nanoTime() - start) * NANO > most;
    }

    private RenderPlan withSamples(double samples, String by) {
        return new RenderPlan(level(samples), samples, by);
    }

    private double level(double samples) {
        if (!cluster) {
            return Math.max(samples, 1);
        }
        return cost().effort(samples);
    }

    private ClusterCost cost() {
        if (cost == null) {
            cost = ClusterCost.of(scene, settings, COST_BLOCKS);
        }
        return cost;
    }

    /** The number of samples for which the error is this, but not more than the most, or that if it is stopped. */
    private double samplesForError(double error, double most, BooleanSupplier stop) {
        double least = Math.min(cluster ? cost().samples(0) : 1, most);
        ErrorSearch search = new ErrorSearch(error, least, most);
        double n = Math.min(Math.max(FIRST_SAMPLES, least), most);
        for (int k = 0; k < MOST_TRIALS; k++) {
            double e = trial(n, Integer.MAX_VALUE, stop);
            if (stop.getAsBoolean()) {
                return most;
            }
            search.found(n, e);
            if (search.isOver()) {
                break;
            }
            n = search.next();
        }
        double found = search.answer();
        return found < most ? tidy(found) : most;
    }

    /** The number of samples that take so much time, by trials that go on until the machine is warm. */
    private double samplesForTime(double seconds, long start) {
        double n = FIRST_SAMPLES;
        double perSample = 0;
        double elapsed = 0;
        int blocks = blocks();
        do {
            long before = System.nanoTime();
            int some = Math.max(Math.min(LEAST_TRIAL / 4, blocks), 1);
            trial(n, some, cancelled);
            double took = (System.nanoTime() - before) * NANO;
            int done = SpreadPlaces.of(across(), down(), some).size();
            perSample = took * blocks / done / n;
            elapsed = (System.nanoTime() - start) * NANO;
        } while (elapsed < TRIAL_TIME * seconds && !cancelled.getAsBoolean());
        RenderSettings.Crop region = settings.region();
        double share = (double) region.width() * region.height() / ((double) settings.width() * settings.height());
        return tidy(
                Math.min(Math.max((PLANNED_TIME * seconds - elapsed) / (perSample * share), 1), Budget.MAX_SAMPLES));
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

    private int across() {
        return (settings.width() + SIDE - 1) / SIDE;
    }

    private int down() {
        return (settings.height() + SIDE - 1) / SIDE;
    }

    private int blocks() {
        return across() * down();
    }

    /** Renders some blocks of the whole picture with so many samples and returns their estimated error. */
    private double trial(double samples, int most, BooleanSupplier stop) {
        int count = Math.min(most, Math.max(Math.min(blocks(), LEAST_TRIAL), blocks() / TRIAL_SHARE));
        List<int[]> places = SpreadPlaces.of(across(), down(), count);
        RenderSettings apart = settings.withSeed(Hash.of(settings.seed(), PURPOSE));
        RenderPlan plan = new RenderPlan(level(samples), samples, "trial");
        FilmTile[] tiles = new FilmTile[places.size()];
        Workers.run(settings.threads(), tiles.length, stop, () -> {
            TileMethod method = plan.method(scene, apart, new RayCounters(scene.kindNames.size()));
            return (IntConsumer) i -> {
                int x = places.get(i)[0] * SIDE;
                int y = places.get(i)[1] * SIDE;
                FilmTile tile =
                        new FilmTile(x, y, Math.min(SIDE, settings.width() - x), Math.min(SIDE, settings.height() - y));
                method.render(tile);
                tiles[i] = tile;
            };
        });
        return Arrays.asList(tiles).contains(null)
                ? 0
                : ErrorEstimate.of(Arrays.asList(tiles)).rmse();
    }
}
