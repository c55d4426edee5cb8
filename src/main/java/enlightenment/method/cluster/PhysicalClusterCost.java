package enlightenment.method.cluster;

import enlightenment.method.Block;
import enlightenment.method.Dither;
import enlightenment.sampling.Hash;
import enlightenment.scene.RenderSettings;
import enlightenment.world.CompiledScene;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.function.BooleanSupplier;

/** The number of camera rays that an effort of {@link PhysicalClusterMethod} costs, estimated from some blocks spread over the picture. */
public final class PhysicalClusterCost implements EffortCost {
    /** Mixed into the seed, so that trials share no random numbers with the picture. */
    private static final long PURPOSE = 0x706879736963L;

    /** The share of blocks in which first paths are traced, one in this many, with a least and a greatest number of blocks. */
    private static final int SHARE = 32;

    private static final int LEAST_BLOCKS = 24;
    private static final int MOST_BLOCKS = 512;

    /** If the needs estimated for a block's two colours differ by more than this share, few paths decide. */
    private static final double DOUBTFUL = 0.25;

    private final CompiledScene scene;
    private final RenderSettings settings;
    private final boolean reusesLight;
    private final SeenBlocks seen;
    private final List<Block> blocks;
    private final BooleanSupplier cancelled;

    /** The needs of the blocks by the exponent of the number of samples asked for, which sets the number of first paths. */
    private final Map<Integer, Needed> needed = new HashMap<>();

    /** The needs of the blocks by as many first paths as the picture takes, by that exponent. */
    private final Map<Integer, Needed> neededSurely = new HashMap<>();

    /**
     * Estimates from a share of the blocks that show more than background.
     *
     * @param reusesLight whether light subpaths are reused, too
     * @param cancelled once true, no more blocks are surveyed, and there is no effort
     */
    public PhysicalClusterCost(
            CompiledScene scene, RenderSettings settings, boolean reusesLight, BooleanSupplier cancelled) {
        this.reusesLight = reusesLight;
        this.scene = scene;
        this.settings = settings;
        this.cancelled = cancelled;
        seen = SeenBlocks.of(scene, settings, PhysicalClusterMethod.blockSide(settings));
        blocks = tried(settings, seen);
    }

    /** The blocks that are tried. */
    private static List<Block> tried(RenderSettings settings, SeenBlocks seen) {
        double all = (double) settings.width() / seen.pixelsOfBlock() * settings.height() * seen.share();
        return seen.spread((int) Math.min(Math.max(all / SHARE, LEAST_BLOCKS), MOST_BLOCKS));
    }

    /** The limits of camera rays in a block. */
    static BlockLimits limits(CompiledScene scene, RenderSettings settings, double samples) {
        SeenBlocks seen = SeenBlocks.of(scene, settings, PhysicalClusterMethod.blockSide(settings));
        return limits(seen, tried(settings, seen).size(), samples);
    }

    private static BlockLimits limits(SeenBlocks seen, int tried, double samples) {
        double share = seen.share();
        return share == 0
                ? BlockLimits.NONE
                : BlockLimits.of((samples - (1 - share) * ofEmpty(seen, samples)) / share, tried);
    }

    /** The camera rays per pixel of a block that shows only background. */
    private static double ofEmpty(SeenBlocks seen, double samples) {
        return Math.scalb(1.0, PhysicalAllocation.leastSamples(samples)) + 1.0 / seen.pixelsOfBlock();
    }

    @Override
    public double effort(double samples) {
        if (blocks.isEmpty()) {
            return EffortSearch.LEAST_EFFORT;
        }
        int exponent = Math.max(Math.getExponent(samples), 0);
        Needed known = needed.computeIfAbsent(exponent, e -> new Needed(samples, false));
        double effort = known.effort(samples);
        if (known.isDoubtful(effort, samples)) {
            return neededSurely
                    .computeIfAbsent(exponent, e -> new Needed(samples, true))
                    .effort(samples);
        }
        return effort;
    }

    /** The needs of the pixels of the blocks. */
    private final class Needed {
        private final double[] noise = new double[seen.pixelsOfBlock() * blocks.size()];
        private final double[] edge = new double[noise.length];
        private final double[] cost = new double[noise.length];
        private final double[] dither = new double[noise.length];
        private int pixels;
        private final int[] rays = new int[blocks.size()];

        Needed(double samples, boolean surely) {
            PhysicalClusterMethod method = surely
                    ? PhysicalClusterMethod.lookingAsPicture(scene, settings, samples, reusesLight)
                    : PhysicalClusterMethod.looking(scene, settings, samples, reusesLight);
            method.stopWhen(cancelled);
            // Not the picture's own samples: no decision may depend on the samples that it is about.
            long seed = Hash.of(settings.seed(), PURPOSE);
            for (int b = 0; b < rays.length; b++) {
                Block block = blocks.get(b);
                method.look(block, seed);
                rays[b] = method.surveyRays();
                for (int j = 0; j < block.height(); j++) {
                    for (int i = 0; i < block.width(); i++) {
                        noise[pixels] = method.noise(i, j);
                        edge[pixels] = method.edge(i, j);
                        cost[pixels] = method.cost(i, j);
                        dither[pixels++] = Dither.at(block.x() + i, block.y() + j);
                    }
                }
            }
        }

        double effort(double samples) {
            return EffortSearch.effort(effort -> samples(effort, samples), samples);
        }

        /**
         * Whether few of the paths decide: then the estimates by the two colours of a block disagree, and with more paths more blocks would
         * need samples, so that the same effort would cost more.
         */
        boolean isDoubtful(double effort, double asked) {
            PhysicalAllocation allocation = new PhysicalAllocation(effort, asked);
            long least = 1L << PhysicalAllocation.leastSamples(asked);
            double apart = 0;
            double sum = 0;
            int k = 0;
            for (Block block : blocks) {
                long[] ofColour = new long[2];
                for (int j = 0; j < block.height(); j++) {
                    for (int i = 0; i < block.width(); i++, k++) {
                        ofColour[PathNoise.field(i, j)] +=
                                (1L << allocation.samples(noise[k], edge[k], cost[k], dither[k])) - least;
                    }
                }
                apart += Math.abs(ofColour[0] - ofColour[1]);
                sum += ofColour[0] + ofColour[1];
            }
            return apart > DOUBTFUL * sum;
        }

        /** The mean number of camera rays per pixel, the survey's included. */
        double samples(double effort, double asked) {
            PhysicalAllocation allocation = new PhysicalAllocation(effort, asked);
            BlockLimits limits = limits(seen, rays.length, asked);
            double sum = 0;
            int k = 0;
            for (int b = 0; b < rays.length; b++) {
                long ofBlock = rays[b];
                int n = blocks.get(b).pixels();
                for (int end = k + n; k < end; k++) {
                    ofBlock += 1L << allocation.samples(noise[k], edge[k], cost[k], dither[k]);
                }
                sum += n * limits.limited((double) ofBlock / n);
            }
            return seen.share() * (sum / pixels) + (1 - seen.share()) * ofEmpty(seen, asked);
        }
    }
}
