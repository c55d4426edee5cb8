package enlightenment.picture;

import enlightenment.image.Image;

/** How bright pictures of linear light are, and how bright they should be shown. */
public final class Exposure {
    /** What the middle of a picture is to become: photography's middle grey. */
    private static final double MIDDLE_GREY = 0.18;

    /** Keeps the logarithm of black finite, as a share of the mean. */
    private static final double FLOOR = 1e-4;

    private static final double[] LUMINANCE = {0.2126, 0.7152, 0.0722};

    private Exposure() {}

    /**
     * The exposure at which the geometric mean of the luminance Y becomes middle grey: the binary logarithm of 0.18/exp(mean log(Y + 1e-4
     * mean Y)), rounded to hundredths of a stop; after E. Reinhard, M. Stark, P. Shirley and J. Ferwerda, "Photographic tone
     * reproduction for digital images", 2002. Means are over the pixels that light comes from: black surroundings of a bright thing have
     * no say. Components that are not finite or negative count as black.
     *
     * @param image of linear light
     * @return 0 for a picture that is black
     */
    public static double automatic(Image image) {
        double sum = 0;
        long lit = 0;
        for (int y = 0; y < image.height(); y++) {
            double row = 0;
            for (int x = 0; x < image.width(); x++) {
                double luminance = luminance(image, x, y);
                row += luminance;
                lit += luminance > 0 ? 1 : 0;
            }
            sum += row;
        }
        if (lit == 0) {
            return 0;
        }
        double mean = sum / lit;
        double logs = 0;
        for (int y = 0; y < image.height(); y++) {
            double row = 0;
            for (int x = 0; x < image.width(); x++) {
                double luminance = luminance(image, x, y);
                row += luminance > 0 ? StrictMath.log(luminance + FLOOR * mean) : 0;
            }
            logs += row;
        }
        double stops = (StrictMath.log(MIDDLE_GREY) - logs / lit) / StrictMath.log(2);
        return Math.rint(100 * stops) / 100;
    }

    private static double luminance(Image image, int x, int y) {
        double sum = 0;
        for (int c = 0; c < 3; c++) {
            float value = image.component(x, y, c);
            sum += value > 0 && value < Float.POSITIVE_INFINITY ? LUMINANCE[c] * value : 0;
        }
        return sum;
    }

    /** The mean of all components as a screen takes them, to 1e-6; those that are no numbers count as 0. */
    public static double meanDisplayed(Image image) {
        double sum = 0;
        for (int y = 0; y < image.height(); y++) {
            double row = 0;
            for (int x = 0; x < image.width(); x++) {
                for (int c = 0; c < 3; c++) {
                    double value = image.curve().nearly(image.component(x, y, c));
                    row += value > 0 ? value : 0;
                }
            }
            sum += row;
        }
        return sum / (3.0 * image.width() * image.height());
    }
}
