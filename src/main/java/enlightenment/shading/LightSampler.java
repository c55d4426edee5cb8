package enlightenment.shading;

import enlightenment.compiled.CompiledLight;
import enlightenment.compiled.LightCone;
import enlightenment.primitive.Ray;
import enlightenment.sampling.Warp;

/**
 * Samples points of a light as seen from a surface point: a sphere uniformly over its solid angle, a rectangle uniformly over
 * its area, a point as it is.
 */
final class LightSampler {
    private final double[] disk = new double[3];

    private CompiledLight light;
    private double px;
    private double py;
    private double pz;

    /** The cone around the light. */
    final LightCone cone = new LightCone();

    /** Two unit vectors that complete the cone's axis to an orthonormal basis. */
    private double ax;

    private double ay;
    private double az;
    private double bx;
    private double by;
    private double bz;
    private boolean basis;

    /** The normal in that basis: its component along the axis, the length of the rest, and the direction of the rest. */
    private double normalAlong;

    private double normalAcross;
    private double normalA;
    private double normalB;

    /** The direction to the last light point, of length 1. */
    double dx;

    double dy;
    double dz;

    /** The distance to the last light point. */
    double length;

    /** Sets the light, and the surface point that it is seen from. */
    void aim(CompiledLight target, double x, double y, double z) {
        light = target;
        px = x;
        py = y;
        pz = z;
        cone.aim(target, x, y, z);
        basis = false;
    }

    /** The light. */
    CompiledLight light() {
        return light;
    }

    /** Whether the surface point lies inside the light, which is then seen in every direction. */
    boolean surroundedBy() {
        return light.kind == CompiledLight.Kind.SPHERE && cone.inside;
    }

    /** Whether all light points are the same. */
    boolean isPoint() {
        return light.kind == CompiledLight.Kind.POINT;
    }

    /**
     * The exact mean of the cosine over the light's solid angle, if the whole light is above the horizon of the normal and the
     * mean has a closed form; NaN otherwise. Over the cone around w it is (n·w)(1 + cosθmax)/2.
     */
    double meanCosine(double nx, double ny, double nz) {
        if (light.kind == CompiledLight.Kind.RECTANGLE || surroundedBy()) {
            return Double.NaN;
        }
        double toCenter = nx * cone.wx + ny * cone.wy + nz * cone.wz;
        if (light.kind == CompiledLight.Kind.POINT) {
            return toCenter >= 0 ? toCenter : Double.NaN;
        }
        return toCenter >= cone.sine ? toCenter * (1 - cone.oneMinusCosine / 2) : Double.NaN;
    }

    /** Whether the whole light lies below the horizon of the normal, so that its cosine is 0 everywhere. */
    boolean isBelow(double nx, double ny, double nz) {
        if (surroundedBy()) {
            return false;
        }
        double toCenter = nx * cone.wx + ny * cone.wy + nz * cone.wz;
        if (light.kind == CompiledLight.Kind.SPHERE) {
            return toCenter <= -cone.sine;
        }
        return light.kind == CompiledLight.Kind.POINT ? toCenter <= 0 : isRectangleBelow(nx, ny, nz);
    }

    private boolean isRectangleBelow(double nx, double ny, double nz) {
        double corner = nx * (light.x - px) + ny * (light.y - py) + nz * (light.z - pz);
        double right = nx * light.right.x() + ny * light.right.y() + nz * light.right.z();
        double up = nx * light.up.x() + ny * light.up.y() + nz * light.up.z();
        return corner + Math.max(right, 0) + Math.max(up, 0) <= 0;
    }

    /** Sets direction and length to the light point for (u, v) in the unit square. */
    void sample(double u, double v) {
        if (light.kind == CompiledLight.Kind.POINT) {
            setDirection(cone.wx, cone.wy, cone.wz, cone.distance);
        } else if (light.kind == CompiledLight.Kind.RECTANGLE) {
            sampleRectangle(u, v);
        } else if (surroundedBy()) {
            sampleAround(u, v);
        } else {
            sampleCone(u, v);
        }
    }

    /** Prepares {@link #sampleByCosine} for a normal for which {@link #meanCosine} has a closed form. */
    void prepareByCosine(double nx, double ny, double nz) {
        if (light.kind == CompiledLight.Kind.POINT) {
            return;
        }
        if (!basis) {
            makeBasis();
        }
        double na = nx * ax + ny * ay + nz * az;
        double nb = nx * bx + ny * by + nz * bz;
        normalAlong = nx * cone.wx + ny * cone.wy + nz * cone.wz;
        normalAcross = Math.sqrt(na * na + nb * nb);
        normalA = normalAcross > 0 ? na / normalAcross : 1;
        normalB = normalAcross > 0 ? nb / normalAcross : 0;
    }

