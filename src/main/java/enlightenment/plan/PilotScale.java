package enlightenment.plan;

import java.util.Arrays;
import java.util.Collection;
import java.util.List;
import java.util.stream.IntStream;

/**
 * What squares of errors are divided by in each pixel and band: m² + (0.05 M)², with the pixel's mean m and the picture's M. Where small
 * pictures are mostly noise, the square of a pixel's own mean is mostly their variance, and no method looks worse than another. So means are
 * shrunk, by the share of their variance in all differences: those of pixels towards the mean of their cell, those of cells towards the
 * picture's (W. James, C. Stein, Estimation with quadratic loss, 1961; with unequal variances as in B. Efron, C. Morris, Data analysis using
 * Stein's estimator and its generalizations, 1975).
 */
final class PilotScale {
    /** The share of the picture's mean below which pixels count as equally dark. */
    private static final double DARK = 0.05;

    /** Of each pixel and band, over the pictures of all methods. */
    private final double[] mean;

    /** Of that mean. */
    private final double[] variance;

    private PilotScale(Collection<List<PilotPicture>> methods) {
        mean = PilotSpread.mean(methods.stream().flatMap(List::stream).toList());
        variance = new double[mean.length];
        int pictures = methods.stream().mapToInt(List::size).sum();
        for (List<PilotPicture> mine : methods) {
            double[] ofOne = PilotSpread.variance(mine, PilotPicture::light);
            double factor = mine.size() / ((double) pictures * pictures);
            Arrays.setAll(variance, i -> variance[i] + ofOne[i] * factor);
        }
    }

    /**
     * The scale of pictures.
     *
     * @param methods the pictures of each
     * @param cells all of the picture
     * @return three bands of each pixel
     */
    static double[] of(Collection<List<PilotPicture>> methods, List<PilotCell> cells) {
        PilotScale of = new PilotScale(methods);
        double[] scale = new double[of.mean.length];
        for (int band = 0; band < 3; band++) {
            of.fill(band, cells, scale);
        }
        return scale;
    }

    private void fill(int band, List<PilotCell> cells, double[] scale) {
        List<int[]> entries = cells.stream().map(cell -> cell.entries(band)).toList();
        List<Means> pixels = entries.stream().map(of -> Means.of(this, of)).toList();
        Means ofCells = new Means(new double[cells.size()], new double[cells.size()]);
        for (int c = 0; c < entries.size(); c++) {
            ofCells.mean[c] = pixels.get(c).ofAll();
            ofCells.variance[c] = pixels.get(c).varianceOfAll();
        }
        double whole = 3
                * IntStream.range(0, mean.length / 3)
                        .mapToDouble(p -> mean[3 * p + band])
                        .sum()
                / mean.length;
        double dark = DARK * whole;
        double[] shrunk = ofCells.shrunk(whole);
        for (int c = 0; c < entries.size(); c++) {
            double[] m = pixels.get(c).shrunk(shrunk[c]);
            for (int k = 0; k < m.length; k++) {
                scale[entries.get(c)[k]] = m[k] * m[k] + dark * dark;
            }
        }
    }

    /** Estimates of several means, with the variances of these estimates. */
    private record Means(double[] mean, double[] variance) {
        static Means of(PilotScale scale, int[] entries) {
            return new Means(
                    IntStream.of(entries).mapToDouble(i -> scale.mean[i]).toArray(),
                    IntStream.of(entries).mapToDouble(i -> scale.variance[i]).toArray());
        }

        double ofAll() {
            return Arrays.stream(mean).sum() / mean.length;
        }

        /** The variance of {@link #ofAll}, as of independent estimates. */
        double varianceOfAll() {
            return Arrays.stream(variance).sum() / ((double) mean.length * mean.length);
        }

        /** The means, each the nearer to this one the larger its variance is beside the differences that no variance explains. */
        double[] shrunk(double towards) {
            double detail = detail();
            double[] shrunk = new double[mean.length];
            for (int k = 0; k < mean.length; k++) {
                double all = detail + variance[k];
                shrunk[k] = all > 0 ? towards + (mean[k] - towards) * (detail / all) : mean[k];
            }
            return shrunk;
        }

        /** The variance of the means themselves: that of the estimates, less what is noise. */
        private double detail() {
            double ofAll = ofAll();
            double sum = 0;
            for (int k = 0; k < mean.length; k++) {
                sum += (mean[k] - ofAll) * (mean[k] - ofAll) / Math.max(mean.length - 1, 1) - variance[k] / mean.length;
            }
            return Math.max(sum, 0);
        }
    }
}
