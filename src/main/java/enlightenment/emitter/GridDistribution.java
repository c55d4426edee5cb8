package enlightenment.emitter;

/** Samples cells of a grid in proportion to their weights, and a place in the cell uniformly. Immutable. */
final class GridDistribution {
    private final int columns;
    private final int rows;

    /** The sum of all weights. */
    final double total;

    /** The probabilities of rows, added up; and those of cells within each row, each row beginning with 0. */
    private final double[] byRow;

    private final double[] byCell;

    /** @param weights row by row, finite and at least 0 */
    GridDistribution(int columns, int rows, double[] weights) {
        this.columns = columns;
        this.rows = rows;
        byRow = new double[rows + 1];
        byCell = new double[rows * (columns + 1)];
        double sum = 0;
        for (int row = 0; row < rows; row++) {
            int first = row * (columns + 1);
            for (int c = 0; c < columns; c++) {
                byCell[first + c + 1] = byCell[first + c] + weights[row * columns + c];
            }
            double ofRow = byCell[first + columns];
            for (int c = 1; c <= columns && ofRow > 0; c++) {
                byCell[first + c] /= ofRow;
            }
            sum += ofRow;
            byRow[row + 1] = sum;
        }
        for (int row = 1; row <= rows && sum > 0; row++) {
            byRow[row] /= sum;
        }
        total = sum;
    }

    /**
     * Samples a place.
     *
     * @param u uniform in [0, 1)
     * @param v uniform in [0, 1), independent of u
     * @param out receives column and row, each with the place within the cell as its fraction
     */
    void sample(double u, double v, double[] out) {
        int row = find(byRow, 0, rows, v);
        int first = row * (columns + 1);
        int cell = find(byCell, first, columns, u);
        double inRow = (v - byRow[row]) / (byRow[row + 1] - byRow[row]);
        double inCell = (u - byCell[first + cell]) / (byCell[first + cell + 1] - byCell[first + cell]);
        out[0] = cell + Math.min(inCell, Math.nextDown(1.0));
        out[1] = row + Math.min(inRow, Math.nextDown(1.0));
    }

    /** The interval of cumulative probabilities, which is not empty, that a number in [0, 1) lies in. */
    private static int find(double[] cumulative, int first, int count, double number) {
        int low = 0;
        int high = count;
        while (high - low > 1) {
            int middle = (low + high) >>> 1;
            if (cumulative[first + middle] <= number) {
                low = middle;
            } else {
                high = middle;
            }
        }
        return low;
    }

    /** The probability of a cell. */
    double probability(int column, int row) {
        int i = row * (columns + 1) + column;
        return (byRow[row + 1] - byRow[row]) * (byCell[i + 1] - byCell[i]);
    }
}
