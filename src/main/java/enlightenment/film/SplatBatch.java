package enlightenment.film;

/**
 * Where a {@code SplatIntegrator} puts what a batch of paths contributes to the picture. Each contribution is rounded to whole units
 * ({@link SplatScale}) before it is added: so all sums are exact, and the same for batches of any size. One per thread, to be used again
 * and again.
 */
public final class SplatBatch {
    private final int left;
    private final int top;
    private final int width;
    private final int height;
    private final SplatLog log;

    /** Two powers of two, whose product is the number of units per contribution of 1; one alone may be beyond the range of doubles. */
    private final double first;

    private final double second;

    private long paths;

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
        log = new SplatLog(Math.multiplyExact(width, height));
        first = scale.first();
        second = scale.second();
        begin(0);
    }

    /**
     * Starts over.
     *
     * @param paths how many there will be, those too that reach no pixel
     */
    public void begin(long paths) {
        this.paths = paths;
        log.clear();
    }

    /**
     * Adds what a path contributes at a point of the picture: the integrand over the density of arriving there. That density is per area of
     * the whole picture: 1 where all its points are equally likely. So the value of a pixel is the mean over all paths of what each
     * contributes to it, times the number of pixels of the whole picture. A band may be negative: light of a single wavelength has more
     * colour than any screen.
     *
     * @param x columns from the left of the whole picture, with fractions; outside of the rectangle that is rendered it is dropped
     * @param y rows from above
     * @throws ArithmeticException for a contribution that is infinite or NaN, and a place that is NaN: faults of the caller
     */
    public void add(double x, double y, double r, double g, double b) {
        if (!(isFinite(r) && isFinite(g) && isFinite(b)) || Double.isNaN(x) || Double.isNaN(y)) {
            throw new ArithmeticException("a path contributes " + r + "," + g + "," + b + " at " + x + "," + y);
        }
        // Exact, since the differences that matter are not greater than x and y themselves.
        double column = x - left;
        double row = y - top;
        if (covers(x, y)) {
            log.add((int) row * width + (int) column, units(r), units(g), units(b));
        }
    }

    /** Whether a place, as {@link #add} wants it, lies in the rectangle that is rendered. */
    public boolean covers(double x, double y) {
        double column = x - left;
        double row = y - top;
        return column >= 0 && column < width && row >= 0 && row < height;
    }

    private static boolean isFinite(double contribution) {
        return Math.abs(contribution) < Double.POSITIVE_INFINITY;
    }

    /** Whole units, to the nearest; what is beyond the range of a {@code long} is its end on that side. */
    private long units(double contribution) {
        return (long) Math.rint(contribution * first * second);
    }

    /**
     * The sums since the batch began, in the form that is stored and sent.
     *
     * @throws ArithmeticException if a pixel's sum was too large, with the pixel
     */
    public SplatSums sums() {
        SplatSums sums = log.sums(paths);
        int pixel = log.overflow();
        if (pixel >= 0) {
            throw SplatScale.tooBright(left + pixel % width, top + pixel / width);
        }
        return sums;
    }
}
