package enlightenment.photometry;

import java.util.Arrays;

/**
 * Luminous intensity by direction, in candela: half planes around the nadir axis (type C), in each of them angles from the nadir. Between them it is
 * bilinear in both angles, outside of the vertical angles 0. Immutable.
 */
public final class IntensityTable {
    /** Degrees from the nadir, ascending: within 0..180. */
    private final double[] vertical;

    /** Degrees around the nadir axis, ascending from 0 to 360. */
    private final double[] horizontal;

    /** By half plane, then vertical angle; the last half plane is the first one again. */
    private final double[][] candela;

    private final double largest;

    /**
     * A table of all half planes.
     *
     * @param vertical degrees from the nadir, at least two, ascending within 0..180
     * @param horizontal degrees of the half planes, ascending from 0 to 360
     * @param candela by half plane, then vertical angle: finite, at least 0
     */
    IntensityTable(double[] vertical, double[] horizontal, double[][] candela) {
        this.vertical = vertical;
        this.horizontal = horizontal;
        this.candela = candela;
        largest = Arrays.stream(candela).flatMapToDouble(Arrays::stream).max().orElse(0);
    }

    /** How many vertical angles there are. */
    public int rows() {
        return vertical.length;
    }

    /** How many half planes there are, the one at 360 degrees included. */
    public int columns() {
        return horizontal.length;
    }

    /** The vertical angle of a row: degrees from the nadir. */
    public double vertical(int row) {
        return vertical[row];
    }

    /** The angle of a half plane, in degrees. */
    public double horizontal(int column) {
        return horizontal[column];
    }

    /** The intensity in a half plane at a vertical angle of the table, in candela. */
    public double candela(int column, int row) {
        return candela[column][row];
    }

    /** The largest intensity, in candela. */
    public double largest() {
        return largest;
    }

    /**
     * The intensity of a direction, in candela.
     *
     * @param fromNadir degrees, 0..180
     * @param around degrees, 0..360
     */
    public double candela(double fromNadir, double around) {
        if (!(fromNadir >= vertical[0] && fromNadir <= vertical[vertical.length - 1])) {
            return 0;
        }
        int row = interval(vertical, fromNadir);
        int column = column(around);
        double v = (fromNadir - vertical[row]) / (vertical[row + 1] - vertical[row]);
        double h = (around - horizontal[column]) / (horizontal[column + 1] - horizontal[column]);
        double low = mix(candela[column][row], candela[column][row + 1], v);
        double high = mix(candela[column + 1][row], candela[column + 1][row + 1], v);
        return Math.max(mix(low, high, Math.min(Math.max(h, 0), 1)), 0);
    }

    /** The column of angles around the nadir, in degrees, that a direction lies in: from the half plane of this number to the next one. */
    public int column(double around) {
        return interval(horizontal, around);
    }

    private static double mix(double a, double b, double t) {
        return a + t * (b - a);
    }

    /** The interval of ascending numbers that a number lies in: the first or the last one for what lies outside. */
    public static int interval(double[] ascending, double number) {
        int at = Arrays.binarySearch(ascending, number);
        int below = at < 0 ? -at - 2 : at;
        return Math.min(Math.max(below, 0), ascending.length - 2);
    }
}
