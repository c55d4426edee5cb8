package enlightenment.measure.trade;

import enlightenment.image.Image;
import java.util.List;
import java.util.NoSuchElementException;
import java.util.Optional;

/**
 * The image that errors are measured against, and its own error.
 *
 * @param picture the image; empty if only the figures measured with it were kept
 * @param variance the image's own mean squared error, estimated from independent renders; square of display units, at least 0
 * @param parts the independent renders whose mean is the image; empty if the user gave it
 */
public record Reference(Optional<Image> picture, double variance, List<Part> parts) {
    public Reference {
        parts = List.copyOf(parts);
    }

    /**
     * One of the independent renders whose mean is the reference.
     *
     * @param method the word of the method
     * @param lightSamples light samples per hit and light; 0 with physical shading
     * @param samples the budget of camera rays per pixel
     * @param seed the seed of the random numbers, which no measured run uses
     */
    public record Part(String method, int lightSamples, double samples, long seed) {}

    /**
     * The image.
     *
     * @throws NoSuchElementException if the image was not kept
     */
    public Image image() {
        return picture.orElseThrow();
    }

    /** The image's own root mean square error, in display units. */
    public double error() {
        return Math.sqrt(variance);
    }
}
