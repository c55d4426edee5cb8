package enlightenment.film;

import enlightenment.numeric.Scale;

/**
 * The unit in which contributions of paths are summed: 2<sup>−exponent</sup>. Sums of integers are the same in every order.
 *
 * <p>One for a whole render, chosen before its first path so that the mean pixel's sum is about 2<sup>32</sup> units. A contribution is
 * rounded to whole units, an error of at most 2<sup>−33</sup> of the mean pixel; and a pixel may become 2<sup>30</sup> times as bright
 * as the mean before its sum is too large for a {@code long}.
 *
 * @param exponent the binary logarithm of units per contribution of 1
 */
public record SplatScale(int exponent) {
    /** Binary logarithm of what the mean pixel's sum is expected to be. */
    private static final int MEAN = 32;

    /** The largest exponent: the least double, as the mean of a path for each of 2^63 pixels. */
    private static final int MOST = MEAN - Double.MIN_EXPONENT + 52 + 63;

    /** The smallest: the greatest double, as the mean of 2^63 paths to a pixel. */
    private static final int LEAST = MEAN - Double.MAX_EXPONENT - 63 - 1;

    /** Binary digits of a double behind the point: above them stands its exponent. */
    private static final int MANTISSA = 52;

    /** @throws IllegalArgumentException for an exponent that no render can have */
    public SplatScale {
        if (exponent < LEAST || exponent > MOST) {
            throw new IllegalArgumentException("exponent " + exponent);
        }
    }

    /**
     * The scale of a render.
     *
     * @param contribution what a path is expected to contribute in the mean; 0 where nothing shines
     * @param paths how many there will be, at least 1
     * @param pixels of the whole picture, at least 1
     * @throws IllegalArgumentException for a contribution that is negative, infinite or NaN, and for less than a path or pixel
     */
    public static SplatScale of(double contribution, long paths, long pixels) {
        if (!(contribution >= 0 && contribution < Double.POSITIVE_INFINITY) || paths < 1 || pixels < 1) {
            throw new IllegalArgumentException(
                    "contribution " + contribution + " of " + paths + " paths to " + pixels + " pixels");
        }
        if (contribution == 0) {
            return new SplatScale(0);
        }
        // Paths per pixel lie within the range of doubles, their product with the contribution may not.
        double perPixel = (double) paths / pixels;
        int pathsExponent = Scale.exponent(perPixel);
        int ownExponent = Scale.exponent(contribution);
        double product = Scale.scalb(perPixel, -pathsExponent) * Scale.scalb(contribution, -ownExponent);
        return new SplatScale(MEAN - pathsExponent - ownExponent - Scale.exponent(product));
    }

    /** The value of this many units: times 2<sup>−exponent</sup>, rounded once. */
    double value(double units) {
        int power = -exponent;
        return power >= Double.MIN_EXPONENT && power <= Double.MAX_EXPONENT
                ? units * Double.longBitsToDouble((long) (power - Double.MIN_EXPONENT + 1) << MANTISSA)
                : Math.scalb(units, power);
    }

    /** A power of two; times {@link #second} it is 2<sup>exponent</sup>. */
    double first() {
        return Math.scalb(1.0, exponent / 2);
    }

    /** See {@link #first}. */
    double second() {
        return Math.scalb(1.0, exponent - exponent / 2);
    }

    static ArithmeticException tooBright(int column, int row) {
        return new ArithmeticException("pixel " + column + "," + row
                + " is more than 2^30 times as bright as the mean of the picture was expected to be");
    }
}
