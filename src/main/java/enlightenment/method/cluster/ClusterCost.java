package enlightenment.method.cluster;

import enlightenment.compiled.CompiledScene;
import enlightenment.compiled.RayCounters;
import enlightenment.method.SpreadPlaces;
import enlightenment.sampling.Distribution;
import enlightenment.scene.RenderSettings;
import java.util.List;

/** How many camera rays an effort costs, judged by the survey of some blocks spread over the picture. */
public final class ClusterCost {
    private static final double LEAST_EFFORT = 1;

    /** Binary logarithm of the greatest effort: variances below the rounding of pixels are worth nothing. */
    private static final int MOST_EFFORT = 64;

    /** Halvings of the interval of logarithms: the number of samples is then met within about 0.1 %, which no sampler spends more exactly. */
    private static final int HALVINGS = 14;

    private final double[] film;
    private final double[] edge;
    private final double[] light;
    private int pixels;
    private long surveyRays;

    /** The cost of nothing yet, with room for so many blocks. */
    private ClusterCost(int blocks) {
        film = new double[blocks * Block.SIDE * Block.SIDE];
        edge = new double[film.length];
        light = new double[film.length];
    }

    /** Surveys so many blocks, or all if there are not more. */
    public static ClusterCost of(CompiledScene scene, RenderSettings settings, int blocks) {
        RayCounters counters = new RayCounters(scene.kindNames.size());
        ClusterMethod method =
                new ClusterMethod(scene, settings, counters, Distribution.of(settings.proposal()), LEAST_EFFORT);
        int across = (settings.width() + Block.SIDE - 1) / Block.SIDE;
        int down = (settings.height() + Block.SIDE - 1) / Block.SIDE;
        List<int[]> places = SpreadPlaces.of(across, down, blocks);
        ClusterCost cost = new ClusterCost(places.size());
        for (int[] place : places) {
            Block block =
                    Block.around(place[0] * Block.SIDE, place[1] * Block.SIDE, settings.width(), settings.height());
            method.prepare(block);
            cost.add(method.needs(), block);
            cost.surveyRays += method.surveyRays();
        }
        return cost;
    }

    private void add(Needs needs, Block block) {
        for (int j = 0; j < block.height(); j++) {
            for (int i = 0; i < block.width(); i++) {
                film[pixels] = needs.film[Block.SIDE * j + i];
                edge[pixels] = needs.edge[Block.SIDE * j + i];
                light[pixels++] = needs.light[Block.SIDE * j + i];
            }
        }
    }

    /** Mean number of camera rays per pixel, the survey's included. */
    public double samples(double effort) {
        Allocation allocation = new Allocation(effort);
        long sum = surveyRays;
        for (int k = 0; k < pixels; k++) {
            sum += 1L << allocation.samples(film[k], edge[k], light[k]);
        }
        return (double) sum / pixels;
    }

    /** The greatest effort that costs no more than so many samples per pixel; at least the least one, whatever it costs. */
    public double effort(double samples) {
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

    private static double power(double exponent) {
        int whole = (int) exponent;
        // Between powers of two a straight line does: the effort need only grow.
        return Math.scalb(1 + (exponent - whole), whole);
    }
}
