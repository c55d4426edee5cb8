package enlightenment.plan;

import java.util.Arrays;
import java.util.Collection;
import java.util.List;
import java.util.function.Function;

/** Means and variances over pictures of the same pixels with different seeds. All arrays have three bands of each pixel. */
final class PilotSpread {
    private PilotSpread() {}

    /** The mean of several pictures. */
    static double[] mean(Collection<PilotPicture> pictures) {
        double[] mean = new double[3 * pixels(pictures)];
        for (PilotPicture picture : pictures) {
            double[] light = picture.light();
            Arrays.setAll(mean, i -> mean[i] + light[i] / pictures.size());
        }
        return mean;
    }

    private static int pixels(Collection<PilotPicture> pictures) {
        return pictures.iterator().next().tiles().length / 3;
    }

    /**
     * The variance of one of these pictures in each pixel and band, from the differences between them.
     *
     * @param part which light of a picture; empty for none
     */
    static double[] variance(List<PilotPicture> pictures, Function<PilotPicture, double[]> part) {
        double[] variance = new double[3 * pixels(pictures)];
        double[] mean = new double[variance.length];
        for (PilotPicture picture : pictures) {
            double[] light = part.apply(picture);
            for (int i = 0; i < light.length; i++) {
                mean[i] += light[i] / pictures.size();
            }
        }
        for (PilotPicture picture : pictures) {
            double[] light = part.apply(picture);
            for (int i = 0; i < light.length; i++) {
                double d = light[i] - mean[i];
                variance[i] += d * d / (pictures.size() - 1);
            }
        }
        return variance;
    }

    /** The mean of relative variances over pixels and bands; black pixels count as exact. */
    static double relative(double[] variance, double[] scale) {
        double sum = 0;
        for (int i = 0; i < variance.length; i++) {
            sum += ratio(variance[i], scale[i]);
        }
        return sum / variance.length;
    }

    /** The mean of relative variances over the bands of each pixel. */
    static double[] ofPixels(double[] variance, double[] scale) {
        double[] all = new double[variance.length / 3];
        for (int i = 0; i < variance.length; i++) {
            all[i / 3] += ratio(variance[i], scale[i]) / 3;
        }
        return all;
    }

    /** The standard error of {@link #relative}, as the differences between pixels tell it. */
    static double uncertainty(double[] variance, double[] scale) {
        double mean = relative(variance, scale);
        double[] of = ofPixels(variance, scale);
        int pixels = of.length;
        double sum = 0;
        for (int p = 0; p < pixels; p++) {
            sum += (of[p] - mean) * (of[p] - mean);
        }
        return Math.sqrt(sum) / pixels;
    }

    static double ratio(double variance, double scale) {
        return scale > 0 ? variance / scale : 0;
    }
}
