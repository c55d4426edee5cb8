package enlightenment.view.frame;

import enlightenment.image.Image;
import java.util.OptionalDouble;

/**
 * A picture that others are compared with.
 *
 * @param number counts those that were kept
 * @param image as it was shown, with the exposure of then
 * @param samples per pixel
 * @param shrink the side of the squares of pixels that each of its pixels stood for
 * @param rmse estimated root mean square error in displayed units; empty where it is not known
 */
public record Kept(long number, Image image, int samples, int shrink, OptionalDouble rmse) {

    /** @param shown the picture of the frame, as it is shown */
    public static Kept of(long number, Frame frame, Image shown) {
        OptionalDouble rmse = frame.detail()
                .noise()
                .map(n -> OptionalDouble.of(n.rmse(shown.curve())))
                .orElse(OptionalDouble.empty());
        return new Kept(number, shown, frame.samples(), frame.shrink(), rmse);
    }

    /** Whether a picture is as large. */
    public boolean isComparable(Image now) {
        return now.width() == image.width() && now.height() == image.height();
    }

    /**
     * By how much a picture differs from this one, in displayed units: of each pixel the root mean square over its components.
     *
     * @param now of the same size
     */
    public Image difference(Image now) {
        int width = now.width();
        int height = now.height();
        float[] rgb = new float[3 * width * height];
        for (int i = 0; i < width * height; i++) {
            double sum = 0;
            for (int c = 0; c < 3; c++) {
                double off = shown(now, i % width, i / width, c) - shown(image, i % width, i / width, c);
                sum += off * off;
            }
            float root = (float) Math.sqrt(sum / 3);
            rgb[3 * i] = root;
            rgb[3 * i + 1] = root;
            rgb[3 * i + 2] = root;
        }
        return new Image(width, height, rgb);
    }

    private static double shown(Image image, int x, int y, int c) {
        return image.curve().nearly(image.component(x, y, c));
    }
}
