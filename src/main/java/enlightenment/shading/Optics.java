package enlightenment.shading;

import enlightenment.primitive.Hit;
import enlightenment.primitive.Ray;

/** Reflection and refraction of rays. The outgoing ray starts at the hit, on the side that it leaves to. */
final class Optics {
    private Optics() {}

    /** Reflects the ray, with a direction of length 1; it stays on the side that it came from. */
    static void reflect(Ray ray, Hit hit) {
        double scale = 1 / Math.sqrt(ray.dd);
        double x = ray.dx * scale;
        double y = ray.dy * scale;
        double z = ray.dz * scale;
        double twice = 2 * (x * hit.nx + y * hit.ny + z * hit.nz);
        set(ray, hit, x - twice * hit.nx, y - twice * hit.ny, z - twice * hit.nz, hit.side);
    }

    /**
     * Refracts the ray by Snell's law, with a direction of length 1; it changes sides.
     *
     * @param eta index of refraction of the side that it comes from over that of the other
     * @return false for total internal reflection, which leaves the ray unchanged
     */
    static boolean refract(Ray ray, Hit hit, double eta) {
        double scale = 1 / Math.sqrt(ray.dd);
        double x = ray.dx * scale;
        double y = ray.dy * scale;
        double z = ray.dz * scale;
        double nx = hit.nx * hit.side;
        double ny = hit.ny * hit.side;
        double nz = hit.nz * hit.side;
        double cosIn = Math.min(Math.max(-(x * nx + y * ny + z * nz), 0), 1);
        // 1 − η²(1 − c²), written so that it is c² exactly where η is 1.
        double etaCos = eta * cosIn;
        double cos2Out = Math.fma(etaCos, etaCos, (1 - eta) * (1 + eta));
        if (!(cos2Out >= 0)) {
            return false;
        }
        double along = etaCos - Math.sqrt(cos2Out);
        set(
                ray,
                hit,
                Math.fma(along, nx, eta * x),
                Math.fma(along, ny, eta * y),
                Math.fma(along, nz, eta * z),
                -hit.side);
        return true;
    }

    /** Lets the ray pass straight through, to the other side. */
    static void pass(Ray ray, Hit hit) {
        ray.set(hit.px, hit.py, hit.pz, ray.dx, ray.dy, ray.dz, 0).from(hit.primitive, -hit.side);
    }

    private static void set(Ray ray, Hit hit, double x, double y, double z, int side) {
        double scale = 1 / Math.sqrt(x * x + y * y + z * z);
        ray.set(hit.px, hit.py, hit.pz, x * scale, y * scale, z * scale, 0).from(hit.primitive, side);
    }
}
