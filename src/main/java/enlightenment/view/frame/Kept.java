package enlightenment.view.frame;

import enlightenment.image.Image;
import java.util.OptionalDouble;

/**
 * A kept picture that later ones are compared with.
 *
 * @param number number of pictures kept so far, this one included
 * @param image the picture as it was shown, with the exposure at that time
 * @param samples samples per pixel
 * @param shrink side in pixels of the block that each pixel of the image stands for; 1 at full resolution
 * @param rmse estimated root mean square error in displayed units; empty if unknown
 */
public record Kept(long number, Image image, int samples, int shrink, OptionalDouble rmse) {

    /** @param shown the image of the frame, with the exposure of the view */
    public static Kept of(long number, Frame frame, Image shown) {
        OptionalDouble rmse = frame.detail()
                .noise()
                .map(n -> OptionalDouble.of(n.rmse(shown.curve())))
                .orElse(OptionalDouble.empty());
        return new Kept(number, shown, frame.samples(), frame.shrink(), rmse);
    }

    /** Whether a picture has the same size, so that the difference exists. */
    public boolean isComparable(Image now) {
        return now.width() == image.width() && now.height() == image.height();
    }

    /**
     * The difference of a picture from this one: root mean square over the components of each pixel, in displayed units.
     *
     * @param now a picture of the same size
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
