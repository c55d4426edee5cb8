package enlightenment.film;

/**
 * Sums of the samples of a rectangle of pixels: compensated, so that a billion samples lose nothing (Neumaier, "Rounding
 * error analysis of some methods for summing finite sums", 1974).
 */
public final class FilmTile {
    private static final int PER_PIXEL = 6;

    public final int x;
    public final int y;
    public final int width;
    public final int height;

    /** Per pixel: sum and compensation of red, green, blue. */
    private final double[] sums;

    private final long[] counts;

    /**
     * @param x first column in the whole picture
     * @param y first row in the whole picture
     * @param width number of columns
     * @param height number of rows
     */
    public FilmTile(int x, int y, int width, int height) {
        this.x = x;
        this.y = y;
        this.width = width;
        this.height = height;
        sums = new double[PER_PIXEL * width * height];
        counts = new long[width * height];
    }

    /** Adds a sample to the pixel in column and row of the whole picture. */
    public void add(int column, int row, double r, double g, double b) {
        int pixel = (row - y) * width + column - x;
        int k = PER_PIXEL * pixel;
        accumulate(k, r);
        accumulate(k + 2, g);
        accumulate(k + 4, b);
        counts[pixel]++;
    }

    private void accumulate(int k, double v) {
        double sum = sums[k];
        double t = sum + v;
        sums[k + 1] += Math.abs(sum) >= Math.abs(v) ? (sum - t) + v : (v - t) + sum;
        sums[k] = t;
    }

    /** The mean of component 0, 1 or 2 of a pixel; 0 where there are no samples. */
    public double mean(int column, int row, int component) {
        int pixel = (row - y) * width + column - x;
        int k = PER_PIXEL * pixel + 2 * component;
        return counts[pixel] == 0 ? 0 : (sums[k] + sums[k + 1]) / counts[pixel];
    }

    /** The number of samples of a pixel. */
    public long count(int column, int row) {
        return counts[(row - y) * width + column - x];
    }
}