    /**
     * As {@link #sample}, but with a density proportional to the cosine of the direction with the normal.
     *
     * <p>Projected along the normal, directions of that density are uniform in an ellipse: its centre is cosθmax times the
     * axis, its semi-axes are sinθmax and sinθmax·(n·w). With (a, b) in the unit disk, the component of a direction along the
     * normal is c·cosθmax + δ, where δ is computed without cancellation, so that small lights keep their digits.
     */
    void sampleByCosine(double u, double v) {
        if (light.kind == CompiledLight.Kind.POINT) {
            sample(u, v);
            return;
        }
        Warp.toDisk(u, v, disk);
        mapDisk(disk[0], disk[1]);
    }

    /**
     * As {@link #sampleByCosine} for a position (p, q) in the unit disk itself, whose axes do not turn with the normal, so that
     * neighbouring surface points see the same part of the light at nearly the same position.
     */
    void sampleDisk(double p, double q) {
        mapDisk(Math.fma(p, normalA, q * normalB), Math.fma(q, normalA, -p * normalB));
    }

    private void mapDisk(double x, double y) {
        double a = normalAlong * x;
        double least = normalAlong * cone.cosine;
        double excess = cone.sine * Math.fma(2 * cone.cosine * normalAcross, a, cone.sine * (1 - a * a - y * y));
        double square = least * least + excess;
        double sum = square > 0 ? least + Math.sqrt(square) : least;
        double delta = sum > 0 ? excess / sum : 0;
        double p = Math.fma(normalAcross, delta, cone.sine * normalAlong * a);
        double q = cone.sine * y;
        double middle = Math.fma(cone.cosine, normalAcross, -cone.sine * a);
        double along = Math.fma(middle, normalAcross, (least + delta) * normalAlong);
        double s = p * normalA - q * normalB;
        double t = p * normalB + q * normalA;
        setOffset(along, s, t, s * s + t * t);
    }

    /** Sets the direction that has the component cos along the cone's axis, s and t across it, and sin2 = s² + t². */
    private void setOffset(double cos, double s, double t, double sin2) {
        double distance = cone.distance;
        double half2 = light.radius * light.radius - distance * distance * sin2;
        double half = half2 > 0 ? Math.sqrt(half2) : 0;
        setDirection(
                Math.fma(cos, cone.wx, Math.fma(s, ax, t * bx)),
                Math.fma(cos, cone.wy, Math.fma(s, ay, t * by)),
                Math.fma(cos, cone.wz, Math.fma(s, az, t * bz)),
                distance * cos - half);
    }

    /** Sets a shadow ray from a surface point to the last light point, which is at t = {@link #length}. */
    void ray(Ray ray, double x, double y, double z) {
        ray.set(x, y, z, dx, dy, dz, 0);
    }

    private void setDirection(double x, double y, double z, double len) {
        dx = x;
        dy = y;
        dz = z;
        length = len;
    }

    private void sampleRectangle(double u, double v) {
        double x = Math.fma(u, light.right.x(), Math.fma(v, light.up.x(), light.x - px));
        double y = Math.fma(u, light.right.y(), Math.fma(v, light.up.y(), light.y - py));
        double z = Math.fma(u, light.right.z(), Math.fma(v, light.up.z(), light.z - pz));
        double len = Math.sqrt(x * x + y * y + z * z);
        double inverse = len == 0 ? 0 : 1 / len;
        setDirection(x * inverse, y * inverse, z * inverse, len);
    }

    private void sampleCone(double u, double v) {
        if (!basis) {
            makeBasis();
        }
        Warp.toDisk(u, v, disk);
        double down = disk[2] * cone.oneMinusCosine;
        double cos = 1 - down;
        // sinθ over the distance from the disk's centre, so that the disk's x and y need not be divided by it.
        double spread = Math.sqrt(cone.oneMinusCosine * (2 - down));
        double s = disk[0] * spread;
        double t = disk[1] * spread;
        setOffset(cos, s, t, down * (2 - down));
    }

    /** Uniform over all directions: the disk mapped to the sphere by Lambert's equal-area projection. */
    private void sampleAround(double u, double v) {
        Warp.toDisk(u, v, disk);
        double q = disk[2];
        double spread = 2 * Math.sqrt(Math.max(1 - q, 0));
        double x = disk[0] * spread;
        double y = disk[1] * spread;
        double z = 1 - 2 * q;
        double distance = cone.distance;
        double along = (x * cone.wx + y * cone.wy + z * cone.wz) * distance;
        double half = Math.sqrt(Math.max(light.radius * light.radius - distance * distance + along * along, 0));
        setDirection(x, y, z, along + half);
    }

    /** Duff et al., "Building an orthonormal basis, revisited", JCGT 2017. */
    private void makeBasis() {
        double sign = Math.copySign(1.0, cone.wz);
        double p = -1 / (sign + cone.wz);
        double q = cone.wx * cone.wy * p;
        ax = 1 + sign * cone.wx * cone.wx * p;
        ay = sign * q;
        az = -sign * cone.wx;
        bx = q;
        by = sign + cone.wy * cone.wy * p;
        bz = -cone.wy;
        basis = true;
    }
}
