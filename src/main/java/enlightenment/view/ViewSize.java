package enlightenment.view;

/**
 * The size of a picture in pixels.
 *
 * @param width at least 1
 * @param height at least 1
 */
record ViewSize(int width, int height) {
    /** The longest side of a view, in pixels. */
    static final int MOST_SIDE = 4096;

    /** The most pixels of a view, about those of a large screen. */
    static final int MOST_PIXELS = 1 << 22;

    /** The largest size with the aspect ratio of a picture that fits into a box, within the limits. */
    static ViewSize fitting(int width, int height, int boxWidth, int boxHeight) {
        double scale = Math.min((double) limited(boxWidth) / width, (double) limited(boxHeight) / height);
        double most = Math.sqrt((double) MOST_PIXELS / ((double) width * height));
        double factor = Math.min(scale, most);
        return new ViewSize(side(width * factor), side(height * factor));
    }

    private static int limited(int side) {
        return Math.min(Math.max(side, 1), MOST_SIDE);
    }

    private static int side(double v) {
        return Math.max((int) v, 1);
    }

    double aspect() {
        return (double) width / height;
    }

    long pixels() {
        return (long) width * height;
    }
}
