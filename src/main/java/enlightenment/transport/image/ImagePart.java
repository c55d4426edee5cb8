package enlightenment.transport.image;

import enlightenment.world.light.LightImage;

/**
 * The part of a light's image within one pixel: a convex polygon on the film that is sampled uniformly. Immutable but for the last sample.
 */
final class ImagePart {
    final LightImage image;

    /** The area of the polygon, in pixels. */
    final double area;

    private final double[] x;
    private final double[] y;

    /** Cumulative sums of twice the areas of the triangles of the fan around the first corner. */
    private final double[] sums;

    /** The sampled film position, in pixels. */
    double placeX;

    double placeY;

    /** Makes the part from the corners of a polygon with this positive area. */
    ImagePart(LightImage image, double area, double[] x, double[] y) {
        this.image = image;
        this.area = area;
        this.x = x;
        this.y = y;
        sums = new double[x.length - 1];
        for (int k = 1; k < sums.length; k++) {
            sums[k] = sums[k - 1] + Math.abs((x[k] - x[0]) * (y[k + 1] - y[0]) - (x[k + 1] - x[0]) * (y[k] - y[0]));
        }
    }

    /** Samples a film position uniformly over the polygon; within each triangle the map from the unit square is continuous. */
    void sample(double u, double v) {
        int last = sums.length - 1;
        double at = u * sums[last];
        int k = 1;
        while (k < last && at >= sums[k]) {
            k++;
        }
        double width = sums[k] - sums[k - 1];
        double a = Math.sqrt(width > 0 ? Math.min((at - sums[k - 1]) / width, 1) : 0);
        double b = a * v;
        placeX = x[0] + a * (x[k] - x[0]) + b * (x[k + 1] - x[k]);
        placeY = y[0] + a * (y[k] - y[0]) + b * (y[k + 1] - y[k]);
    }

    /** Whether a film position, in pixels, is in the polygon. */
    boolean contains(double px, double py) {
        boolean isLeft = true;
        boolean isRight = true;
        for (int k = 0; k < x.length; k++) {
            int next = k + 1 == x.length ? 0 : k + 1;
            double side = (x[next] - x[k]) * (py - y[k]) - (y[next] - y[k]) * (px - x[k]);
            isLeft &= side >= 0;
            isRight &= side <= 0;
        }
        return isLeft || isRight;
    }
}
