package enlightenment.geometry;

import enlightenment.math.Vec3;

/** Vertices in the sheared coordinates of a ray (Woop, Benthin and Wald 2013): every primitive rounds them alike. */
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

    static double clamp01(double v) {
        return v > 0 ? (v < 1 ? v : 1) : 0;
    }
}
