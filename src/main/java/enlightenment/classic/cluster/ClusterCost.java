package enlightenment.classic.cluster;

import enlightenment.film.FilmTile;
import enlightenment.method.Block;
import enlightenment.method.cluster.BlockLimits;
import enlightenment.method.cluster.EffortCost;
import enlightenment.method.cluster.EffortSearch;
import enlightenment.method.cluster.SeenBlocks;
import enlightenment.sampling.Distribution;
import enlightenment.sampling.Hash;
import enlightenment.scene.BuiltInMethod;
import enlightenment.scene.RenderSettings;
import enlightenment.world.CompiledScene;
import enlightenment.world.parts.RayCounters;
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
     * From these numbers of samples on blocks are judged anew, with as many first samples as pictures of that many have. Beyond the last,
     * pictures have more first samples: as long as the blocks' own show thin things, what is spent differs by a few per cent.
     */
    private static final double[] FROM = {1, 8, 16, 64};

    /** The camera rays per pixel of a block that shows only background: one sample each, and a corner for all. */
    private static final double OF_EMPTY = 1 + 1.0 / (FilmTile.BLOCK_SIDE * FilmTile.BLOCK_SIDE);

    /**
     * With this many non-empty blocks a single one changes the total little. A pixel takes at most this many times the mean. With fewer
     * blocks each gets limits of its own, if they cover little of the picture or are very few, so that looking at them apart costs little.
     */
    private static final int MANY = 64;

    private static final double FEW_OF_THE_PICTURE = 0.25;
    private static final int VERY_FEW = 8;

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

    /** Judges by {@code blocks} blocks, or by all if there are no more. */
    public static ClusterCost of(CompiledScene scene, RenderSettings settings, int blocks) {
        return of(scene, settings, blocks, () -> false);
    }

    /**
     * The cost judged by {@code blocks} blocks, with a cancellation check.
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
                Distribution.of(BuiltInMethod.ClusterSettings.of(settings).proposal()),
                effort,
                samples);
        method.stopWhen(cancelled);
        return method;
    }

    private Surveyed surveyed(double samples) {
        int k = isEachLimited(seen)
                ? allocation(seen, EffortSearch.LEAST_EFFORT, samples).apart() + 1
                : judgedLike(samples);
        if (surveyed[k] == null) {
            surveyed[k] = new Surveyed(seen.spread(blockCount), judgedBy(k));
        }
        return surveyed[k];
    }

    private static int judgedLike(double samples) {
        int k = FROM.length - 1;
        while (k > 0 && samples < FROM[k]) {
            k--;
        }
        return k;
    }

    /** Where each block is limited, what it is looked at with grows with its own samples, and not with those of the picture. */
    private double judgedBy(int k) {
        double share = seen.share();
        return isEachLimited(seen) ? share * BlockAllocation.samplesFor(k - 1) + (1 - share) * OF_EMPTY : FROM[k];
    }

    /** What the pixels of a block get for an effort, where this many samples are asked for. */
    static BlockAllocation allocation(CompiledScene scene, RenderSettings settings, double effort, double samples) {
        return allocation(SeenBlocks.of(scene, settings, FilmTile.BLOCK_SIDE), effort, samples);
    }

    private static BlockAllocation allocation(SeenBlocks seen, double effort, double samples) {
        double share = seen.share();
        BlockLimits limits = isEachLimited(seen)
                ? BlockLimits.ofFew((samples - (1 - share) * OF_EMPTY) / share, seen.size())
                : BlockLimits.NONE;
        return new BlockAllocation(effort, samples, share, limits);
    }

    private static boolean isEachLimited(SeenBlocks seen) {
        return seen.size() > 0 && seen.size() < (seen.share() < FEW_OF_THE_PICTURE ? MANY : VERY_FEW);
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
            if (method.hasLookedMore() || isEachLimited(seen)) {
                look(method, block);
                learned.set(k, method);
            }
        }
        return learned.effort(samples);
    }

    private void look(ClusterMethod method, Block block) {
        // Not the picture's own samples: nothing that is decided may depend on those that it is decided about.
        method.look(block, seed(settings));
    }

    /** Of the random numbers of what is tried. */
    static long seed(RenderSettings settings) {
        return Hash.of(settings.seed(), PURPOSE);
    }

    /** What all blocks need before any of them has learned. */
    private final class Surveyed {
        private final List<Block> blocks;
        private final Needed needed;

        /** Which of the blocks may learn, and so need less than their first survey shows, for more rays. */
        private final List<Integer> learners = new ArrayList<>();

        Surveyed(List<Block> blocks, double samples) {
            this.blocks = blocks;
            needed = new Needed(blocks);
            ClusterMethod method = method(EffortSearch.LEAST_EFFORT, samples);
            for (int k = 0; k < blocks.size(); k++) {
                Block block = blocks.get(k);
                method.prepare(block);
                look(method, block);
                if (method.mayLearn()) {
                    learners.add(k);
                }
                needed.set(k, method);
            }
        }
    }

    /** What the pixels of some blocks need, as {@link SampleDemand} says it. */
    private final class Needed {
        private final List<Block> blocks;
        private final SampleDemand[] needs;
        private final int[] rays;

        Needed(List<Block> blocks) {
            this.blocks = blocks;
            needs = new SampleDemand[blocks.size()];
            rays = new int[blocks.size()];
        }

        Needed(Needed other) {
            blocks = other.blocks;
            needs = other.needs.clone();
            rays = other.rays.clone();
        }

        /** Takes over what a block was found to need. */
        void set(int index, ClusterMethod method) {
            needs[index] = method.needs().copy();
            rays[index] = method.surveyRays();
        }

        /** Mean number of camera rays per pixel, the survey's included. */
        double samples(double effort, double asked) {
            BlockAllocation allocation = allocation(seen, effort, asked);
            double sum = 0;
            long all = 0;
            for (int b = 0; b < rays.length; b++) {
                Block block = blocks.get(b);
                sum += allocation.spent(needs[b], block, rays[b]);
                all += block.pixels();
            }
            return seen.share() * (sum / all) + (1 - seen.share()) * OF_EMPTY;
        }

        double effort(double samples) {
            return EffortSearch.effort(effort -> samples(effort, samples), samples);
        }
    }
}
