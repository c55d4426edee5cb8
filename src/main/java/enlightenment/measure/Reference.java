package enlightenment.measure;

import enlightenment.image.Image;
import java.util.List;
import java.util.NoSuchElementException;
import java.util.Optional;

/**
 * What is taken for the truth.
 *
 * @param picture the picture; nothing where only what was measured with it is left
 * @param variance its own mean squared error, measured: display units squared
 * @param parts what it is the mean of; empty where it was given
 */
public record Reference(Optional<Image> picture, double variance, List<Part> parts) {
    public Reference {
        parts = List.copyOf(parts);
    }

    /**
     * One of the independent renders that a reference is the mean of.
     *
     * @param method the method
     * @param lightPoints light points per hit and light
     * @param samples its budget of camera rays per pixel
     * @param seed what its random numbers came from
     */
    public record Part(String method, int lightPoints, double samples, long seed) {}

    /**
     * The picture.
     *
     * @throws NoSuchElementException if it was not kept
     */
    public Image image() {
        return picture.orElseThrow();
    }

    /** Its own root mean square error. */
    public double error() {
        return Math.sqrt(variance);
    }

    /**
     * The mean of independent renders. The mean squared difference of two of them is the sum of their variances, so the
     * differences of all pairs tell the variance of the mean without anything being assumed about the methods: with n
     * renders, the sum over all pairs divided by n²(n − 1).
     *
     * @param images at least two, of one size
     */
    static Reference meanOf(List<Image> images, List<Part> parts) {
        int n = images.size();
        int width = images.get(0).width();
        int height = images.get(0).height();
        float[] mean = new float[3 * width * height];
        double squares = 0;
        int i = 0;
        for (int y = 0; y < height; y++) {
            for (int x = 0; x < width; x++) {
                for (int c = 0; c < 3; c++) {
                    double sum = 0;
                    for (int a = 0; a < n; a++) {
                        double value = images.get(a).component(x, y, c);
                        sum += value;
                        for (int b = 0; b < a; b++) {
                            double d = value - images.get(b).component(x, y, c);
                            squares += d * d;
                        }
                    }
                    mean[i++] = (float) (sum / n);
                }
            }
        }
        double variance = squares / mean.length / ((double) n * n * (n - 1));
        return new Reference(Optional.of(new Image(width, height, mean)), variance, parts);
    }

    /**
     * A picture that somebody gave. Two renders that are independent of it and of each other have nothing in common but its
     * error: the mean product of their differences from it is its variance, and whatever it is wrong by.
     */
    static Reference given(Image reference, Image a, Image b) {
        double sum = 0;
        for (int y = 0; y < reference.height(); y++) {
            for (int x = 0; x < reference.width(); x++) {
                for (int c = 0; c < 3; c++) {
                    double r = reference.component(x, y, c);
                    sum += (a.component(x, y, c) - r) * (b.component(x, y, c) - r);
                }
            }
        }
        double mean = sum / (3.0 * reference.width() * reference.height());
        return new Reference(Optional.of(reference), Math.max(mean, 0), List.of());
    }
}
