package enlightenment.transport.image;

import enlightenment.world.light.LightImage;

/** What of a light's image is in one pixel: a convex polygon, over which places are sampled evenly. Immutable but for the last place. */
final class ImagePart {
    final LightImage image;

    /** In pixels. */
    final double area;

    private final double[] x;
    private final double[] y;

    /** Twice the areas of the triangles that the first corner and each side that it is not on make, as sums. */
    private final double[] sums;

    /** The place that was sampled. */
    double placeX;

    double placeY;

    /** Of a polygon with an area. */
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

    /** Samples a place, evenly over the polygon: neighbours in the unit square are so in each of its triangles. */
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

    /** Whether a place is in the polygon. */
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
