package enlightenment.plan;

import enlightenment.scene.RenderSettings;
import java.util.ArrayList;
import java.util.List;

/**
 * What allocation makes of the variance of blocks: methods that survey the picture take the more samples of a pixel the more the paths of its
 * neighbours vary, beside the half that all pixels have. As there, the variance of pixels of one chessboard colour allocates the samples of the
 * other, so that rare bright paths gain nothing by having been seen.
 */
final class PilotAllocation {
    /** Side of the cells whose pixels allocate samples to each other. */
    private static final int CELL = 4;

    /** The share of samples that are the same for all pixels. */
    private static final double EVEN = 0.5;

    private PilotAllocation() {}

    /** Pixels of one colour in a cell, by the sum of their variances, and the root of the mean variance of the others. */
    private record Half(int pixels, double variance, double root) {
        Half(double[] sums, int[] counts, int color) {
            this(
                    counts[color],
                    sums[color],
                    counts[1 - color] == 0 ? 0 : Math.sqrt(sums[1 - color] / counts[1 - color]));
        }
    }

    /**
     * The mean variance of pixels after allocation of as many samples.
     *
     * @param variance of one sample of each pixel, block by block
     */
    static double mean(double[] variance, List<RenderSettings.Crop> blocks) {
        List<Half> halves = halves(variance, blocks);
        double roots = halves.stream().mapToDouble(h -> h.pixels * h.root).sum();
        if (!(roots > 0)) {
            return 0;
        }
        double mean = roots / variance.length;
        return halves.stream()
                        .mapToDouble(h -> h.variance / (EVEN + (1 - EVEN) * h.root / mean))
                        .sum()
                / variance.length;
    }

    private static List<Half> halves(double[] variance, List<RenderSettings.Crop> blocks) {
        List<Half> halves = new ArrayList<>();
        int first = 0;
        for (RenderSettings.Crop block : blocks) {
            for (int top = 0; top < block.height(); top += CELL) {
                for (int left = 0; left < block.width(); left += CELL) {
                    addCell(variance, first, block, left, top, halves);
                }
            }
            first += block.width() * block.height();
        }
        return halves;
    }

    private static void addCell(
            double[] variance, int first, RenderSettings.Crop block, int left, int top, List<Half> halves) {
        double[] sums = new double[2];
        int[] counts = new int[2];
        for (int y = top; y < Math.min(top + CELL, block.height()); y++) {
            for (int x = left; x < Math.min(left + CELL, block.width()); x++) {
                int color = (x ^ y) & 1;
                sums[color] += variance[first + block.width() * y + x];
                counts[color]++;
            }
        }
        halves.add(new Half(sums, counts, 0));
        halves.add(new Half(sums, counts, 1));
    }
}
