package enlightenment.method.cluster;

import enlightenment.compiled.CompiledScene;
import enlightenment.method.Block;
import enlightenment.method.Dither;
import enlightenment.sampling.Hash;
import enlightenment.scene.RenderSettings;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.concurrent.CancellationException;
import java.util.function.BooleanSupplier;

/** How many camera rays an effort of {@link PhysicalClusterMethod} costs, judged by some blocks spread over the picture. */
public final class PhysicalClusterCost implements EffortCost {
    /** Keeps the random numbers of what is tried apart from the picture's. */
    private static final long PURPOSE = 0x706879736963L;

    private final CompiledScene scene;
    private final RenderSettings settings;
    private final List<Block> blocks;
    private final BooleanSupplier cancelled;

    /** What the blocks need, by the exponent of the number of samples asked for: the number of first paths changes with it. */
    private final Map<Integer, Needed> needed = new HashMap<>();

    /**
     * Judges by {@code blocks} blocks, or by all if there are no more.
     *
     * @param cancelled once true, nothing more is looked at, and the effort is the least
     */
    public PhysicalClusterCost(CompiledScene scene, RenderSettings settings, int blocks, BooleanSupplier cancelled) {
        this.scene = scene;
        this.settings = settings;
        this.cancelled = cancelled;
        this.blocks = Block.spread(settings.width(), settings.height(), PhysicalClusterMethod.BLOCK_SIDE, blocks);
    }

    @Override
    public double effort(double samples) {
        try {
            Needed known = needed.computeIfAbsent(Math.max(Math.getExponent(samples), 0), e -> new Needed(samples));
            return EffortSearch.effort(effort -> known.samples(effort, samples), samples);
        } catch (CancellationException e) {
            return EffortSearch.LEAST_EFFORT;
        }
    }

    /** What the pixels of the blocks need. */
    private final class Needed {
        private final double[] noise = new double[PhysicalClusterMethod.PIXELS * blocks.size()];
        private final double[] edge = new double[noise.length];
        private final double[] cost = new double[noise.length];
        private final double[] dither = new double[noise.length];
        private int pixels;
        private long rays;

        Needed(double samples) {
            PhysicalClusterMethod method = PhysicalClusterMethod.looking(scene, settings, samples);
            method.stopWhen(cancelled);
            // Not the picture's own samples: nothing that is decided may depend on those that it is decided about.
            long seed = Hash.of(settings.seed(), PURPOSE);
            for (Block block : blocks) {
                method.look(block, seed);
                rays += method.surveyRays();
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

        /** Mean number of camera rays per pixel, the survey's included. */
        double samples(double effort, double asked) {
            PhysicalAllocation allocation = new PhysicalAllocation(effort, asked);
            long sum = rays;
            for (int k = 0; k < pixels; k++) {
                sum += 1L << allocation.samples(noise[k], edge[k], cost[k], dither[k]);
            }
            return (double) sum / pixels;
        }
    }
}
