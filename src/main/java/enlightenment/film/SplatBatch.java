package enlightenment.film;

import java.util.Arrays;

/** Where a {@code SplatIntegrator} puts what a batch of paths contributes. One per thread; to be used again and again. */
public final class SplatBatch {
    private final int left;
    private final int top;
    private final int width;
    private final int height;
    private final SplatScale scale;

    /** Units of red, green and blue of each pixel. */
    private final long[] sums;

    /** A bit for each pixel that was reached. */
    private final long[] reached;

    private long paths;

    /** Whether a sum was too large, and of which pixel. */
    private boolean overflowed;

    private int overflowedPixel;

    /**
     * A batch for a rectangle of the whole picture.
     *
     * @param x its first column in the whole picture
     * @param y its first row
     * @param width number of columns
     * @param height number of rows
     */
    public SplatBatch(int x, int y, int width, int height, SplatScale scale) {
        left = x;
        top = y;
        this.width = width;
        this.height = height;
        this.scale = scale;
        int pixels = Math.multiplyExact(width, height);
        sums = new long[Math.multiplyExact(3, pixels)];
        reached = new long[(pixels + Long.SIZE - 1) / Long.SIZE];
    }

    /** Starts over, with this many paths. */
    public void begin(long paths) {
        this.paths = paths;
        overflowed = false;
        for (int w = 0; w < reached.length; w++) {
            for (long bits = reached[w]; bits != 0; bits &= bits - 1) {
                int k = 3 * (Long.SIZE * w + Long.numberOfTrailingZeros(bits));
                Arrays.fill(sums, k, k + 3, 0);
            }
            reached[w] = 0;
        }
    }

    /**
     * Adds what a path contributes to a point of the picture: the integrand over the density of arriving there, that per area of the whole
     * picture's (1 where all points are equally likely). The mean over all paths of the contributions to a pixel, times the number of
     * the picture's pixels, is the pixel.
     *
     * @param x columns from the left of the whole picture, with fractions; outside of the rectangle it is dropped
     * @param y rows from above
     * @throws ArithmeticException for a contribution that is negative, infinite or NaN, and a place that is NaN: a fault of the caller
     */
    public void add(double x, double y, double r, double g, double b) {
        double column = x - left;
        double row = y - top;
        if (!(column >= 0 && column < width && row >= 0 && row < height)) {
            checkDropped(x, y);
            return;
        }
        int pixel = (int) row * width + (int) column;
        int k = 3 * pixel;
        sums[k] = sum(pixel, sums[k], r);
        sums[k + 1] = sum(pixel, sums[k + 1], g);
        sums[k + 2] = sum(pixel, sums[k + 2], b);
        reached[pixel >> 6] |= 1L << pixel;
    }

    private static void checkDropped(double x, double y) {
        if (Double.isNaN(x) || Double.isNaN(y)) {
            throw new ArithmeticException("a path reaches the picture at " + x + "," + y);
        }
    }

    private long sum(int pixel, long sum, double contribution) {
        if (!(contribution >= 0 && contribution < Double.POSITIVE_INFINITY)) {
            throw new ArithmeticException("a path contributes " + contribution + " to pixel " + place(pixel));
        }
        // Too large a number becomes the largest; then the sum, if not 0 before, is negative.
        long units = (long) scale.units(contribution);
        long next = sum + units;
        if (next < 0 || units == Long.MAX_VALUE) {
            overflowed = true;
            overflowedPixel = pixel;
            return Long.MAX_VALUE;
        }
        return next;
    }

    private String place(int pixel) {
        return (left + pixel % width) + "," + (top + pixel / width);
    }

    /**
     * What was added, as it is kept and sent.
     *
     * @throws ArithmeticException if a pixel's sum was too large, with the pixel
     */
    public SplatSums sums() {
        if (overflowed) {
            throw new ArithmeticException("pixel " + place(overflowedPixel)
                    + " is more than 2^24 times as bright as the picture was expected to be in the mean");
        }
        int n = 0;
        for (int w = 0; w < reached.length; w++) {
            n += Long.bitCount(reached[w]);
        }
        int[] pixels = new int[n];
        long[] values = new long[3 * n];
        int i = 0;
        for (int w = 0; w < reached.length; w++) {
            for (long bits = reached[w]; bits != 0; bits &= bits - 1) {
                int pixel = Long.SIZE * w + Long.numberOfTrailingZeros(bits);
                if ((sums[3 * pixel] | sums[3 * pixel + 1] | sums[3 * pixel + 2]) != 0) {
                    pixels[i] = pixel;
                    System.arraycopy(sums, 3 * pixel, values, 3 * i++, 3);
                }
            }
        }
        return new SplatSums(Arrays.copyOf(pixels, i), Arrays.copyOf(values, 3 * i), paths);
    }
}
