package enlightenment.transport.media;

import enlightenment.math.Vec3;
import enlightenment.primitive.Ray;

/**
 * Samples points of a segment with a density in proportion to the inverse square of their distance from a given point: equal angles, seen
 * from there, have equal probabilities (C. Kulla and M. Fajardo, "Importance sampling techniques for path tracing in participating media",
 * 2012, section 4.1). A mutable work object, one per thread.
 */
public final class Equiangular {
    private double fromX;
    private double fromY;
    private double fromZ;

    /** How far aside of the point its place is taken, squared. */
    private double aside;

    private double length;

    /** Of the segment's start, measured along the ray from the foot of the perpendicular. */
    private double start;

    /** Of the line, from the point; and squared. */
    private double height;

    private double square;

    /** Between the segment's ends, as seen from the point. */
    private double angle;

    /** How far along the segment the point lies, in lengths of the frame. */
    public double distance;

    /** The probability density of that, per length of the frame. */
    public double density;

    /** @param from the point that the segments are seen from, in the frame */
    public Equiangular(Vec3 from) {
        see(from.x(), from.y(), from.z(), 0);
    }

    /**
     * Sets the point that the segments are seen from.
     *
     * @param radius distances from it are those from a place that lies so far aside of the plane of point and segment: no density grows
     *     beyond what that leaves
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
     * @param length of the segment, from where the ray starts, in lengths of the frame; may be infinite
     * @param u uniform in 0..1
     * @return whether there is one: not where the segment is so short, or the point that it is seen from so near to its line, that rounding
     *     leaves no angle
     */
    public boolean sample(Ray ray, double length, double u) {
        place(ray);
        aim(length);
        return sample(u);
    }

    /** Looks at a segment of the ray that was placed, from where that starts. */
    public void aim(double length) {
        this.length = length;
        height = Math.sqrt(square);
        // The angle as that of the vectors to both ends: nothing cancels however far away they are.
        angle = length == Double.POSITIVE_INFINITY
                ? StrictMath.atan2(height, start)
                : StrictMath.atan2(height * length, Math.fma(start, start + length, square));
    }

    /** Sees where a ray is. */
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

    /** Samples a point of the segment that was looked at, as {@link #sample(Ray, double, double)} does. */
    public boolean sample(double u) {
        double sine = StrictMath.sin(u * angle);
        double cosine = StrictMath.cos(u * angle);
        double t = sine * Math.fma(start, start, square) / (height * cosine - start * sine);
        distance = Math.min(Math.max(t, 0), Math.min(length, Double.MAX_VALUE));
        density = density(distance);
        return density > 0 && density < Double.POSITIVE_INFINITY;
    }

    /** The density with which this point of the segment is sampled; not a positive number if there is none. */
    public double density(double at) {
        double along = start + at;
        return height / (angle * Math.fma(along, along, square));
    }

    /** The integral over the segment of the inverse square of the distance. */
    public double integral() {
        return angle / height;
    }

    /** The squared distance from the start of the ray that was placed. */
    public double squareAtStart() {
        return Math.fma(start, start, square);
    }

    /** The least squared distance from a segment of the ray that was placed. */
    public double leastSquare(double length) {
        double along = start >= 0 ? start : Math.min(start + length, 0);
        return Math.fma(along, along, square);
    }
}
