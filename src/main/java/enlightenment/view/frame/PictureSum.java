package enlightenment.view.frame;

import enlightenment.image.Image;
import java.util.Arrays;
import java.util.Optional;

/**
 * The weighted mean of independent pictures of one size, with an estimate of its variance. For use by one thread.
 *
 * <p>The variance of the mean is estimated from the spread of batches: Σ w (x − m)² / ((K − 1) W) for K batches x of weights w, whose sum is
 * W and whose mean is m. It is unbiased where variances are proportional to 1/w, and for any variances where there are two batches of one
 * weight. The variance of low-discrepancy samples falls faster than 1/w. A picture as heavy as all earlier ones therefore merges these into one
 * batch: then all batches weigh nearly the same, since passes grow by doubling only.
 */
public final class PictureSum {
    private double[] sums;
    private double weight;
    private Image mean;

    /** Σ w (x − m)² over the batches, for each component. */
    private float[] squares;

    private int batches;

    /**
     * Adds a picture.
     *
     * @param samples samples per pixel of the picture, its weight; greater than 0
     * @return the mean of all pictures so far, with the curve of this one
     */
    public Image add(Image image, int samples) {
        float[] rgb = image.toArray();
        if (sums == null) {
            sums = new double[rgb.length];
            squares = new float[rgb.length];
        }
        if (samples >= weight) {
            Arrays.fill(squares, 0);
            batches = Math.min(batches, 1);
        }
        double share = weight * samples / (weight + samples);
        double before = weight;
        weight += samples;
        for (int i = 0; i < rgb.length; i++) {
            if (before > 0) {
                double off = rgb[i] - sums[i] / before;
                squares[i] += (float) (share * off * off);
            }
            sums[i] += (double) rgb[i] * samples;
            rgb[i] = (float) (sums[i] / weight);
        }
        batches++;
        mean = new Image(image.width(), image.height(), rgb, image.curve());
        return mean;
    }

    /** The estimated noise of the current mean; empty with fewer than two batches. */
    public Optional<PictureNoise> noise() {
        if (batches < 2) {
            return Optional.empty();
        }
        double factor = 1 / ((batches - 1) * weight);
        float[] variances = new float[squares.length];
        for (int i = 0; i < variances.length; i++) {
            variances[i] = (float) (factor * squares[i]);
        }
        return Optional.of(new PictureNoise(mean, variances));
    }
}
