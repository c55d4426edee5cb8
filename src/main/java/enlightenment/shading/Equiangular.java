package enlightenment.shading;

import enlightenment.math.Vec3;
import enlightenment.primitive.Ray;

/**
 * Samples points of a segment with a density in proportion to the inverse square of their distance from a given point: equal angles, seen
 * from there, have equal probabilities (C. Kulla and M. Fajardo, "Importance sampling techniques for path tracing in participating media",
 * 2012, section 4.1). A mutable work object, one per thread.
 */
final class Equiangular {
    private final Vec3 from;

    /** How far along the segment the point lies, in lengths of the frame. */
    double distance;

    /** The probability density of that, per length of the frame. */
    double density;

    /** @param from the point that the segments are seen from, in the frame */
    Equiangular(Vec3 from) {
        this.from = from;
    }

    /**
     * Samples a point of a ray.
     *
     * @param length of the segment, from where the ray starts, in lengths of the frame; may be infinite
     * @param u uniform in 0..1
     * @return whether there is one: not where the segment is so short, or the point that it is seen from so near to its line, that rounding
     *     leaves no angle
     */
    boolean sample(Ray ray, double length, double u) {
        double scale = 1 / Math.sqrt(ray.dd);
        double dx = ray.dx * scale;
        double dy = ray.dy * scale;
        double dz = ray.dz * scale;
        double x = from.x() - Math.fma(ray.tMin, ray.dx, ray.ox);
        double y = from.y() - Math.fma(ray.tMin, ray.dy, ray.oy);
        double z = from.z() - Math.fma(ray.tMin, ray.dz, ray.oz);
        // Of the start, measured from the foot of the perpendicular: a; of the line, from the point: h.
        double a = -Math.fma(x, dx, Math.fma(y, dy, z * dz));
        double px = Math.fma(a, dx, x);
        double py = Math.fma(a, dy, y);
        double pz = Math.fma(a, dz, z);
        double hh = px * px + py * py + pz * pz;
        double h = Math.sqrt(hh);
        // The angle as that of the vectors to both ends: nothing cancels however far away they are.
        double angle = length == Double.POSITIVE_INFINITY
                ? StrictMath.atan2(h, a)
                : StrictMath.atan2(h * length, Math.fma(a, a + length, hh));
        double sine = StrictMath.sin(u * angle);
        double cosine = StrictMath.cos(u * angle);
        double t = sine * Math.fma(a, a, hh) / (h * cosine - a * sine);
        distance = Math.min(Math.max(t, 0), Math.min(length, Double.MAX_VALUE));
        double along = a + distance;
        density = h / (angle * Math.fma(along, along, hh));
        return density > 0 && density < Double.POSITIVE_INFINITY;
    }
}
