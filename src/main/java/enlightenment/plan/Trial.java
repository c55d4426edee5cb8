package enlightenment.plan;

import enlightenment.color.DisplayCurve;
import enlightenment.film.FilmTile;
import enlightenment.film.SplatBatch;
import enlightenment.film.SplatScale;
import enlightenment.method.SplatIntegrator;
import enlightenment.method.TileIntegrator;
import enlightenment.method.cluster.SeenBlocks;
import enlightenment.sampling.Hash;
import enlightenment.scene.RenderSettings;
import enlightenment.transport.ray.Shader;
import enlightenment.work.Stopwatch;
import enlightenment.work.Workers;
import enlightenment.world.CompiledScene;
import enlightenment.world.parts.RayCounters;
import java.util.List;
import java.util.concurrent.atomic.DoubleAdder;
import java.util.function.BooleanSupplier;
import java.util.function.IntConsumer;
import java.util.function.Supplier;

/**
 * Renders some blocks, or follows some paths, with random numbers that are not the picture's: nothing may depend on what it is decided
 * about.
 */
final class Trial {
    /** Keeps the trial's random numbers apart from the picture's. */
    private static final long PURPOSE = 0x747269616cL;

    /** Paths of a batch: enough to hide the cost of beginning and ending it, few enough to be stopped soon. */
    private static final int AT_ONCE = 1 << 12;

    private final CompiledScene scene;
    private final RenderSettings settings;
    private final SamplePlans plans;

    /** Seconds of processors that went into pieces. */
    private final DoubleAdder worked = new DoubleAdder();

    Trial(CompiledScene scene, RenderSettings settings, SamplePlans plans) {
        this.scene = scene;
        this.settings = settings.withSeed(Hash.of(settings.seed(), PURPOSE));
        this.plans = plans;
    }

    /** The display curve of the pixels. */
    DisplayCurve display() {
        return scene.display;
    }

    /** Seconds of processor time that all trials so far have taken; 0 where the system does not report it. */
    double processorSeconds() {
        return worked.sum();
    }

    private void work(Runnable piece) {
        double before = Stopwatch.threadSeconds();
        piece.run();
        worked.add(Stopwatch.threadSeconds() - before);
    }

    /** The work of a trial for a time. It is a part of the picture, or some of the paths that may end anywhere. */
    interface Piece {
        /** The number of pixels that take about as long. */
        double pixels();

        /** Renders it with this many samples per pixel, unless it is stopped. */
        void render(double samples, BooleanSupplier stop);
    }

    /**
     * A piece of the picture that is rendered, the same each time.
     *
     * @param share how large it should be, of the whole
     * @param fewestBlocks how large it should be at least
     */
    Piece piece(double share, double fewestBlocks) {
        if (Integrators.traits(settings).areBatches()) {
            double blocks = plans.tracedPixels() / (FilmTile.BLOCK_SIDE * FilmTile.BLOCK_SIDE);
            return new Paths(Math.max(share, Math.min(fewestBlocks / blocks, 1)) * plans.tracedPixels());
        }
        TrialBlocks blocks =
                new TrialBlocks(settings, scene.display, plans.traits().blockSide());
        double ofBlocks = Math.max(share, fewestOf(blocks, fewestBlocks) / blocks.count());
        if (plans.traits().below() == settings.method()) {
            return new Blocks(() -> blocks.phase(0, ofBlocks), 1);
        }
        // Of a method that surveys the picture, what shows something takes more samples the less of it there is.
        Shader shader = SeenBlocks.shader(scene);
        TrialBlocks.Seen seen = blocks.seen(
                ofBlocks, c -> SeenBlocks.seesSomething(shader, settings, c.x(), c.y(), c.width(), c.height()));
        return new Blocks(
                () -> seen.blocks().stream()
                        .map(b -> new FilmTile(b.x, b.y, b.width, b.height, scene.display))
                        .toList(),
                seen.share());
    }

    /** The number of the method's blocks with the pixels of {@code fewestBlocks} ordinary ones; at least one per thread. */
    private double fewestOf(TrialBlocks blocks, double fewestBlocks) {
        int side = plans.traits().blockSide();
        if (side == FilmTile.BLOCK_SIDE) {
            return fewestBlocks;
        }
        double number = fewestBlocks * FilmTile.BLOCK_SIDE / side * FilmTile.BLOCK_SIDE / side;
        return Math.max(number, settings.threads());
    }

    private final class Blocks implements Piece {
        private final Supplier<List<FilmTile>> blocks;
        private final double share;

        /**
         * @param blocks without samples yet, each time
         * @param share of the blocks of the picture that these stand for: the others take next to no time
         */
        Blocks(Supplier<List<FilmTile>> blocks, double share) {
            this.blocks = blocks;
            this.share = share;
        }

        @Override
        public double pixels() {
            return blocks.get().stream().mapToInt(b -> b.width * b.height).sum() / share;
        }

        @Override
        public void render(double samples, BooleanSupplier stop) {
            Trial.this.render(samples, blocks.get(), stop);
            RenderPlan plan = plans.of(samples, "trial");
            if (plan.lightPaths() > 0) {
                follow(plan, plan.lightPaths() * (pixels() / plans.tracedPixels()), stop);
            }
        }
    }

    private final class Paths implements Piece {
        private final double pixels;

        Paths(double pixels) {
            this.pixels = pixels;
        }

        @Override
        public double pixels() {
            return pixels;
        }

        @Override
        public void render(double samples, BooleanSupplier stop) {
            follow(plans.of(samples, "trial"), samples * pixels, stop);
        }
    }

    /** Follows about this many paths that may end anywhere. */
    private void follow(RenderPlan plan, double paths, BooleanSupplier stop) {
        int batches = (int) Math.min(Math.max(Math.rint(paths / AT_ONCE), 1), Integer.MAX_VALUE);
        RenderSettings.Crop region = settings.region();
        long pixels = (long) settings.width() * settings.height();
        Workers.run(settings.threads(), batches, stop, () -> {
            RayCounters counters = new RayCounters(scene.kindNames.size());
            SplatIntegrator method = Integrators.splats(plan, scene, settings, counters);
            SplatScale scale = SplatScale.of(method.expectedContribution(), (long) batches * AT_ONCE, pixels);
            // Not before: what is not a piece of the work cannot be ended in its middle.
            method.stopWhen(stop);
            SplatBatch out = new SplatBatch(region.x(), region.y(), region.width(), region.height(), scale);
            return (IntConsumer) i -> work(() -> {
                out.begin(AT_ONCE);
                method.trace((long) i * AT_ONCE, AT_ONCE, out);
                // The sums are discarded, but computing them takes time that counts.
                out.sums();
            });
        });
    }

    /** Renders these blocks with this many samples per pixel, unless it is stopped. */
    void render(double samples, List<FilmTile> blocks, BooleanSupplier stop) {
        RenderPlan plan = plans.of(samples, "trial");
        Workers.run(settings.threads(), blocks.size(), stop, () -> {
            TileIntegrator method =
                    (TileIntegrator) Integrators.of(plan, scene, settings, new RayCounters(scene.kindNames.size()));
            method.stopWhen(stop);
            return (IntConsumer) i -> work(() -> method.render(blocks.get(i)));
        });
    }
}
