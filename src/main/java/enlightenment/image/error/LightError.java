package enlightenment.image.error;

import enlightenment.color.Encoding;
import enlightenment.image.Image;

/**
 * By how much one picture of linear light differs from another, in figures of light; those of what a screen shows are {@link ImageError}
 * of {@link Image#toDisplay}. Means run over all components of all pixels, row by row, with compensated sums.
 *
 * @param rmse root of the mean of (a − b)²
 * @param relative root of the mean of (a − b)²/(b² + (0.05 M)²), b being the reference and M the mean of its band; infinite where
 *     the reference's band is all black and the picture's is not
 * @param red mean of the picture's red over that of the reference; NaN where that is black
 * @param green the same of green
 * @param blue the same of blue
 */
public record LightError(double rmse, double relative, double red, double green, double blue) {
    /** What keeps relative errors finite in the dark, as a share of the mean. */
    private static final double FLOOR = 0.05;

    /**
     * Compares two pictures.
     *
     * @throws enlightenment.math.InvalidValueException if the sizes differ (key "size"), if a component is infinite or not a number
     *     (key "test" or "reference", the message tells where)
     * @throws IllegalArgumentException if they hold no linear light
     */
    public static LightError between(Image test, Image reference) {
        ImagePair.check(test, reference);
        if (test.encoding() != Encoding.LINEAR) {
            throw new IllegalArgumentException("display-referred pictures");
        }
        double[] own = means(test);
        double[] means = means(reference);
        CompensatedSum squares = new CompensatedSum();
        CompensatedSum relative = new CompensatedSum();
        boolean infinite = false;
        for (int y = 0; y < test.height(); y++) {
            for (int x = 0; x < test.width(); x++) {
                for (int c = 0; c < 3; c++) {
                    double b = reference.component(x, y, c);
                    double difference = test.component(x, y, c) - b;
                    double square = difference * difference;
                    double floor = FLOOR * means[c];
                    squares.add(square);
                    double size = b * b + floor * floor;
                    infinite |= square > 0 && size == 0;
                    relative.add(size == 0 ? 0 : square / size);
                }
            }
        }
        double count = 3.0 * test.width() * test.height();
        return new LightError(
                Math.sqrt(squares.value() / count),
                infinite ? Double.POSITIVE_INFINITY : Math.sqrt(relative.value() / count),
                ratio(own[0], means[0]),
                ratio(own[1], means[1]),
                ratio(own[2], means[2]));
    }

    private static double[] means(Image image) {
        double[] means = new double[3];
        for (int c = 0; c < 3; c++) {
            CompensatedSum sum = new CompensatedSum();
            for (int y = 0; y < image.height(); y++) {
                for (int x = 0; x < image.width(); x++) {
                    sum.add(image.component(x, y, c));
                }
            }
            means[c] = sum.value() / ((double) image.width() * image.height());
        }
        return means;
    }

    private static double ratio(double a, double b) {
        return b == 0 ? Double.NaN : a / b;
    }
}
