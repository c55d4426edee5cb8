package enlightenment.world.light;

import java.util.Arrays;

/**
 * A convex polygon that can be clipped to a box: I. Sutherland and G. Hodgman, "Reentrant polygon clipping", 1974. A mutable work object,
 * one per thread.
 */
public final class ClippedPolygon {
    /** Each side of the box adds at most one corner. */
    private static final int SIDES = 4;

    private double[] x = new double[0];
    private double[] y = new double[0];
    private double[] oldX = new double[0];
    private double[] oldY = new double[0];
    private int size;

    /** Sets it to the part of a polygon within a box; x and y of the polygon's corners, in order. */
    public void set(double[] xs, double[] ys, double left, double top, double right, double bottom) {
        if (x.length < xs.length + SIDES) {
            x = new double[xs.length + SIDES];
            y = new double[xs.length + SIDES];
            oldX = new double[xs.length + SIDES];
            oldY = new double[xs.length + SIDES];
        }
        size = xs.length;
        System.arraycopy(xs, 0, x, 0, size);
        System.arraycopy(ys, 0, y, 0, size);
        cutX(left, 1);
        cutX(right, -1);
        cutY(top, 1);
        cutY(bottom, -1);
    }

    /** Clips at a limit of x: keeps greater numbers for the side 1, smaller ones for −1. */
    private void cutX(double limit, int side) {
        double[] u = oldX;
        double[] v = oldY;
        oldX = x;
        oldY = y;
        x = u;
        y = v;
        size = cut(oldX, oldY, size, u, v, limit, side);
    }

    private void cutY(double limit, int side) {
        double[] u = oldY;
        double[] v = oldX;
        oldX = x;
        oldY = y;
        x = v;
        y = u;
        size = cut(oldY, oldX, size, u, v, limit, side);
    }

    /** Clips at a limit of the first coordinate, from one pair of arrays to another; returns the number of corners. */
    private static int cut(double[] fromU, double[] fromV, int n, double[] u, double[] v, double limit, int side) {
        int left = 0;
        for (int k = 0; k < n; k++) {
            int next = k + 1 == n ? 0 : k + 1;
            double here = side * (fromU[k] - limit);
            double there = side * (fromU[next] - limit);
            if (here >= 0) {
                u[left] = fromU[k];
                v[left++] = fromV[k];
            }
            if (here > 0 && there < 0 || here < 0 && there > 0) {
                u[left] = limit;
                v[left++] = fromV[k] + here / (here - there) * (fromV[next] - fromV[k]);
            }
        }
        return left;
    }

    /** The area of the polygon; 0 if it is empty. */
    public double area() {
        return area(x, y, size);
    }

    /** The area of a convex polygon: x and y of its corners, in order, at the beginning of arrays. */
    public static double area(double[] x, double[] y, int size) {
        double twice = 0;
        for (int k = 2; k < size; k++) {
            twice += (x[k - 1] - x[0]) * (y[k] - y[0]) - (x[k] - x[0]) * (y[k - 1] - y[0]);
        }
        return Math.abs(twice) / 2;
    }

    /** The corners' x. */
    public double[] copyOfX() {
        return Arrays.copyOf(x, size);
    }

    /** The corners' y. */
    public double[] copyOfY() {
        return Arrays.copyOf(y, size);
    }
}
