package enlightenment.film;

/**
 * What the pixels beside a pixel tell about the error of its mean, where its own samples are too few to tell it. Neighbours have
 * independent random numbers, but other truths.
 *
 * <p>Only pixels of the same cell of 8 × 8 are compared, cut from the whole picture's corner: so a pixel has the same figures in
 * a trial, in a tile of any size and on a worker of a network.
 */
final class Neighbours {
    private static final int CELL = 8;

    private final FilmTile tile;

    Neighbours(FilmTile tile) {
        this.tile = tile;
    }

    /**
     * Half the mean squared difference between the pixel and those beside it with the same number of samples: of pixels with
     * the same truth it is the variance of their means, of others more. Without such a neighbour, the squared mean itself.
     */
    double difference(int column, int row) {
        int count = tile.count(column, row);
        double sum = 0;
        int neighbours = 0;
        for (int k = 0; k < 4; k++) {
            int c = column + (k == 0 ? -1 : k == 1 ? 1 : 0);
            int r = row + (k == 2 ? -1 : k == 3 ? 1 : 0);
            if (isInCell(c, r, column, row) && tile.count(c, r) == count) {
                sum += product(c, r, column, row, c, r, column, row) / 2;
                neighbours++;
            }
        }
        // A pixel on its own among others: where there is a known part, the distance from it is all there is to compare
        // with.
        return neighbours > 0 ? sum / neighbours : tile.squaredDifference(column, row);
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
        for (int k = 0; k < 2; k++) {
            int right = 1 - k;
            int c = column + right * inward(column, row, right, k);
            int r = row + k * inward(column, row, right, k);
            if (isInCell(c - right, r - k, column, row)
                    && isInCell(c, r, column, row)
                    && isInCell(c + right, r + k, column, row)) {
                sum -= product(c, r, c - right, r - k, c + right, r + k, c, r);
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
        return c >= 0
                && r >= 0
                && c / CELL == column / CELL
                && r / CELL == row / CELL
                && tile.contains(c, r)
                && tile.count(c, r) > 0;
    }

    /** (a − b)(c − d) for the means of four pixels, mean of the components. */
    private double product(int ax, int ay, int bx, int by, int cx, int cy, int dx, int dy) {
        double sum = 0;
        for (int c = 0; c < 3; c++) {
            sum += (tile.difference(ax, ay, c) - tile.difference(bx, by, c))
                    * (tile.difference(cx, cy, c) - tile.difference(dx, dy, c));
        }
        return sum / 3;
    }
}
