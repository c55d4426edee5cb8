package enlightenment.world.light;

/**
 * The image of a light on the film, as directly visible: a convex polygon around it, in pixels from the picture's upper left corner.
 * Immutable.
 */
public final class LightImage {
    /** The light's index. */
    public final int light;

    /** The light's radiance in its brightest band; greater than 0. */
    public final double brightness;

    /** The corners, in order; not to be changed. */
    public final double[] x;

    public final double[] y;
    private final double left;
    private final double right;
    private final double top;
    private final double bottom;

    /**
     * @param light the light's index
     * @param from the light
     * @param x of the corners, at least one, in order, with the inside to the left of each side where x points to the right and y upwards
     * @param y of as many corners
     */
    public LightImage(int light, PhysicalLight from, double[] x, double[] y) {
        this.light = light;
        this.x = x;
        this.y = y;
        brightness = brightness(from);
        double x0 = x[0];
        double x1 = x[0];
        double y0 = y[0];
        double y1 = y[0];
        for (int k = 1; k < x.length; k++) {
            x0 = Math.min(x0, x[k]);
            x1 = Math.max(x1, x[k]);
            y0 = Math.min(y0, y[k]);
            y1 = Math.max(y1, y[k]);
        }
        left = x0;
        right = x1;
        top = y0;
        bottom = y1;
    }

    /** A light's radiance in its brightest band. */
    static double brightness(PhysicalLight l) {
        return Math.max(l.r, Math.max(l.g, l.b));
    }

    /** The polygon's area in pixels. */
    double area() {
        return ClippedPolygon.area(x, y, x.length);
    }

    /** Whether the polygon's bounding box overlaps a box. */
    public boolean reaches(double x0, double y0, double x1, double y1) {
        return left < x1 && right > x0 && top < y1 && bottom > y0;
    }
}
