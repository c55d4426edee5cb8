package enlightenment.measure.analysis;

import enlightenment.image.Image;
import java.util.Random;

/** Images with a known error. */
public final class SyntheticImages {
    private SyntheticImages() {}

    /** A gradient from a quarter to three quarters of white. */
    public static Image gradient(int width, int height) {
        float[] rgb = new float[3 * width * height];
        for (int i = 0; i < rgb.length; i++) {
            rgb[i] = 0.25f + 0.5f * i / rgb.length;
        }
        return new Image(width, height, rgb);
    }

    /** Every component is the mean of n samples about the truth, with this deviation. */
    public static Image meanOfSamples(Image truth, int n, double deviation, Random random) {
        float[] rgb = truth.toArray();
        for (int i = 0; i < rgb.length; i++) {
            double sum = 0;
            for (int k = 0; k < n; k++) {
                sum += deviation * random.nextGaussian();
            }
            rgb[i] += (float) (sum / n);
        }
        return new Image(truth.width(), truth.height(), rgb);
    }
}
