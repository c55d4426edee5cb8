package enlightenment.world.camera;

import enlightenment.frame.Bounds;
import enlightenment.math.Vec3;
import enlightenment.numeric.Scale;

/**
 * The set of origins of a camera's rays: a point or a parallelogram. Far fewer boxes overlap it than overlap its bounding box if it is
 * oblique. Immutable.
 */
public final class RayStarts {
    /** A generous bound of the roundings of a start, of the parallelogram, and of their distances from a box. */
    private static final double ERROR = Scale.gamma(64);

    /** A box around the parallelogram, doubled. */
    private final Bounds box;

    /** Perpendicular to the parallelogram up to rounding; zero if it has no area. Separation along any vector proves disjointness. */
    private final Vec3 normal;

    /** The position of the parallelogram's middle along the normal, and the extent of the doubled parallelogram from there. */
    private final double middle;

    private final double reach;

    /** By coordinate, a bound of the origins, and of the terms that they are sums of. */
    private final Vec3 size;

    /**
     * Makes the set {@code at + x right + y down} for x and y in 0..1.
     *
     * @param box around the set, doubled
     * @param size by coordinate: the sum of the absolute values of what origins are computed from
     */
    RayStarts(Bounds box, Vec3 at, Vec3 right, Vec3 down, Vec3 size) {
        this.box = box;
        this.size = size;
        boolean isPoint = right.maxAbs() == 0 || down.maxAbs() == 0;
        normal = isPoint ? Vec3.ZERO : right.normalized().cross(down.normalized());
        double toRight = normal.dot(right);
        double downwards = normal.dot(down);
        middle = normal.dot(at) + toRight / 2 + downwards / 2;
        reach = Math.abs(toRight) + Math.abs(downwards);
    }

    /** Whether a ray may start in a box; false is certain, roundings included. */
    public boolean mayLieIn(Bounds other) {
        if (!other.overlaps(box)) {
            return false;
        }
        Vec3 extent = other.extent();
        double largest = other.maxAbs();
        double wide = 0;
        double error = 0;
        for (int axis = 0; axis < 3; axis++) {
            double n = Math.abs(normal.component(axis));
            wide += n * extent.component(axis) / 2;
            error += n * (size.component(axis) + largest);
        }
        double distance = Math.abs(normal.dot(other.center()) - middle);
        // Products that underflow lose less than the least normal number.
        return !(distance > wide + reach + ERROR * error + Double.MIN_NORMAL);
    }
}
