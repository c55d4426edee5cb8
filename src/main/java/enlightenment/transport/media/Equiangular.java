package enlightenment.transport.media;

import enlightenment.math.Vec3;
import enlightenment.primitive.Ray;

/**
 * Samples points of a segment with a density proportional to the inverse squared distance from a given point: equal angles, as seen from
 * there, have equal probabilities (C. Kulla and M. Fajardo, "Importance sampling techniques for path tracing in participating media", 2012,
 * section 4.1). A mutable work object, one per thread.
 */
public final class Equiangular {
    private double fromX;
    private double fromY;
    private double fromZ;

    /** The squared offset by which the given point is moved away from the plane of point and segment; bounds the density. */
    private double aside;

    private double length;

    /** The position of the segment's start along the ray, from the foot of the perpendicular, in the frame. */
    private double start;

    /** The distance of the line from the point, and its square. */
    private double height;

    private double square;

    /** The angle between the segment's ends, as seen from the point. */
    private double angle;

    /** The distance of the sampled point from the segment's start, in the frame. */
    public double distance;

    /** The density of the sampled point, per length of the frame. */
    public double density;

    /**
     * @param from the point that segments are seen from, in the frame
     */
    public Equiangular(Vec3 from) {
        see(from.x(), from.y(), from.z(), 0);
    }

    /**
     * Sets the point that segments are seen from.
     *
     * @param radius distances are measured from a point that is moved this far out of the plane of point and segment, which bounds the
     *     density
     */
    public void see(double x, double y, double z, double radius) {
        fromX = x;
        fromY = y;
        fromZ = z;
        aside = radius * radius;
    }

    /**
     * Samples a point of a ray.
     *
     * @param length of the segment, from the ray's start, in the frame; may be infinite
     * @param u uniform in 0..1
     * @return false where rounding leaves no angle: a very short segment, or one whose line nearly meets the point
     */
    public boolean sample(Ray ray, double length, double u) {
        place(ray);
        aim(length);
        return sample(u);
    }

    /** Sets the length of the segment, on the ray of the last {@link #place}, from its start. */
    public void aim(double length) {
        this.length = length;
        height = Math.sqrt(square);
        // The angle as that of the vectors to both ends: nothing cancels however far away they are.
        angle = length == Double.POSITIVE_INFINITY
                ? StrictMath.atan2(height, start)
                : StrictMath.atan2(height * length, Math.fma(start, start + length, square));
    }

    /** Sets the ray that segments lie on. */
    public void place(Ray ray) {
        double scale = 1 / Math.sqrt(ray.dd);
        double dx = ray.dx * scale;
        double dy = ray.dy * scale;
        double dz = ray.dz * scale;
        double x = fromX - Math.fma(ray.tMin, ray.dx, ray.ox);
        double y = fromY - Math.fma(ray.tMin, ray.dy, ray.oy);
        double z = fromZ - Math.fma(ray.tMin, ray.dz, ray.oz);
        start = -Math.fma(x, dx, Math.fma(y, dy, z * dz));
        double px = Math.fma(start, dx, x);
        double py = Math.fma(start, dy, y);
        double pz = Math.fma(start, dz, z);
        square = px * px + py * py + pz * pz + aside;
    }

    /** Samples a point of the segment that {@link #aim} has set, as {@link #sample(Ray, double, double)} does. */
    public boolean sample(double u) {
        double sine = StrictMath.sin(u * angle);
        double cosine = StrictMath.cos(u * angle);
        double t = sine * Math.fma(start, start, square) / (height * cosine - start * sine);
        distance = Math.min(Math.max(t, 0), Math.min(length, Double.MAX_VALUE));
        density = density(distance);
        return density > 0 && density < Double.POSITIVE_INFINITY;
    }

    /** The density, per length of the frame, of sampling this point of the segment; NaN or not positive if none can be sampled. */
    public double density(double at) {
        double along = start + at;
        return height / (angle * Math.fma(along, along, square));
    }

    /** The integral of the inverse squared distance over the segment, per length of the frame. */
    public double integral() {
        return angle / height;
    }

    /** The squared distance of the given point from the start of the ray. */
    public double squareAtStart() {
        return Math.fma(start, start, square);
    }

    /** The least squared distance of the given point from a segment of the ray, of this length. */
    public double leastSquare(double length) {
        double along = start >= 0 ? start : Math.min(start + length, 0);
        return Math.fma(along, along, square);
    }
}
