package enlightenment.plan;

import java.util.ArrayList;
import java.util.List;

/**
 * What allocation makes of the variance of blocks: methods that survey the picture take the more samples of a pixel the more the paths of its
 * neighbours vary, beside the half that all pixels have. As there, the variance of pixels of one chessboard colour allocates the samples of the
 * other, so that rare bright paths gain nothing by having been seen.
 */
final class PilotAllocation {
    /** The share of samples that are the same for all pixels. */
    private static final double EVEN = 0.5;

    private PilotAllocation() {}

    /** Pixels of one colour in a cell, by the sum of their variances, and the root of the mean variance of the others. */
    private record Half(int pixels, double variance, double root) {
        static Half of(double[] variance, int[] mine, int[] others) {
            double root = others.length == 0 ? 0 : Math.sqrt(sum(variance, others) / others.length);
            return new Half(mine.length, sum(variance, mine), root);
        }

        private static double sum(double[] of, int[] pixels) {
            double sum = 0;
            for (int pixel : pixels) {
                sum += of[pixel];
            }
            return sum;
        }
    }

    /**
     * The mean variance of pixels after allocation of as many samples.
     *
     * @param variance of one sample of each pixel
     * @param cells whose pixels allocate samples to each other, all of the picture
     */
    static double mean(double[] variance, List<PilotCell> cells) {
        List<Half> halves = new ArrayList<>();
        for (PilotCell cell : cells) {
            halves.add(Half.of(variance, cell.even(), cell.odd()));
            halves.add(Half.of(variance, cell.odd(), cell.even()));
        }
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
}
