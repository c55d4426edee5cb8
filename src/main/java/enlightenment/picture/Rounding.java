package enlightenment.picture;

import enlightenment.codec.PngWriter;
import enlightenment.image.Image;

/**
 * What a file of whole numbers adds to a picture's error: its values are the nearest of 2^depth. Between two of them the error is
 * anything up to half a step, 1/√12 of a step in the root mean square; where a picture is of one colour it may be less or more.
 */
public final class Rounding {
    private Rounding() {}

    /** Root mean square of what rounding changes, 0..1 being the range of a component; 0 for depth 0, which rounds nothing. */
    public static double of(Image image, int depth) {
        if (depth == 0) {
            return 0;
        }
        double sum = 0;
        for (int y = 0; y < image.height(); y++) {
            double row = 0;
            for (int x = 0; x < image.width(); x++) {
                for (int c = 0; c < 3; c++) {
                    row += square(image.displayed(x, y, c), depth);
                }
            }
            sum += row;
        }
        return Math.sqrt(sum / (3.0 * image.width() * image.height()));
    }

    /**
     * The squared change of a component. What lies beyond 0..1 can be shown by no display, whatever the file: only from there on
     * it counts.
     */
    public static double square(float value, int depth) {
        if (depth == 0) {
            return 0;
        }
        int maximum = (1 << depth) - 1;
        double shown = value > 0 ? Math.min(value, 1) : 0;
        double change = PngWriter.quantize(value, maximum) / (double) maximum - shown;
        return change * change;
    }
}
