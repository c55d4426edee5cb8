package enlightenment.method.cluster;

import enlightenment.compiled.CompiledScene;
import enlightenment.compiled.RayCounters;
import enlightenment.film.FilmTile;
import enlightenment.method.Block;
import enlightenment.method.Dither;
import enlightenment.sampling.Distribution;
import enlightenment.sampling.Hash;
import enlightenment.scene.ClusterSettings;
import enlightenment.scene.RenderSettings;
import java.util.ArrayList;
import java.util.List;
import java.util.function.BooleanSupplier;

/** How many camera rays an effort costs, judged by the survey of some blocks spread over the picture. */
public final class ClusterCost implements EffortCost {
    /** Keeps the random numbers of what is tried apart from the picture's. */
    private static final long PURPOSE = 0x636f7374L;

    private final CompiledScene scene;
    private final RenderSettings settings;
    private final RayCounters counters;
    /**
     * From these numbers of samples on blocks are judged anew: more first samples tell about the others, or there are enough to
     * judge by more blocks.
     */
    private static final double[] FROM = {1, 8, 16, 64};

    /** How many times as many blocks then. */
    private static final int[] TIMES = {1, 1, 1, 4};

    private final SeenBlocks seen;
    private final int blockCount;
    private final Surveyed[] surveyed = new Surveyed[FROM.length];
    private final BooleanSupplier cancelled;

    private ClusterCost(CompiledScene scene, RenderSettings settings, int blockCount, BooleanSupplier cancelled) {
        this.cancelled = cancelled;
        this.scene = scene;
        this.settings = settings;
        this.blockCount = blockCount;
        seen = SeenBlocks.of(scene, settings, FilmTile.BLOCK_SIDE);
        counters = new RayCounters(scene.kindNames.size());
    }

    /** Judges by {@code blocks} blocks or a few times as many, or by all if there are no more. */
    public static ClusterCost of(CompiledScene scene, RenderSettings settings, int blocks) {
        return of(scene, settings, blocks, () -> false);
    }

    /**
     * The same, unless it is cancelled.
     *
     * @param cancelled once true, nothing more is surveyed, and there is no effort
     */
    public static ClusterCost of(CompiledScene scene, RenderSettings settings, int blocks, BooleanSupplier cancelled) {
        return new ClusterCost(scene, settings, blocks, cancelled);
    }

    private ClusterMethod method(double effort, double samples) {
        ClusterMethod method = new ClusterMethod(
                scene,
                settings,
                counters,
                Distribution.of(ClusterSettings.of(settings).proposal()),
                effort,
                samples);
        method.stopWhen(cancelled);
        return method;
    }

    private Surveyed surveyed(double samples) {
        int k = FROM.length - 1;
        while (k > 0 && samples < FROM[k]) {
            k--;
        }
        if (surveyed[k] == null) {
            surveyed[k] = new Surveyed(blocks(TIMES[k]), FROM[k]);
        }
        return surveyed[k];
    }

    private List<Block> blocks(int times) {
        return seen.spread(times * blockCount);
    }

    /**
     * The largest effort that costs at most this many samples per pixel, as far as the blocks tell; at least the smallest one,
     * whatever it costs. Blocks that learn are taken as they are with the effort that would be right if they did not.
     */
    @Override
    public double effort(double samples) {
        if (seen.share() == 0) {
            return EffortSearch.LEAST_EFFORT;
        }
        Surveyed known = surveyed(samples);
        double effort = known.needed.effort(samples);
        if (known.learners.isEmpty()) {
            return effort;
        }
        Needed learned = new Needed(known.needed);
        ClusterMethod method = method(effort, samples);
        for (int k : known.learners) {
            Block block = known.blocks.get(k);
            method.prepare(block);
            if (method.hasLookedMore()) {
                look(method, block);
                learned.set(k, block, method);
            }
        }
        return learned.effort(samples);
    }

    private void look(ClusterMethod method, Block block) {
        // Not the picture's own samples: nothing that is decided may depend on those that it is decided about.
        method.look(block, Hash.of(settings.seed(), PURPOSE));
    }

    /** What all blocks need before any of them has learned. */
    private final class Surveyed {
        private final List<Block> blocks;
        private final Needed needed;

        /** Which of the blocks may learn, and so need less than their first survey shows, for more rays. */
        private final List<Integer> learners = new ArrayList<>();

        Surveyed(List<Block> blocks, double samples) {
            this.blocks = blocks;
            needed = new Needed(blocks.size());
            ClusterMethod method = method(EffortSearch.LEAST_EFFORT, samples);
            for (int k = 0; k < blocks.size(); k++) {
                Block block = blocks.get(k);
                method.prepare(block);
                look(method, block);
                if (method.mayLearn()) {
                    learners.add(k);
                }
                needed.set(k, block, method);
            }
        }
    }

    /** What the pixels of some blocks need, as {@link SampleDemand} says it. */
    private final class Needed {
        private static final int PIXELS = FilmTile.BLOCK_SIDE * FilmTile.BLOCK_SIDE;

        /** The camera rays per pixel of a block that shows only background: one sample each, and a corner for all. */
        private static final double OF_EMPTY = 1 + 1.0 / PIXELS;

        private final double[] film;
        private final double[] edge;
        private final double[] light;
        private final double[] dither;
        private final int[] pixels;
        private final int[] rays;

        Needed(int blocks) {
            film = new double[blocks * PIXELS];
            edge = new double[film.length];
            light = new double[film.length];
            dither = new double[film.length];
            pixels = new int[blocks];
            rays = new int[blocks];
        }

        Needed(Needed other) {
            film = other.film.clone();
            edge = other.edge.clone();
            light = other.light.clone();
            dither = other.dither;
            pixels = other.pixels.clone();
            rays = other.rays.clone();
        }

        /** Takes over what a block was found to need. */
        void set(int index, Block block, ClusterMethod method) {
            SampleDemand needs = method.needs();
            int n = PIXELS * index;
            for (int j = 0; j < block.height(); j++) {
                for (int i = 0; i < block.width(); i++) {
                    film[n] = needs.film[FilmTile.BLOCK_SIDE * j + i];
                    edge[n] = needs.edge[FilmTile.BLOCK_SIDE * j + i];
                    dither[n] = Dither.at(block.x() + i, block.y() + j);
                    light[n++] = needs.light[FilmTile.BLOCK_SIDE * j + i];
                }
            }
            pixels[index] = block.width() * block.height();
            rays[index] = method.surveyRays();
        }

        /** Mean number of camera rays per pixel, the survey's included. */
        double samples(double effort, double asked) {
            Allocation allocation = new Allocation(effort, asked, seen.share());
            long sum = 0;
            long all = 0;
            for (int b = 0; b < pixels.length; b++) {
                sum += rays[b];
                all += pixels[b];
                int first = PIXELS * b;
                for (int k = first; k < first + pixels[b]; k++) {
                    sum += 1L << allocation.samples(film[k], edge[k], light[k], dither[k]);
                }
            }
            return seen.share() * ((double) sum / all) + (1 - seen.share()) * OF_EMPTY;
        }

        double effort(double samples) {
            return EffortSearch.effort(effort -> samples(effort, samples), samples);
        }
    }
}
