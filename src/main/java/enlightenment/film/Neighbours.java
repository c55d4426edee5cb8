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
    private static final int SIDE = FilmTile.BLOCK_SIDE;
    private static final int MOST = 2;

    /** The pixels right of a pixel, below it, and below it to the right and to the left: each pair is met once. */
    private static final int[] STEP_X = {1, 0, 1, -1};

    private static final int[] STEP_Y = {0, 1, 1, 1};

    private final FilmTile tile;

    /** Per pixel: its share of the sum of the variances of single samples of its cell's pixels with as many samples. */
    private final float[] single;

    /** The cell's samples, as {@link FilmTile#few} has them but with the column or row added to the place: first, then second ones. */
    private final float[] samples = new float[MOST * SIDE * SIDE * FilmTile.PER_SAMPLE];

    /** Per pixel of the cell: whether it belongs to those in hand, and its share. */
    private final boolean[] isIn = new boolean[SIDE * SIDE];

    private final double[] shares = new double[SIDE * SIDE];

    /** Of those in hand: pairs of pixels side by side, one above the other, and by their corners. */
    private int beside;

    private int below;
    private int across;
    private int pixels;
    private double weights;

    /** Figures of the tile as it is now. */
    Neighbours(FilmTile tile) {
        this.tile = tile;
        single = new float[tile.width * tile.height];
        for (int y = tile.y / SIDE * SIDE; y < tile.y + tile.height; y += SIDE) {
            for (int x = tile.x / SIDE * SIDE; x < tile.x + tile.width; x += SIDE) {
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

    private void compare(int left, int top, int count) {
        gather(left, top, count);
        if (pixels == 0) {
            return;
        }
        countPairs();
        weights = 0;
        for (int k = 0; k < isIn.length; k++) {
            if (isIn[k]) {
                addPairs(k, count);
            }
        }
        for (int k = 0; k < isIn.length; k++) {
            if (isIn[k]) {
                int i = index(left + k % SIDE, top + k / SIDE);
                // A pixel on its own: where there is a known part, the distance from it is all there is to compare
                // with.
                single[i] = (float) (weights > 0 ? shares[k] * (pixels / weights) : count * tile.squaredMean(i));
            }
        }
    }

    private void gather(int left, int top, int count) {
        pixels = 0;
        for (int k = 0; k < isIn.length; k++) {
            int column = k % SIDE;
            int row = k / SIDE;
            isIn[k] = tile.contains(left + column, top + row) && tile.count(left + column, top + row) == count;
            shares[k] = 0;
            if (isIn[k]) {
                pixels++;
                for (int s = 0; s < count; s++) {
                    int i = FilmTile.PER_SAMPLE * (s * SIDE * SIDE + k);
                    tile.few(index(left + column, top + row), s, samples, i);
                    samples[i] += column;
                    samples[i + 1] += row;
                }
            }
        }
    }

    private void countPairs() {
        if (pixels == isIn.length) {
            beside = SIDE * (SIDE - 1);
            below = beside;
            across = 2 * (SIDE - 1) * (SIDE - 1);
            return;
        }
        beside = 0;
        below = 0;
        across = 0;
        for (int k = 0; k < isIn.length; k++) {
            if (isIn[k]) {
                beside += other(k, 0) >= 0 ? 1 : 0;
                below += other(k, 1) >= 0 ? 1 : 0;
                across += (other(k, 2) >= 0 ? 1 : 0) + (other(k, 3) >= 0 ? 1 : 0);
            }
        }
    }

    /** The pixel in one of the four directions from a pixel, or a negative number if that is not one of those in hand. */
    private int other(int pixel, int direction) {
        int column = (pixel & SIDE - 1) + STEP_X[direction];
        int other = pixel + STEP_X[direction] + SIDE * STEP_Y[direction];
        return column >= 0 && column < SIDE && other < SIDE * SIDE && isIn[other] ? other : -1;
    }

    /** Of two samples each, one pair of each pair of pixels is enough: the two of one pixel are there as well. */
    private void addPairs(int pixel, int count) {
        int last = (count - 1) * SIDE * SIDE + pixel;
        if (count == MOST) {
            add(pixel, pixel, last, pixel, true);
        }
        for (int k = 0; k < STEP_X.length; k++) {
            int other = other(pixel, k);
            if (other >= 0) {
                add(pixel, other, last, other, count == MOST);
            }
        }
    }

    /** Adds the pair of two samples of two pixels, or of one. */
    private void add(int pixel, int other, int sample, int otherSample, boolean ofTwo) {
        int i = FilmTile.PER_SAMPLE * sample;
        int j = FilmTile.PER_SAMPLE * otherSample;
        double a = Math.abs(samples[i] - samples[j]);
        double b = Math.abs(samples[i + 1] - samples[j + 1]);
        // Farther from each other than two points of one pixel can be?
        if (!(a < 1 && b < 1)) {
            return;
        }
        double weight = weight(a, b, ofTwo);
        double red = samples[i + 2] - samples[j + 2];
        double green = samples[i + 3] - samples[j + 3];
        double blue = samples[i + 4] - samples[j + 4];
        // Half the square, mean of three components, and half of it for either pixel.
        double share = weight * (red * red + green * green + blue * blue) / 12;
        shares[pixel] += share;
        shares[other] += share;
        weights += weight;
    }

    /**
     * The density of the distances (a, b) between two independent points of a pixel over that of all pairs at hand. Between points
     * of neighbouring columns a has the density a, in the same column 2 (1 − a); the two points of one pixel, of which each half
     * has one, 4 min(a, 1 − a).
     */
    private double weight(double a, double b, boolean ofTwo) {
        double p = 1 - a;
        double q = 1 - b;
        double density = 2 * (beside * a * q + below * p * b) + across * a * b;
        if (ofTwo) {
            density += 16.0 * pixels * Math.min(a, p) * Math.min(b, q);
        }
        return density > 0 ? 4 * p * q / density : 0;
    }

    private int index(int column, int row) {
        return (row - tile.y) * tile.width + column - tile.x;
    }
}
