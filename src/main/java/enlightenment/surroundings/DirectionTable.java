package enlightenment.surroundings;

import enlightenment.codec.Raster;
import enlightenment.sampling.GridDistribution;
import java.io.IOException;

/**
 * Chooses directions by what comes from there: cells of rows and columns, of which one is chosen by its brightness times its solid angle,
 * and a direction in it evenly. The density is greater than 0 wherever the cell's brightness is. Immutable.
 */
final class DirectionTable {
    /** Cells with more than this many texels to choose from are not worth their memory: texels are taken together then. */
    private static final int MOST_CELLS = 1 << 23;

    /** The share of directions that is chosen evenly among all cells that are not black. */
    private static final double EVEN = 1.0 / 16;

    private final int rows;
    private final int columns;

    /** Whether the last row is all that is below the horizon. */
    private final boolean hasGround;

    /** The angle from the zenith that a row of equal angle takes. */
    private final double rowAngle;

    /** The cosines at which rows begin, from 1 down; the row after those of equal angle, if there is one, is that below the horizon. */
    private final double[] cosines;

    /** Where columns begin, in turns. */
    private final double[] widths;

    private final GridDistribution cells;

    /** The sum of brightness times solid angle over all directions. */
    final double total;

    /** @throws IOException if there is not enough memory */
    DirectionTable(DirectionMap map) throws IOException {
        int block = 1;
        while ((long) (map.width / block) * (map.height / block) > MOST_CELLS) {
            block *= 2;
        }
        int upper = (map.height + block - 1) / block;
        columns = (map.width + block - 1) / block;
        hasGround = map.span < Math.PI;
        rows = hasGround ? upper + 1 : upper;
        rowAngle = map.span / map.height * block;
        cosines = new double[rows + 1];
        for (int row = 0; row <= upper; row++) {
            cosines[row] = map.cosine(Math.min(row * block, map.height));
        }
        cosines[rows] = -1;
        double[] weights = Raster.allocate(columns, rows, 8, () -> new double[rows * (columns + 1)]);
        widths = new double[columns + 1];
        for (int c = 0; c <= columns; c++) {
            widths[c] = Math.min((double) c * block / map.width, 1);
        }
        total = fill(weights, map, block, upper);
        cells = new GridDistribution(columns, rows, weights);
    }

    /** Fills in brightness times solid angle; returns the sum. */
    private double fill(double[] weights, DirectionMap map, int block, int upper) {
        double ground = map.below.r() + map.below.g() + map.below.b();
        double bright = 0;
        double lit = 0;
        for (int row = 0; row < rows; row++) {
            double height = 2 * Math.PI * (cosines[row] - cosines[row + 1]);
            for (int c = 0; c < columns; c++) {
                double weight = row < upper ? mean(map, block, c, row) : ground;
                double angle = height * (widths[c + 1] - widths[c]);
                weights[row * (columns + 1) + c + 1] = weight * angle;
                bright += weight * angle;
                lit += weight > 0 ? angle : 0;
            }
        }
        for (int row = 0; row < rows && bright > 0; row++) {
            double height = 2 * Math.PI * (cosines[row] - cosines[row + 1]);
            for (int c = 0; c < columns; c++) {
                int i = row * (columns + 1) + c + 1;
                double angle = height * (widths[c + 1] - widths[c]);
                if (weights[i] > 0) {
                    weights[i] = (1 - EVEN) * weights[i] / bright + EVEN * angle / lit;
                }
            }
        }
        return bright;
    }

    private static double mean(DirectionMap map, int block, int column, int row) {
        double sum = 0;
        int count = 0;
        for (int y = row * block; y < Math.min((row + 1) * block, map.height); y++) {
            for (int x = column * block; x < Math.min((column + 1) * block, map.width); x++) {
                sum += map.meanBrightness(x, y);
                count++;
            }
        }
        return sum / count;
    }

    /** Whether nothing comes from anywhere. */
    boolean isBlack() {
        return !(total > 0);
    }

    /**
     * Chooses a direction by two numbers in 0..1.
     *
     * @param out receives the turn around the vertical, in 0..1, and the cosine of the angle from the zenith
     * @return the density per solid angle
     */
    double sample(double u, double v, double[] out) {
        int row = cells.row(v);
        int cell = cells.column(row, u);
        double inCell = cells.withinCell(cell, row, u);
        out[0] = Math.min(Math.fma(inCell, widths[cell + 1] - widths[cell], widths[cell]), 1);
        out[1] = Math.fma(cells.withinRow(row, v), cosines[row + 1] - cosines[row], cosines[row]);
        return density(row, cell);
    }

    private double density(int row, int cell) {
        return cells.probability(cell, row)
                / (2 * Math.PI * (widths[cell + 1] - widths[cell]) * (cosines[row] - cosines[row + 1]));
    }

    /**
     * The density with which a direction is chosen.
     *
     * @param turn around the vertical, in 0..1
     * @param angle from the zenith
     * @param isBelow whether it leads below the horizon
     */
    double density(double turn, double angle, boolean isBelow) {
        int last = rows - 1;
        int row = hasGround && isBelow ? last : Math.min((int) (angle / rowAngle), hasGround ? last - 1 : last);
        int cell = Math.min((int) (turn * columns), columns - 1);
        // Where texels do not divide into cells evenly the last one is narrower.
        if (turn < widths[cell]) {
            cell--;
        } else if (turn >= widths[cell + 1] && cell < columns - 1) {
            cell++;
        }
        return density(row, cell);
    }
}
