package enlightenment.plan;

import enlightenment.scene.RenderSettings;
import java.util.Arrays;
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

    private final double[] variance;
    private final List<RenderSettings.Crop> blocks;

    /** The sum of the roots of variances that allocate. */
    private double roots;

    private double allocated;

    private PilotAllocation(double[] variance, List<RenderSettings.Crop> blocks) {
        this.variance = variance;
        this.blocks = blocks;
    }

    /**
     * The mean variance of pixels after allocation of as many samples.
     *
     * @param variance of one sample of each pixel, block by block
     */
    static double mean(double[] variance, List<RenderSettings.Crop> blocks) {
        PilotAllocation allocation = new PilotAllocation(variance, blocks);
        allocation.forEachCell(
                (pixels, other) -> allocation.roots += pixels.length * Math.sqrt(allocation.meanOf(other)));
        if (!(allocation.roots > 0)) {
            return 0;
        }
        double mean = allocation.roots / variance.length;
        allocation.forEachCell((pixels, other) -> {
            double samples = EVEN + (1 - EVEN) * Math.sqrt(allocation.meanOf(other)) / mean;
            for (int p : pixels) {
                allocation.allocated += variance[p] / samples;
            }
        });
        return allocation.allocated / variance.length;
    }

    private double meanOf(int[] pixels) {
        double sum = 0;
        for (int p : pixels) {
            sum += variance[p];
        }
        return pixels.length == 0 ? 0 : sum / pixels.length;
    }

    /** Receives the pixels of one colour in a cell, and those of the other. */
    private interface Visitor {
        void accept(int[] pixels, int[] others);
    }

    private void forEachCell(Visitor visitor) {
        int first = 0;
        for (RenderSettings.Crop block : blocks) {
            for (int y = 0; y < block.height(); y += CELL) {
                for (int x = 0; x < block.width(); x += CELL) {
                    int[] black = pixels(block, first, x, y, 0);
                    int[] white = pixels(block, first, x, y, 1);
                    visitor.accept(black, white);
                    visitor.accept(white, black);
                }
            }
            first += block.width() * block.height();
        }
    }

    private static int[] pixels(RenderSettings.Crop block, int first, int left, int top, int color) {
        int[] some = new int[CELL * CELL];
        int count = 0;
        for (int y = top; y < Math.min(top + CELL, block.height()); y++) {
            for (int x = left; x < Math.min(left + CELL, block.width()); x++) {
                if (((x ^ y) & 1) == color) {
                    some[count++] = first + block.width() * y + x;
                }
            }
        }
        return Arrays.copyOf(some, count);
    }
}
