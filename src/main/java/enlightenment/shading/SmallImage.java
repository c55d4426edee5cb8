package enlightenment.shading;

import java.util.Arrays;

/**
 * Where the eye sees a light straight or in one mirror, if that is so small that it may lie between the samples of a pixel: a convex
 * polygon around it, in pixels from the picture's upper left corner. Immutable.
 */
final class SmallImage {
    /** Instead of a mirror's id: the light is seen straight. */
    static final int STRAIGHT = -1;

    /** Instead of a mirror's face: any. */
    static final int ANY_FACE = -1;

    /** Each side of a pixel adds a corner at most. */
    private static final int SIDES = 4;

    final int light;

    /** The mirror's id, or {@link #STRAIGHT}. */
    final int mirror;

    /** The mirror's face, or {@link #ANY_FACE}. */
    final int face;

    private final double[] x;
    private final double[] y;
    final double left;
    final double right;
    final double top;
    final double bottom;

    /**
     * @param x the corners, in order
     * @param y as many
     */
    SmallImage(int light, int mirror, int face, double[] x, double[] y) {
        this.light = light;
        this.mirror = mirror;
        this.face = face;
        this.x = x;
        this.y = y;
        left = Arrays.stream(x).min().orElseThrow();
        right = Arrays.stream(x).max().orElseThrow();
        top = Arrays.stream(y).min().orElseThrow();
        bottom = Arrays.stream(y).max().orElseThrow();
    }

    /** The polygon's area in pixels. */
    double area() {
        double twice = 0;
        for (int k = 0; k < x.length; k++) {
            int next = (k + 1) % x.length;
            twice += (x[k] - x[0]) * (y[next] - y[0]) - (x[next] - x[0]) * (y[k] - y[0]);
        }
        return Math.abs(twice) / 2;
    }

    /** Whether the polygon's own box reaches into a box. */
    boolean reaches(double x0, double y0, double x1, double y1) {
        return left < x1 && right > x0 && top < y1 && bottom > y0;
    }

    /**
     * Finds the box around what of the image is in a pixel.
     *
     * @param column of the pixel
     * @param row of the pixel
     * @param box receives left, top, right and bottom, from {@code at} on
     * @return whether it is smaller than the pixel, and not empty: samples within it find more than samples of the pixel
     */
    boolean clip(int column, int row, double[] box, int at) {
        double[] px = Arrays.copyOf(x, x.length + SIDES);
        double[] py = Arrays.copyOf(y, y.length + SIDES);
        int n = cut(px, py, x.length, column, 1);
        n = cut(px, py, n, column + 1, -1);
        n = cut(py, px, n, row, 1);
        n = cut(py, px, n, row + 1, -1);
        if (n == 0) {
            return false;
        }
        box[at] = Arrays.stream(px, 0, n).min().orElseThrow();
        box[at + 1] = Arrays.stream(py, 0, n).min().orElseThrow();
        box[at + 2] = Arrays.stream(px, 0, n).max().orElseThrow();
        box[at + 3] = Arrays.stream(py, 0, n).max().orElseThrow();
        double area = (box[at + 2] - box[at]) * (box[at + 3] - box[at + 1]);
        return area > 0 && area < 1;
    }

    /**
     * Cuts off what of a convex polygon lies beyond a line: I. Sutherland and G. Hodgman, "Reentrant polygon clipping", 1974.
     *
     * @param u the coordinate across the line, of n corners; receives those of what is left
     * @param v the other one
     * @param side 1 if greater coordinates than the limit are kept, otherwise -1
     * @return how many corners are left
     */
    private static int cut(double[] u, double[] v, int n, double limit, int side) {
        double[] oldU = Arrays.copyOf(u, n);
        double[] oldV = Arrays.copyOf(v, n);
        int left = 0;
        for (int k = 0; k < n; k++) {
            int next = (k + 1) % n;
            double here = side * (oldU[k] - limit);
            double there = side * (oldU[next] - limit);
            if (here >= 0) {
                u[left] = oldU[k];
                v[left++] = oldV[k];
            }
            if (here > 0 && there < 0 || here < 0 && there > 0) {
                u[left] = limit;
                v[left++] = oldV[k] + here / (here - there) * (oldV[next] - oldV[k]);
            }
        }
        return left;
    }
}
