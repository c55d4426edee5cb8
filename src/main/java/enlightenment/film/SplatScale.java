package enlightenment.film;

/**
 * The unit in which contributions of paths are summed: 2<sup>−exponent</sup>. Sums of integers are the same in every order.
 *
 * <p>One for a whole render, chosen before its first path so that the mean pixel's sum is about 2<sup>38</sup> units. A contribution is
 * rounded to whole units, an error of at most 2<sup>−39</sup> of the mean pixel; and a pixel may become 2<sup>24</sup> times as bright
 * as the mean before its sum is too large for a {@code long}.
 *
 * @param exponent the binary logarithm of units per contribution of 1
 */
public record SplatScale(int exponent) {
    /** Binary logarithm of what the mean pixel's sum is expected to be. */
    private static final int MEAN = 38;

    /** The largest exponent: the least double, as the mean of a path for each of 2^62 pixels. */
    private static final int MOST = MEAN - Double.MIN_EXPONENT + 52 + 62;

    /** The smallest: the greatest double, as the mean of 2^62 paths to a pixel. */
    private static final int LEAST = MEAN - Double.MAX_EXPONENT - 62 - 1;

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
        int product = Math.getExponent(perPixel) + exponent(contribution);
        return new SplatScale(MEAN - product);
    }

    private static int exponent(double v) {
        return v < Double.MIN_NORMAL ? Math.getExponent(v * 0x1p54) - 54 : Math.getExponent(v);
    }

    /** The units of a contribution, rounded; 2<sup>63</sup> and more are beyond a {@code long}. */
    double units(double contribution) {
        return Math.rint(Math.scalb(contribution, exponent));
    }
}
