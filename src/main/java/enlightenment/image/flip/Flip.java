package enlightenment.image.flip;

import enlightenment.image.Image;
import enlightenment.image.ImageError;
import enlightenment.math.InvalidValueException;
import enlightenment.numeric.CompensatedSum;

/**
 * ꟻLIP: how different two images look to somebody who flips between them in one place. 0 is no difference, 1 the largest
 * that there is. Images are first filtered as the eye does at a distance, then their colours are compared, and differences at
 * edges and points count more.
 *
 * <p>Written after P. Andersson, J. Nilsson, T. Akenine-Möller, M. Oskarsson, K. Åström, M. D. Fairchild, "ꟻLIP: A Difference
 * Evaluator for Alternating Images", Proceedings of the ACM on Computer Graphics and Interactive Techniques 3 (2020), number
 * 2, article 15: the form for pictures of low dynamic range. The computation is in doubles and uses no function that differs
 * between machines; the same images give the same bits everywhere, in either order.
 *
 * <p>Immutable.
 */
public final class Flip {
    /** On a screen of 3840 pixels and 0.7 m of width, seen from 0.7 m: 3840·π/180, about 67.02. */
    public static final double DEFAULT_PIXELS_PER_DEGREE = 3840 * Math.PI / 180;

    /** Fewer pixels per degree than anybody sits away from. */
    public static final double MIN_PIXELS_PER_DEGREE = 1;

    /** Ten times what a good eye can tell apart. */
    public static final double MAX_PIXELS_PER_DEGREE = 1000;

    /** The exponents of colour and feature differences, and the two numbers of the map to 0..1 (section 4.1.3 and 4.2). */
    private static final double COLOR_EXPONENT = 0.7;

    private static final double LOWER_PART = 0.4;
    private static final double LOWER_PART_MAPPED = 0.95;

    /** What becomes 1: the difference of green and blue, the largest that a screen can show. */
    private static final double LARGEST_COLOR_DIFFERENCE = largestColorDifference();

    private final int width;
    private final int height;
    private final float[] error;
    private final double mean;

    private Flip(int width, int height, float[] error, double mean) {
        this.width = width;
        this.height = height;
        this.error = error;
        this.mean = mean;
    }

    /** Compares two images at {@link #DEFAULT_PIXELS_PER_DEGREE}; fails as {@link #between(Image, Image, double)} does. */
    public static Flip between(Image test, Image reference) {
        return between(test, reference, DEFAULT_PIXELS_PER_DEGREE);
    }

    /**
     * Compares two images {@linkplain Image#displayed as a screen takes them}; components outside 0..1 are clipped. Takes memory for some
     * rows and the result, and time in proportion to pixels times pixels per degree.
     *
     * @param pixelsPerDegree pixels of the picture that one degree of the viewer's field of view holds,
     *     {@link #MIN_PIXELS_PER_DEGREE}..{@link #MAX_PIXELS_PER_DEGREE}
     * @throws InvalidValueException if the sizes differ (key "size", the message has both), if one holds linear light and the
     *     other does not (key "encoding"), if a component is infinite or not a number (key "test" or "reference", the message tells where)
     *     or pixelsPerDegree is out of range
     */
    public static Flip between(Image test, Image reference, double pixelsPerDegree) {
        if (!(pixelsPerDegree >= MIN_PIXELS_PER_DEGREE && pixelsPerDegree <= MAX_PIXELS_PER_DEGREE)) {
            throw new InvalidValueException(
                    "pixelsPerDegree",
                    "must lie in " + MIN_PIXELS_PER_DEGREE + ".." + MAX_PIXELS_PER_DEGREE + ", not " + pixelsPerDegree);
        }
        ImageError.requireComparable(test, reference);
        FlipKernels kernels = new FlipKernels(pixelsPerDegree);
        FlipRows a = new FlipRows(test, kernels);
        FlipRows b = new FlipRows(reference, kernels);
        int width = test.width();
        int height = test.height();
        float[] error = new float[Math.multiplyExact(width, height)];
        CompensatedSum sum = new CompensatedSum();
        for (int y = 0; y < height; y++) {
            a.next();
            b.next();
            for (int x = 0; x < width; x++) {
                double color = colorDifference(
                        FlipColor.distance(a.lightness[x] - b.lightness[x], a.a[x] - b.a[x], a.b[x] - b.b[x]));
                double feature = Math.max(Math.abs(a.edge[x] - b.edge[x]), Math.abs(a.point[x] - b.point[x]));
                double value = combined(color, Math.sqrt(feature / Math.sqrt(2)));
                error[y * width + x] = (float) value;
                sum.add(value);
            }
        }
        return new Flip(width, height, error, sum.value() / error.length);
    }

    /** A difference of filtered colours as a number in 0..1. */
    private static double colorDifference(double distance) {
        double power = StrictMath.pow(distance, COLOR_EXPONENT);
        double border = LOWER_PART * LARGEST_COLOR_DIFFERENCE;
        return power < border
                ? LOWER_PART_MAPPED / border * power
                : LOWER_PART_MAPPED + (power - border) / (LARGEST_COLOR_DIFFERENCE - border) * (1 - LOWER_PART_MAPPED);
    }

    /** A difference of features raises the one of colours. */
    private static double combined(double color, double feature) {
        // Rounding can take both a hair beyond 1.
        return Math.min(1, StrictMath.pow(color, 1 - Math.min(1, feature)));
    }

    private static double largestColorDifference() {
        double[] green = new double[3];
        double[] blue = new double[3];
        FlipColor.huntLab(0, 1, 0, green);
        FlipColor.huntLab(0, 0, 1, blue);
        return StrictMath.pow(
                FlipColor.distance(green[0] - blue[0], green[1] - blue[1], green[2] - blue[2]), COLOR_EXPONENT);
    }

    /** The mean of the errors of all pixels, 0..1. */
    public double mean() {
        return mean;
    }

    /** The error of the pixel in column x from the left and row y from the top, 0..1. */
    public float error(int x, int y) {
        return error[y * width + x];
    }

    /** The largest error of any pixel, 0..1. */
    public float largest() {
        float largest = 0;
        for (float e : error) {
            largest = Math.max(largest, e);
        }
        return largest;
    }

    public int width() {
        return width;
    }

    public int height() {
        return height;
    }
}
