package enlightenment.view.frame;

import enlightenment.image.Image;
import java.util.List;

/**
 * Passes over a picture in four shares, each pass in the share with the fewest samples so far: the differences of the shares tell the noise
 * of the picture. For use by one thread.
 */
final class PassQuarters {
    private static final int QUARTERS = 4;

    /** The mean of each share; null before its first pass. */
    private final Image[] means = new Image[QUARTERS];

    private final int[] samples = new int[QUARTERS];

    /**
     * Adds a pass.
     *
     * @param count samples per pixel of the pass
     */
    void add(Image pass, int count) {
        int least = 0;
        for (int k = 1; k < QUARTERS; k++) {
            least = samples[k] < samples[least] ? k : least;
        }
        means[least] = samples[least] == 0 ? pass : mean(means[least], samples[least], pass, count);
        samples[least] += count;
    }

    private static Image mean(Image before, int samples, Image pass, int count) {
        float[] sum = pass.toArray();
        float[] old = before.toArray();
        double all = samples + count;
        for (int i = 0; i < sum.length; i++) {
            sum[i] = (float) ((old[i] * samples + (double) sum[i] * count) / all);
        }
        return new Image(pass.width(), pass.height(), sum, pass.curve());
    }

    /** The means of the shares; shares are equal where there are fewer than four passes. Empty for fewer than two. */
    List<Image> means() {
        if (means[1] == null) {
            return List.of();
        }
        if (means[2] == null) {
            return List.of(means[0], means[0], means[1], means[1]);
        }
        return List.of(means[0], means[1], means[2], means[QUARTERS - 1] == null ? means[2] : means[QUARTERS - 1]);
    }
}
