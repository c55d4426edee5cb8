package enlightenment.film;

/**
 * What pixels of one or two samples tell together about the variance of a single sample, where each by itself knows too little.
 *
 * <p>That variance is half the mean squared difference of two samples that lie anywhere in the same pixel, independently. Samples
 * of pixels side by side may lie as near to each other, only not as often: each pair is weighed by how much more often two
 * samples of one pixel would lie in that direction and distance from each other (importance sampling; all kinds of pairs together
 * by the balance heuristic of E. Veach and L. Guibas, "Optimally combining sampling techniques for Monte Carlo rendering",
 * 1995). This takes nothing for granted but that a picture does not know where its pixels have their borders; noise counts in
 * full, a step of the picture between two pixels only as far as it would within one.
 *
 * <p>Only pixels of the same cell of 8 × 8 are compared, cut from the whole picture's corner: so a pixel has the same figures in
 * a trial, in a tile of any size and on a worker of a network.
 */
final class Neighbours {
    /** Binary logarithm of a cell's side. */
    private static final int CELL = 3;

    private static final int MOST = 2;

    /** The pixels right of a pixel, below it, and below it to the left and to the right: each pair is met once. */
    private static final int[] STEP_X = {1, 0, -1, 1};

    private static final int[] STEP_Y = {0, 1, 1, 1};

    private final FilmTile tile;

    /** Per pixel: its share of the sum of the variances of single samples of its cell's pixels with as many samples. */
    private final float[] single;

    /** Of the cell and number of samples in hand: pairs of pixels side by side, one above the other, and by their corners. */
    private final int[] pairs = new int[3];

    private int pixels;
    private int samples;
    private double weights;

    /** Of the tile as it is now. */
    Neighbours(FilmTile tile) {
        this.tile = tile;
        single = new float[tile.width * tile.height];
        int side = 1 << CELL;
        for (int y = tile.y >> CELL << CELL; y < tile.y + tile.height; y += side) {
            for (int x = tile.x >> CELL << CELL; x < tile.x + tile.width; x += side) {
                for (int count = 1; count <= MOST; count++) {
                    compare(x, y, count);
                }
            }
        }
    }

    /** The variance of a single sample of the pixel, as far as it may be told; only sums over many pixels mean something. */
    float single(int column, int row) {
        return single[index(column, row)];
    }

    private void compare(int cellX, int cellY, int count) {
        int left = Math.max(cellX, tile.x);
        int top = Math.max(cellY, tile.y);
        int right = Math.min(cellX + (1 << CELL), tile.x + tile.width);
        int bottom = Math.min(cellY + (1 << CELL), tile.y + tile.height);
        samples = count;
        countPairs(left, top, right, bottom);
        if (pixels == 0) {
            return;
        }
        weights = 0;
        for (int y = top; y < bottom; y++) {
            for (int x = left; x < right; x++) {
                if (tile.count(x, y) == count) {
                    addPairs(x, y, left, right, bottom);
                }
            }
        }
        for (int y = top; y < bottom; y++) {
            for (int x = left; x < right; x++) {
                if (tile.count(x, y) == count) {
                    int k = index(x, y);
                    // A pixel on its own: where there is a known part, the distance from it is all there is to compare
                    // with.
                    single[k] = (float) (weights > 0 ? single[k] * (pixels / weights) : count * tile.squaredMean(k));
                }
            }
        }
    }

    private void countPairs(int left, int top, int right, int bottom) {
        pixels = 0;
        pairs[0] = 0;
        pairs[1] = 0;
        pairs[2] = 0;
        for (int y = top; y < bottom; y++) {
            for (int x = left; x < right; x++) {
                if (tile.count(x, y) == samples) {
                    pixels++;
                    for (int k = 0; k < STEP_X.length; k++) {
                        pairs[Math.min(k, 2)] += isAlike(x + STEP_X[k], y + STEP_Y[k], left, right, bottom) ? 1 : 0;
                    }
                }
            }
        }
    }

    private boolean isAlike(int x, int y, int left, int right, int bottom) {
        return x >= left && x < right && y < bottom && tile.count(x, y) == samples;
    }

    private void addPairs(int x, int y, int left, int right, int bottom) {
        int pixel = index(x, y);
        if (samples == MOST) {
            add(pixel, 0, pixel, 1, 0, 0);
        }
        for (int k = 0; k < STEP_X.length; k++) {
            if (isAlike(x + STEP_X[k], y + STEP_Y[k], left, right, bottom)) {
                int other = index(x + STEP_X[k], y + STEP_Y[k]);
                for (int s = 0; s < samples * samples; s++) {
                    add(pixel, s % samples, other, s / samples, STEP_X[k], STEP_Y[k]);
                }
            }
        }
    }

    /** Adds the pair of the sample of a pixel and that of another, or the same, so many columns and rows farther. */
    private void add(int pixel, int sample, int other, int otherSample, int columns, int rows) {
        double a = Math.abs(columns + tile.sample(other, otherSample, 0) - tile.sample(pixel, sample, 0));
        double b = Math.abs(rows + tile.sample(other, otherSample, 1) - tile.sample(pixel, sample, 1));
        // Farther from each other than two points of one pixel can be?
        if (!(a < 1 && b < 1)) {
            return;
        }
        double weight = weight(a, b);
        double sum = 0;
        for (int c = 2; c < 5; c++) {
            double d = tile.sample(other, otherSample, c) - tile.sample(pixel, sample, c);
            sum += d * d;
        }
        // Half the square, mean of three components, and half of it for either pixel.
        float share = (float) (weight * sum / 12);
        single[pixel] += share;
        single[other] += share;
        weights += weight;
    }

    /**
     * The density of the distances (a, b) between two independent points of a pixel over that of all pairs at hand. Between points
     * of neighbouring columns a has the density a, in the same column 2 (1 − a); the two points of one pixel, of which each half
     * has one, 4 min(a, 1 − a).
     */
    private double weight(double a, double b) {
        double p = 1 - a;
        double q = 1 - b;
        double density = samples * samples * (2 * (pairs[0] * a * q + pairs[1] * p * b) + pairs[2] * a * b);
        if (samples == MOST) {
            density += 16.0 * pixels * Math.min(a, p) * Math.min(b, q);
        }
        return density > 0 ? 4 * p * q / density : 0;
    }

    private int index(int column, int row) {
        return (row - tile.y) * tile.width + column - tile.x;
    }
}
