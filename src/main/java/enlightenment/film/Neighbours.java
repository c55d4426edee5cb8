package enlightenment.film;

/**
 * What the pixels beside a pixel tell about the error of its mean, where its own samples are too few to tell it. Neighbours have
 * independent random numbers, but other truths.
 *
 * <p>Only pixels of the same cell of 8 × 8 are compared, cut from the whole picture's corner: so a pixel has the same figures in
 * a trial, in a tile of any size and on a worker of a network.
 */
final class Neighbours {
    /** Binary logarithm of a cell's side. */
    private static final int CELL = 3;

    private final FilmTile tile;

    /** Per pixel: the means of red, green and blue without the known part. */
    private final double[] means;

    /** Of the tile as it is now. */
    Neighbours(FilmTile tile) {
        this.tile = tile;
        means = new double[3 * tile.width * tile.height];
        for (int k = 0; k < means.length; k++) {
            means[k] = tile.meanDifference(k / 3, k % 3);
        }
    }

    /**
     * Half the mean squared difference between the pixel and those beside it with the same number of samples: of pixels with
     * the same truth it is the variance of their means, of others more. Without such a neighbour, the squared mean itself.
     */
    double difference(int column, int row) {
        int count = tile.count(column, row);
        int pixel = index(column, row);
        double sum = 0;
        int neighbours = 0;
        for (int k = 0; k < 4; k++) {
            int c = column + (k == 0 ? -1 : k == 1 ? 1 : 0);
            int r = row + (k == 2 ? -1 : k == 3 ? 1 : 0);
            if (isInCell(c, r, column, row) && tile.count(c, r) == count) {
                int other = index(c, r);
                sum += product(pixel, other, pixel, other);
                neighbours++;
            }
        }
        // A pixel on its own among others: where there is a known part, the distance from it is all there is to compare
        // with.
        return neighbours > 0 ? sum / (2 * neighbours) : squared(pixel);
    }

    /**
     * Minus the product of the step to the pixel and the step from it, mean of rows and columns. If the truths are p, q, r and
     * the variance of the middle mean is V, its expectation is V − (q − p)(r − q), whatever the variances of the other two:
     * V for noise on an even ground, little across an edge, where one of the steps is V and more. Where there are not three
     * pixels in a row, the same as {@link #difference}.
     */
    double steps(int column, int row) {
        double sum = 0;
        int directions = 0;
        for (int down = 0; down < 2; down++) {
            int right = 1 - down;
            int inward = inward(column, row, right, down);
            int c = column + right * inward;
            int r = row + down * inward;
            if (isInCell(c - right, r - down, column, row)
                    && isInCell(c, r, column, row)
                    && isInCell(c + right, r + down, column, row)) {
                int middle = index(c, r);
                int step = index(c + right, r + down) - middle;
                sum -= product(middle, middle - step, middle + step, middle);
                directions++;
            }
        }
        return directions > 0 ? sum / directions : difference(column, row);
    }

    /** A step away from the cell's border in the direction (right, down), or none. */
    private int inward(int column, int row, int right, int down) {
        if (!isInCell(column - right, row - down, column, row)) {
            return 1;
        }
        return isInCell(column + right, row + down, column, row) ? 0 : -1;
    }

    private boolean isInCell(int c, int r, int column, int row) {
        return ((c ^ column) >> CELL | (r ^ row) >> CELL) == 0 && tile.contains(c, r) && tile.count(c, r) > 0;
    }

    private int index(int column, int row) {
        return 3 * ((row - tile.y) * tile.width + column - tile.x);
    }

    /** (a − b)(c − d) for the means of four pixels, mean of the components. */
    private double product(int a, int b, int c, int d) {
        return ((means[a] - means[b]) * (means[c] - means[d])
                        + (means[a + 1] - means[b + 1]) * (means[c + 1] - means[d + 1])
                        + (means[a + 2] - means[b + 2]) * (means[c + 2] - means[d + 2]))
                / 3;
    }

    private double squared(int pixel) {
        double sum = 0;
        for (int c = 0; c < 3; c++) {
            sum += means[pixel + c] * means[pixel + c];
        }
        return sum / 3;
    }
}
