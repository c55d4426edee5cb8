package enlightenment.world.light;

import enlightenment.frame.BallCone;
import enlightenment.numeric.Scale;

/**
 * The end points of segments from a common point, for {@code Tracer}: occluder candidates are found for all of them together. A mutable
 * work object, one per thread.
 */
public final class SegmentEnds {
    /** The id of no primitive. */
    private static final int NONE = -1;

    /** A generous bound of the roundings of the ball around the points. */
    private static final double ERROR = Scale.gamma(64);

    /** A box around the points: three least, three largest coordinates. */
    final double[] box = new double[6];

    /** The sum of the largest absolute coordinates. */
    double size;

    /** The cone of directions to the points. */
    public final BallCone cone = new BallCone() {
        @Override
        public void findEnds(double[] out) {
            System.arraycopy(box, 0, out, 0, box.length);
        }
    };

    /** The id of the primitive that all points lie on, or -1. */
    private int on;

    private double x;
    private double y;
    private double z;
    private double radius;

    /** No points at first. */
    public SegmentEnds() {}

    /**
     * Removes all points.
     *
     * @param surface the id of a primitive that all points to come lie on and that no segment hits before its end: a flat one, or a convex
     *     one from outside; -1 if there is none
     */
    public void clear(int surface) {
        on = surface;
        for (int c = 0; c < 3; c++) {
            box[c] = Double.POSITIVE_INFINITY;
            box[c + 3] = Double.NEGATIVE_INFINITY;
        }
    }

    /** Lets further points lie on any primitive. */
    public void mix() {
        on = NONE;
    }

    /** Adds a point. */
    public void add(double px, double py, double pz) {
        widen(0, px);
        widen(1, py);
        widen(2, pz);
    }

    private void widen(int c, double value) {
        box[c] = Math.min(box[c], value);
        box[c + 3] = Math.max(box[c + 3], value);
    }

    /** Finds the ball around the points, of which there must be at least one. */
    public void finish() {
        x = (box[0] + box[3]) / 2;
        y = (box[1] + box[4]) / 2;
        z = (box[2] + box[5]) / 2;
        double dx = box[3] - x;
        double dy = box[4] - y;
        double dz = box[5] - z;
        size = 0;
        for (int c = 0; c < 3; c++) {
            size += Math.max(Math.abs(box[c]), Math.abs(box[c + 3]));
        }
        radius = Math.sqrt(dx * dx + dy * dy + dz * dz) * (1 + ERROR) + ERROR * size;
    }

    /** Whether all points lie on this primitive, so that no segment hits it before its end. */
    boolean lieOn(int id) {
        return id == on;
    }

    /** Sets the apex of the cone to the segments' common point. */
    public void seenFrom(double px, double py, double pz) {
        cone.set(x, y, z, radius, px, py, pz);
    }
}
