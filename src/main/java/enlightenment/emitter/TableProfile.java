package enlightenment.emitter;

import enlightenment.math.Vec3;
import enlightenment.numeric.Angles;
import enlightenment.photometry.IntensityTable;
import enlightenment.sampling.GridDistribution;
import java.util.Arrays;

/**
 * The intensity of a luminaire by a table: {@link IntensityTable}, over its largest value. Directions are sampled by the patches of the
 * table, cut into rows of at most {@link #STEP} degrees: a patch by its mean intensity times its solid angle, a direction in it uniformly.
 */
public final class TableProfile implements IntensityProfile {
    /** The largest height of a row, in degrees. */
    private static final double STEP = 2;

    private final IntensityTable table;

    /** The nadir axis, and the unit vectors in the half planes of 0 and of 90 degrees. */
    private final Vec3 nadir;

    private final Vec3 zero;
    private final Vec3 quarter;

    /** The beginnings of rows and the end of the last one, in degrees from the nadir, ascending; and their 1 − cos. */
    private final double[] rows;

    private final double[] heights;

    private final int columns;
    private final GridDistribution cells;
    private final double solidAngle;

    /**
     * Makes the profile of a table with an intensity above 0.
     *
     * @param nadir unit vector of the vertical angle 0
     * @param rotation degrees by which the half plane of the horizontal angle 0 is rotated around the nadir, in the direction of growing
     *     horizontal angles; at 0 that half plane contains the image of the x axis under the smallest rotation from −y to the nadir
     */
    public TableProfile(IntensityTable table, Vec3 nadir, double rotation) {
        this.table = table;
        this.nadir = nadir;
        double over = 1 - nadir.y();
        Vec3 zero = over > 0
                ? Vec3.X.minus(nadir.minus(Vec3.Y).times(nadir.x() / over)).normalized()
                : Vec3.X;
        Vec3 quarter = zero.cross(nadir);
        double sin = StrictMath.sin(StrictMath.toRadians(rotation));
        double cos = StrictMath.cos(StrictMath.toRadians(rotation));
        this.zero = zero.times(cos).plus(quarter.times(sin));
        this.quarter = quarter.times(cos).minus(zero.times(sin));
        rows = rows(table);
        heights = Arrays.stream(rows).map(TableProfile::oneMinusCosine).toArray();
        columns = table.columns() - 1;
        cells = new GridDistribution(columns, rows.length - 1, weights());
        solidAngle = integral() / table.largest();
    }

    private static double oneMinusCosine(double degrees) {
        double sine = StrictMath.sin(0.5 * StrictMath.toRadians(degrees));
        return 2 * sine * sine;
    }

    private static double[] rows(IntensityTable table) {
        double[] rows = new double[table.rows() + (int) (180 / STEP)];
        int count = 0;
        for (int row = 0; row < table.rows() - 1; row++) {
            double from = table.vertical(row);
            double height = table.vertical(row + 1) - from;
            int parts = (int) Math.ceil(height / STEP);
            for (int k = 0; k < parts; k++) {
                rows[count++] = from + height * k / parts;
            }
        }
        rows[count++] = table.vertical(table.rows() - 1);
        return Arrays.copyOf(rows, count);
    }

    /**
     * The weight of each patch, in the order of {@link GridDistribution}: mean intensity times solid angle, 0 only where the patch is dark,
     * as it is bilinear.
     */
    private double[] weights() {
        int count = rows.length - 1;
        double[] weights = new double[(columns + 1) * count];
        for (int row = 0; row < count; row++) {
            for (int c = 0; c < columns; c++) {
                double mean = corner(c, row) + corner(c + 1, row) + corner(c, row + 1) + corner(c + 1, row + 1);
                double turn = table.horizontal(c + 1) - table.horizontal(c);
                weights[row * (columns + 1) + c + 1] = mean * turn * (heights[row + 1] - heights[row]);
            }
        }
        return weights;
    }

    private double corner(int column, int row) {
        return table.candela(rows[row], table.horizontal(column)) / table.largest();
    }

