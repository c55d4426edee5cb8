package enlightenment.primitive;

import enlightenment.math.Vec3;
import enlightenment.numeric.EdgeFunctions;
import enlightenment.numeric.Products;

/**
 * Vertices in the sheared coordinates of a ray (Woop, Benthin and Wald, "Watertight ray/triangle intersection", JCGT
 * 2013): every primitive rounds them alike, and the signs of edge functions are exact for the rounded vertices
 * ({@link Products#difference} keeps signs). So what a ray meets is decided in one planar projection that all primitives
 * share, and closed surfaces of triangles cover it without gaps.
 */
final class Watertight {
    private Watertight() {}

    /** First sheared coordinate of a vertex; {@link Ray#shear} has been called. */
    static double x(Ray ray, Vec3 v) {
        return Math.fma(-ray.shearX, v.component(ray.kz) - ray.o(ray.kz), v.component(ray.kx) - ray.o(ray.kx));
    }

    /** Second sheared coordinate of a vertex. */
    static double y(Ray ray, Vec3 v) {
        return Math.fma(-ray.shearY, v.component(ray.kz) - ray.o(ray.kz), v.component(ray.ky) - ray.o(ray.ky));
    }

    /** The ray parameter of a vertex, measured along the main axis of the direction. */
    private static double parameter(Ray ray, Vec3 v) {
        return (v.component(ray.kz) - ray.o(ray.kz)) / ray.d(ray.kz);
    }

    /**
     * Makes the distance to a triangle's plane agree with the edge functions.
     *
     * <p>The two are rounded differently. That is harmless unless the ray is almost parallel to the plane: then the edge
     * functions may say that the ray meets this triangle (and not its neighbour) while the plane says that it does so behind
     * the origin or beyond the triangle, and the ray would slip through the edge between the two. In that case the distance is
     * interpolated between the vertices with the edge functions as weights, which always agrees with them.
     *
     * @param t distance to the plane
     * @param e0 edge function of a and b
     * @param e1 edge function of b and c
     * @param e2 edge function of c and a
     * @return the distance, or {@link Primitive#MISS} if the crossing lies before {@link Ray#tMin}
     */
    static double settle(Ray ray, double t, Vec3 a, Vec3 b, Vec3 c, double e0, double e1, double e2) {
        double ta = parameter(ray, a);
        double tb = parameter(ray, b);
        double tc = parameter(ray, c);
        double lo = ta < tb ? ta : tb;
        lo = tc < lo ? tc : lo;
        double hi = ta > tb ? ta : tb;
        hi = tc > hi ? tc : hi;
        double m = Math.max(distance(ray, a), Math.max(distance(ray, b), distance(ray, c)));
        // Away from the edges the ray hits the triangle for any rounding, and only the plane's distance is accurate.
        double edge = Math.min(Math.abs(e0), Math.min(Math.abs(e1), Math.abs(e2)));
        boolean central = edge > EdgeFunctions.ERROR * m * m;
        if (central && (t >= lo && t <= hi || t < ray.tMin && lo < ray.tMin)) {
            return t >= ray.tMin ? t : Primitive.MISS;
        }
        double between = (e1 * ta + e2 * tb + e0 * tc) / (e0 + e1 + e2);
        between = between < lo ? lo : between > hi ? hi : between;
        boolean agree = Math.abs(t - between) * Math.abs(ray.d(ray.kz)) <= EdgeFunctions.ERROR * m;
        double settled = agree ? t : between;
        return settled >= ray.tMin ? settled : Primitive.MISS;
    }

    /** The largest difference of a coordinate between the ray's origin and a vertex. */
    private static double distance(Ray ray, Vec3 v) {
        double x = Math.abs(v.x() - ray.ox);
        double y = Math.abs(v.y() - ray.oy);
        return Math.max(x, Math.max(y, Math.abs(v.z() - ray.oz)));
    }

    /** v clamped to 0..1; 0 for NaN. */
    static double clamp01(double v) {
        return v > 0 ? (v < 1 ? v : 1) : 0;
    }
}
