package enlightenment.method.cluster;

import enlightenment.compiled.CompiledScene;
import enlightenment.compiled.RayCounters;
import enlightenment.method.SpreadPlaces;
import enlightenment.sampling.Distribution;
import enlightenment.scene.RenderSettings;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.CancellationException;
import java.util.function.BooleanSupplier;

/** How many camera rays an effort costs, judged by the survey of some blocks spread over the picture. */
public final class ClusterCost {
    private static final double LEAST_EFFORT = 1;

    /** Binary logarithm of the greatest effort: variances below the rounding of pixels are worth nothing. */
    private static final int MOST_EFFORT = 64;

    /** Halvings of the interval of logarithms: the number of samples is then met within about 0.1 %, which no sampler spends more exactly. */
    private static final int HALVINGS = 14;

    private final CompiledScene scene;
    private final RenderSettings settings;
    private final RayCounters counters;
    private final List<Block> blocks = new ArrayList<>();

    /** Which of the blocks may learn, and so need less than their first survey shows, for more rays. */
    private final List<Integer> learners = new ArrayList<>();

    private final Needed surveyed;
    private final BooleanSupplier cancelled;

    private ClusterCost(CompiledScene scene, RenderSettings settings, int blockCount, BooleanSupplier cancelled) {
        this.cancelled = cancelled;
        this.scene = scene;
        this.settings = settings;
        counters = new RayCounters(scene.kindNames.size());
        surveyed = new Needed(blockCount);
    }

    /** Surveys so many blocks, or all if there are not more. */
    public static ClusterCost of(CompiledScene scene, RenderSettings settings, int blocks) {
        return of(scene, settings, blocks, () -> false);
    }

    /**
     * The same, unless it is cancelled.
     *
     * @param cancelled once true, what is surveyed has to do: whoever asks for the effort then gets some number
     */
    public static ClusterCost of(CompiledScene scene, RenderSettings settings, int blocks, BooleanSupplier cancelled) {
        int across = (settings.width() + Block.SIDE - 1) / Block.SIDE;
        int down = (settings.height() + Block.SIDE - 1) / Block.SIDE;
        List<int[]> places = SpreadPlaces.of(across, down, blocks);
        ClusterCost cost = new ClusterCost(scene, settings, places.size(), cancelled);
        ClusterMethod method = cost.method(LEAST_EFFORT);
        try {
            for (int[] place : places) {
                cost.survey(
                        Block.around(place[0] * Block.SIDE, place[1] * Block.SIDE, settings.width(), settings.height()),
                        method);
            }
        } catch (CancellationException e) {
            cost.learners.clear();
        }
        return cost;
    }

    private void survey(Block block, ClusterMethod method) {
        method.prepare(block);
        if (method.mayLearn()) {
            learners.add(blocks.size());
        }
        surveyed.set(blocks.size(), block, method);
        blocks.add(block);
    }

    private ClusterMethod method(double effort) {
        ClusterMethod method =
                new ClusterMethod(scene, settings, counters, Distribution.of(settings.proposal()), effort);
        method.stopWhen(cancelled);
        return method;
    }

    /**
     * The greatest effort that costs no more than so many samples per pixel, as far as the blocks tell; at least the least one,
     * whatever it costs. Blocks that learn are taken as they are with the effort that would be right if they did not.
     */
    public double effort(double samples) {
        double effort = surveyed.effort(samples);
        if (learners.isEmpty()) {
            return effort;
        }
        Needed learned = new Needed(surveyed);
        ClusterMethod method = method(effort);
        try {
            for (int k : learners) {
                method.prepare(blocks.get(k));
                learned.set(k, blocks.get(k), method);
            }
        } catch (CancellationException e) {
            return effort;
        }
        return learned.effort(samples);
    }

    /** What the pixels of some blocks need, as {@link Needs} says it. */
    private static final class Needed {
        private static final int PIXELS = Block.SIDE * Block.SIDE;

        private final double[] film;
        private final double[] edge;
        private final double[] light;
        private final int[] pixels;
        private final int[] rays;

        Needed(int blocks) {
            film = new double[blocks * PIXELS];
            edge = new double[film.length];
            light = new double[film.length];
            pixels = new int[blocks];
            rays = new int[blocks];
        }

        Needed(Needed other) {
            film = other.film.clone();
            edge = other.edge.clone();
            light = other.light.clone();
            pixels = other.pixels.clone();
            rays = other.rays.clone();
        }

        /** Takes over what a block was found to need. */
        void set(int index, Block block, ClusterMethod method) {
            Needs needs = method.needs();
            int n = PIXELS * index;
            for (int j = 0; j < block.height(); j++) {
                for (int i = 0; i < block.width(); i++) {
                    film[n] = needs.film[Block.SIDE * j + i];
                    edge[n] = needs.edge[Block.SIDE * j + i];
                    light[n++] = needs.light[Block.SIDE * j + i];
                }
            }
            pixels[index] = block.width() * block.height();
            rays[index] = method.surveyRays();
        }

        /** Mean number of camera rays per pixel, the survey's included. */
        double samples(double effort) {
            Allocation allocation = new Allocation(effort);
            long sum = 0;
            long all = 0;
            for (int b = 0; b < pixels.length; b++) {
                sum += rays[b];
                all += pixels[b];
                int first = PIXELS * b;
                for (int k = first; k < first + pixels[b]; k++) {
                    sum += 1L << allocation.samples(film[k], edge[k], light[k]);
                }
            }
            return (double) sum / all;
        }

        double effort(double samples) {
            double low = 0;
            double high = MOST_EFFORT;
            for (int k = 0; k < HALVINGS; k++) {
                double middle = (low + high) / 2;
                if (samples(power(middle)) <= samples) {
                    low = middle;
                } else {
                    high = middle;
                }
            }
            return power(low);
        }
    }

    private static double power(double exponent) {
        int whole = (int) exponent;
        // Between powers of two a straight line does: the effort need only grow.
        return Math.scalb(1 + (exponent - whole), whole);
    }
}