    /**
     * The exact integral over the patches: linear in the angle around, so that the mean of two half planes counts; in the angle from the nadir, f = m + s (θ − θ₀) for
     * θ₀ ± h integrates to 2m sin θ₀ sin h + 2s cos θ₀ (sin h − h cos h).
     */
    private double integral() {
        double sum = 0;
        for (int row = 0; row < table.rows() - 1; row++) {
            double low = StrictMath.toRadians(table.vertical(row));
            double high = StrictMath.toRadians(table.vertical(row + 1));
            double middle = 0.5 * (low + high);
            double half = 0.5 * (high - low);
            double level = 2 * StrictMath.sin(middle) * StrictMath.sin(half);
            double slope = 2 * StrictMath.cos(middle) * (StrictMath.sin(half) - half * StrictMath.cos(half)) / half;
            for (int c = 0; c < columns; c++) {
                double turn = StrictMath.toRadians(table.horizontal(c + 1) - table.horizontal(c));
                double start = 0.5 * (table.candela(c, row) + table.candela(c + 1, row));
                double end = 0.5 * (table.candela(c, row + 1) + table.candela(c + 1, row + 1));
                sum += turn * (0.5 * (start + end) * level + 0.5 * (end - start) * slope);
            }
        }
        return sum;
    }

    @Override
    public double luminance(double dx, double dy, double dz) {
        return Math.min(table.candela(fromNadir(dx, dy, dz), around(dx, dy, dz)) / table.largest(), 1);
    }

    /** The angle from the nadir in degrees, from the unit vectors' difference and sum: nothing cancels near both ends. */
    private double fromNadir(double dx, double dy, double dz) {
        double ex = dx - nadir.x();
        double ey = dy - nadir.y();
        double ez = dz - nadir.z();
        double fx = dx + nadir.x();
        double fy = dy + nadir.y();
        double fz = dz + nadir.z();
        double difference = Math.sqrt(ex * ex + ey * ey + ez * ez);
        double sum = Math.sqrt(fx * fx + fy * fy + fz * fz);
        return Math.min(StrictMath.toDegrees(2 * Angles.atan2(difference, sum)), 180);
    }

    /** The angle around the nadir in degrees, 0..360. */
    private double around(double dx, double dy, double dz) {
        double a = dx * zero.x() + dy * zero.y() + dz * zero.z();
        double b = dx * quarter.x() + dy * quarter.y() + dz * quarter.z();
        double degrees = StrictMath.toDegrees(Angles.atan2(b, a));
        return degrees < 0 ? degrees + 360 : degrees;
    }

    @Override
    public double sample(double u, double v, double[] out) {
        cells.sample(u, v, out);
        int column = Math.min((int) out[0], columns - 1);
        int row = Math.min((int) out[1], rows.length - 2);
        double height = heights[row] + (out[1] - row) * (heights[row + 1] - heights[row]);
        double from = table.horizontal(column);
        double turn = StrictMath.toRadians(from + (out[0] - column) * (table.horizontal(column + 1) - from));
        double spread = Math.sqrt(Math.max(height * (2 - height), 0));
        double a = spread * StrictMath.cos(turn);
        double b = spread * StrictMath.sin(turn);
        Vec3 d = zero.times(a)
                .plus(quarter.times(b))
                .plus(nadir.times(1 - height))
                .normalized();
        out[0] = d.x();
        out[1] = d.y();
        out[2] = d.z();
        return density(d.x(), d.y(), d.z());
    }

    @Override
    public double density(double dx, double dy, double dz) {
        double angle = fromNadir(dx, dy, dz);
        if (angle < rows[0] || angle > rows[rows.length - 1]) {
            return 0;
        }
        int row = IntensityTable.interval(rows, angle);
        int column = table.column(around(dx, dy, dz));
        double turn = StrictMath.toRadians(table.horizontal(column + 1) - table.horizontal(column));
        return cells.probability(column, row) / (turn * (heights[row + 1] - heights[row]));
    }

    @Override
    public double solidAngle() {
        return solidAngle;
    }

    @Override
    public Vec3 axis() {
        return rows[rows.length - 1] <= 90 || rows[0] < 90 ? nadir : nadir.negated();
    }

    @Override
    public double coneAngle() {
        double first = rows[0];
        double last = rows[rows.length - 1];
        return StrictMath.toRadians(last > 90 && first >= 90 ? 180 - first : last);
    }

    @Override
    public double[] parameters() {
        double[] numbers = new double[6 + table.rows() + table.columns() * (table.rows() + 1)];
        int k = 0;
        for (Vec3 v : new Vec3[] {nadir, zero}) {
            numbers[k++] = v.x();
            numbers[k++] = v.y();
            numbers[k++] = v.z();
        }
        for (int row = 0; row < table.rows(); row++) {
            numbers[k++] = table.vertical(row);
        }
        for (int c = 0; c < table.columns(); c++) {
            numbers[k++] = table.horizontal(c);
            for (int row = 0; row < table.rows(); row++) {
                numbers[k++] = table.candela(c, row);
            }
        }
        return numbers;
    }
}
