package enlightenment.shading;

import enlightenment.compiled.CompiledLight;
import enlightenment.compiled.LightCone;
import enlightenment.primitive.Ray;
import enlightenment.sampling.Warp;

/**
 * Chooses light points as seen from a surface point, well distributed over the part of the light that faces it: a sphere
 * uniformly over the solid angle that it fills, a rectangle uniformly over its area, a point as it is.
 */
final class LightSampler {
    private final double[] disk = new double[3];

    private CompiledLight light;
    private double px;
    private double py;
    private double pz;

    /** How the light is seen. */
    final LightCone cone = new LightCone();

    /** Two directions that make a basis with the cone's axis. */
    private double ax;

    private double ay;
    private double az;
    private double bx;
    private double by;
    private double bz;
    private boolean basis;

    /** The normal in that basis: its component along the axis, the length of the rest, and that rest's direction. */
    private double normalAlong;

    private double normalAcross;
    private double normalA;
    private double normalB;

    /** The last direction: of length 1. */
    double dx;

    double dy;
    double dz;

    /** How far the last light point is. */
    double length;

    /** Looks at a light from a surface point. */
    void aim(CompiledLight target, double x, double y, double z) {
        light = target;
        px = x;
        py = y;
        pz = z;
        cone.aim(target, x, y, z);
        basis = false;
    }

    /** The light that is looked at. */
    CompiledLight light() {
        return light;
    }

    /** Whether the surface point lies inside the light: then the light is seen in every direction. */
    boolean surroundedBy() {
        return light.kind == CompiledLight.Kind.SPHERE && cone.inside;
    }

    /** Whether one light point is as good as many. */
    boolean isPoint() {
        return light.kind == CompiledLight.Kind.POINT;
    }

    /**
     * The exact mean of the cosine over all light points, if the whole light is above the horizon of the normal and the
     * mean has a closed form; NaN otherwise. Over the cone around w it is (n·w)(1 + cosθmax)/2.
     */
    double meanCosine(double nx, double ny, double nz) {
        if (light.kind == CompiledLight.Kind.RECTANGLE || surroundedBy()) {
            return Double.NaN;
        }
        double toMiddle = nx * cone.wx + ny * cone.wy + nz * cone.wz;
        if (light.kind == CompiledLight.Kind.POINT) {
            return toMiddle >= 0 ? toMiddle : Double.NaN;
        }
        return toMiddle >= cone.sine ? toMiddle * (1 - cone.oneMinusCosine / 2) : Double.NaN;
    }

    /** Whether the whole light lies below the horizon of the normal, so that its cosine is 0 everywhere. */
    boolean isBelow(double nx, double ny, double nz) {
        if (surroundedBy()) {
            return false;
        }
        double toMiddle = nx * cone.wx + ny * cone.wy + nz * cone.wz;
        if (light.kind == CompiledLight.Kind.SPHERE) {
            return toMiddle <= -cone.sine;
        }
        return light.kind == CompiledLight.Kind.POINT ? toMiddle <= 0 : isRectangleBelow(nx, ny, nz);
    }

    private boolean isRectangleBelow(double nx, double ny, double nz) {
        double corner = nx * (light.x - px) + ny * (light.y - py) + nz * (light.z - pz);
        double right = nx * light.right.x() + ny * light.right.y() + nz * light.right.z();
        double up = nx * light.up.x() + ny * light.up.y() + nz * light.up.z();
        return corner + Math.max(right, 0) + Math.max(up, 0) <= 0;
    }

    /** Chooses the light point for (u, v) in the unit square: sets direction and length. */
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

    /**
     * Prepares {@link #sampleByCosine} for a normal for which {@link #meanCosine} is known.
     */
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
     * As {@link #sample}, but the density of the directions is proportional to their cosine with the normal.
     *
     * <p>Seen along the normal, the cone's directions fill an ellipse evenly if they have that density: its middle is
     * cosθmax times the axis, its half axes are sinθmax and sinθmax·(n·w). With (a, b) in the unit disk, what a direction
     * has along the normal is c·cosθmax + δ, where δ is written without a difference of like numbers, so that small lights
     * keep their digits.
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
     * As {@link #sampleByCosine} for the place (p, q) in the unit disk itself, whose axes stay where they are when the
     * normal turns, so that neighbouring surface points see the same part of the light at nearly the same place.
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

    /** Sets a shadow ray to the last light point: it starts on the given surface and ends at {@link #length}. */
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
        // sinθ / (distance from the disk's middle), so that the disk's x and y need no division by it.
        double spread = Math.sqrt(cone.oneMinusCosine * (2 - down));
        double s = disk[0] * spread;
        double t = disk[1] * spread;
        setOffset(cos, s, t, down * (2 - down));
    }

    /** Every direction alike: the disk wrapped over the sphere by the equal-area (Lambert) projection. */
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
