package enlightenment.image;

import enlightenment.color.Color;
import enlightenment.numeric.CompensatedSum;

/**
 * By how much one picture differs from another: root mean square error and other figures. The components are taken as they are stored:
 * display-referred pictures are compared in display units (0 is black, 1 is white), those of linear light in linear units, and one is not compared
 * with the other. Components outside 0..1 count as they are. Means run over all components of all pixels, row by row, with compensated sums: the
 * same images give the same bits on every machine.
 *
 * @param meanSquaredError mean of (a − b)²
 * @param relativeMeanSquaredError mean of (a − b)² / (b² + {@link #RELATIVE_EPSILON}), b being the reference: an error in
 *     the dark counts more than the same error in the light (F. Rousselle, C. Knaus, M. Zwicker, "Adaptive sampling and
 *     reconstruction using greedy error minimization", 2011)
 * @param meanAbsoluteError mean of |a − b|
 * @param largest the component that differs most
 *
 */
public record ImageError(
        double meanSquaredError, double relativeMeanSquaredError, double meanAbsoluteError, Largest largest) {
    /** What keeps the relative error finite where the reference is black: the customary hundredth. */
    public static final double RELATIVE_EPSILON = 0.01;

    /**
     * The component that differs most: the first of them from the upper left, row by row.
     *
     * @param difference |a − b|; 0 where the images are equal
     * @param column counted from 0 at the left
     * @param row counted from 0 at the top
     * @param channel 0 red, 1 green, 2 blue
     */
    public record Largest(double difference, int column, int row, int channel) {
        /** The channel in words. */
        public String channelName() {
            return ImagePair.channel(channel);
        }
    }

    /**
     * Fails unless two pictures can be compared: both have one size, one encoding and finite components.
     *
     * @throws enlightenment.math.InvalidValueException if the sizes or encodings differ (key "size" or "encoding"), or a component is infinite
     *     or not a number (key "test" or "reference", the message tells where)
     */
    public static void requireComparable(Image test, Image reference) {
        ImagePair.check(test, reference);
    }

    /**
     * Compares two images. Only the relative error depends on which of them is the reference.
     *
     * @throws enlightenment.math.InvalidValueException if the sizes differ (key "size", the message has both), if one holds
     *     linear light and the other does not (key "encoding") or if a
     *     component is infinite or not a number (key "test" or "reference", the message tells where)
     */
    public static ImageError between(Image test, Image reference) {
        ImagePair.check(test, reference);
        CompensatedSum squares = new CompensatedSum();
        CompensatedSum relative = new CompensatedSum();
        CompensatedSum absolute = new CompensatedSum();
        Largest largest = new Largest(0, 0, 0, 0);
        for (int y = 0; y < test.height(); y++) {
            for (int x = 0; x < test.width(); x++) {
                for (int c = 0; c < 3; c++) {
                    double b = reference.component(x, y, c);
                    double difference = Math.abs(test.component(x, y, c) - b);
                    double square = difference * difference;
                    squares.add(square);
                    relative.add(square / (b * b + RELATIVE_EPSILON));
                    absolute.add(difference);
                    if (difference > largest.difference()) {
                        largest = new Largest(difference, x, y, c);
                    }
                }
            }
        }
        double count = 3.0 * test.width() * test.height();
        return new ImageError(squares.value() / count, relative.value() / count, absolute.value() / count, largest);
    }

    /** Root of the mean squared error. */
    public double rmse() {
        return Math.sqrt(meanSquaredError);
    }

    /**
     * Peak signal-to-noise ratio in decibels, −10 log₁₀ of the mean squared error for a peak of 1; positive infinity for
     * equal images.
     */
    public double psnr() {
        return meanSquaredError == 0 ? Double.POSITIVE_INFINITY : -10 * StrictMath.log10(meanSquaredError);
    }

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
    public record OfLight(double rmse, double relative, double red, double green, double blue) {
        /** What keeps relative errors finite in the dark, as a share of the mean. */
        private static final double FLOOR = 0.05;

        /**
         * Compares two pictures.
         *
         * @throws enlightenment.math.InvalidValueException if the sizes differ (key "size"), if a component is infinite or not a number
         *     (key "test" or "reference", the message tells where)
         * @throws IllegalArgumentException if they hold no linear light
         */
        public static OfLight between(Image test, Image reference) {
            ImagePair.check(test, reference);
            if (test.encoding() != Color.Encoding.LINEAR) {
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
            return new OfLight(
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
}
