package enlightenment.image.flip;

import enlightenment.image.Image;
import java.util.Arrays;

/**
 * One of the two images of a comparison as the eye gets it, row by row from the top: colours after the eye's filter, and how
 * much of an edge or a point there is. Keeps no more rows than the filters reach over.
 */
final class FlipRows {
    private static final int LIGHT = 0;
    private static final int RED = 1;
    private static final int BLUE = 2;
    private static final int BLUE_NARROW = 3;
    private static final int SMOOTH = 4;
    private static final int EDGE = 5;
    private static final int POINT = 6;
    private static final int PLANES = 7;

    private final Image image;
    private final FlipKernels kernels;
    private final int width;

    /** By plane and by row modulo their number: rows that went through the row filters. */
    private final double[][][] rows;
    /** A row with radius copies of its first pixel before and of its last pixel behind it. */
    private final double[] padded;

    private final double[] luminance;
    private final double[] cx;
    private final double[] cz;
    private final double[] second;
    private int read;
    private int row = -1;

    /** Of the current row: CIELAB with Hunt's effect. */
    final double[] lightness;

    final double[] a;
    final double[] b;
    /** Of the current row: the magnitudes of edges and points. */
    final double[] edge;

    final double[] point;

    FlipRows(Image image, FlipKernels kernels) {
        this.image = image;
        this.kernels = kernels;
        width = image.width();
        rows = new double[PLANES][Math.min(2 * kernels.radius + 1, image.height())][width];
        padded = new double[width + 2 * kernels.radius];
        luminance = new double[width];
        cx = new double[width];
        cz = new double[width];
        second = new double[width];
        lightness = new double[width];
        a = new double[width];
        b = new double[width];
        edge = new double[width];
        point = new double[width];
    }

    /** Goes to the next row. */
    void next() {
        row++;
        while (read < image.height() && read <= row + kernels.radius) {
            readRow();
        }
        filterColumns(LIGHT, kernels.light, lightness);
        filterColumns(RED, kernels.red, a);
        filterColumns(BLUE, kernels.blue, b);
        filterColumns(BLUE_NARROW, kernels.blueNarrow, second);
        for (int x = 0; x < width; x++) {
            b[x] = kernels.blueShare * b[x] + kernels.blueNarrowShare * second[x];
        }
        FlipColor.toHuntLab(lightness, a, b);
        filterColumns(EDGE, kernels.smooth, edge);
        filterColumns(SMOOTH, kernels.edge, second);
        magnitude(edge);
        filterColumns(POINT, kernels.smooth, point);
        filterColumns(SMOOTH, kernels.point, second);
        magnitude(point);
    }

    private void magnitude(double[] first) {
        for (int x = 0; x < width; x++) {
            first[x] = Math.sqrt(first[x] * first[x] + second[x] * second[x]);
        }
    }

    private void readRow() {
        FlipColor.toOpponent(image, read, luminance, cx, cz);
        int slot = read % rows[0].length;
        pad(luminance);
        filterRow(kernels.light, rows[LIGHT][slot]);
        filterRow(kernels.smooth, rows[SMOOTH][slot]);
        filterRow(kernels.edge, rows[EDGE][slot]);
        filterRow(kernels.point, rows[POINT][slot]);
        pad(cx);
        filterRow(kernels.red, rows[RED][slot]);
        pad(cz);
        filterRow(kernels.blue, rows[BLUE][slot]);
        filterRow(kernels.blueNarrow, rows[BLUE_NARROW][slot]);
        read++;
    }

    private void pad(double[] values) {
        for (int i = 0; i < padded.length; i++) {
            padded[i] = values[Math.min(Math.max(i - kernels.radius, 0), width - 1)];
        }
    }

    private void filterRow(double[] weights, double[] out) {
        Arrays.fill(out, 0);
        for (int k = 0; k < weights.length; k++) {
            add(weights[k], padded, k, out);
        }
    }

    private void filterColumns(int plane, double[] weights, double[] out) {
        Arrays.fill(out, 0);
        for (int k = 0; k < weights.length; k++) {
            int from = Math.min(Math.max(row + k - kernels.radius, 0), image.height() - 1);
            add(weights[k], rows[plane][from % rows[plane].length], 0, out);
        }
    }

    /** Column by column and weight by weight: a loop that the JVM runs several columns at a time. */
    private static void add(double weight, double[] values, int from, double[] out) {
        for (int x = 0; x < out.length; x++) {
            out[x] += weight * values[from + x];
        }
    }
}
