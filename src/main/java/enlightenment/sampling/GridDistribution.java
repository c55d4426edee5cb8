package enlightenment.sampling;

/** Samples cells of a grid in proportion to their weights, and a position within the cell uniformly. Immutable. */
public final class GridDistribution {
    private final int columns;
    private final int rows;

    /** Cumulative probabilities of rows; and those of cells within each row, each row beginning with 0. */
    private final double[] byRow;

    private final double[] byCell;

    /**
     * Makes the distribution of these weights.
     *
     * @param weights row by row, each row beginning with 0, then the weights of its cells, finite and at least 0; kept and changed
     */
    public GridDistribution(int columns, int rows, double[] weights) {
        this.columns = columns;
        this.rows = rows;
        byRow = new double[rows + 1];
        byCell = weights;
        double sum = 0;
        for (int row = 0; row < rows; row++) {
            int first = row * (columns + 1);
            for (int c = 1; c <= columns; c++) {
                byCell[first + c] += byCell[first + c - 1];
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
    }

    /**
     * Samples a position.
     *
     * @param u uniform in [0, 1)
     * @param v uniform in [0, 1), independent of u
     * @param out receives column and row, each with the position within the cell as its fraction
     */
    public void sample(double u, double v, double[] out) {
        int row = row(v);
        int column = column(row, u);
        out[0] = column + Math.min(withinCell(column, row, u), Math.nextDown(1.0));
        out[1] = row + Math.min(withinRow(row, v), Math.nextDown(1.0));
    }

    /** The row that a uniform number in [0, 1) selects. */
    public int row(double number) {
        return find(byRow, 0, rows, number);
    }

    /** The position of the number within the interval of its row, 0..1: uniform again. */
    public double withinRow(int row, double number) {
        return (number - byRow[row]) / (byRow[row + 1] - byRow[row]);
    }

    /** The column that a uniform number in [0, 1) selects in a row. */
    public int column(int row, double number) {
        return find(byCell, row * (columns + 1), columns, number);
    }

    /** The position of the number within the interval of its cell, 0..1: uniform again. */
    public double withinCell(int column, int row, double number) {
        int i = row * (columns + 1) + column;
        return (number - byCell[i]) / (byCell[i + 1] - byCell[i]);
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
    public double probability(int column, int row) {
        int i = row * (columns + 1) + column;
        return (byRow[row + 1] - byRow[row]) * (byCell[i + 1] - byCell[i]);
    }
}
