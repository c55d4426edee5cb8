package enlightenment.image;

import java.util.SplittableRandom;

/** Small pictures for tests. */
public final class TestImages {
    private TestImages() {}

    /** One colour everywhere. */
    public static Image uniform(int width, int height, double r, double g, double b) {
        float[] rgb = new float[3 * width * height];
        for (int i = 0; i < rgb.length; i += 3) {
            rgb[i] = (float) r;
            rgb[i + 1] = (float) g;
            rgb[i + 2] = (float) b;
        }
        return new Image(width, height, rgb);
    }

    /** Components spread evenly over 0..1, the same for the same seed. */
    public static Image noise(int width, int height, long seed) {
        SplittableRandom random = new SplittableRandom(seed);
        float[] rgb = new float[3 * width * height];
        for (int i = 0; i < rgb.length; i++) {
            rgb[i] = (float) random.nextDouble();
        }
        return new Image(width, height, rgb);
    }
}
