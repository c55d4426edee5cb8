package enlightenment.surroundings;

import enlightenment.color.Rgb;
import enlightenment.frame.Basis;
import enlightenment.math.Vec3;
import enlightenment.sampling.Warp;

/** A disk at infinity of the same radiance all over, such as the sun's. Immutable. */
public final class Sun {
    /** The unit vector to its centre. */
    public final double x;

    public final double y;
    public final double z;

    /** Its radiance, by band. */
    public final double r;

    public final double g;
    public final double b;

    /** The sine and cosine of half the angle that it is seen under. */
    public final double sine;

    public final double cosine;

    /** The solid angle that it is seen under. */
    public final double solidAngle;

    private final double oneMinusCosine;

    /** Half of that angle, in degrees. */
    private final double radius;

    /**
     * A disk.
     *
     * @param direction the unit vector to its centre
     * @param radius half of the angle that it is seen under, in degrees
     */
    Sun(Vec3 direction, double radius, Rgb radiance) {
        x = direction.x();
        y = direction.y();
        z = direction.z();
        this.radius = radius;
        r = radiance.r();
        g = radiance.g();
        b = radiance.b();
        double angle = StrictMath.toRadians(radius);
        double half = StrictMath.sin(angle / 2);
        oneMinusCosine = 2 * half * half;
        sine = StrictMath.sin(angle);
        cosine = 1 - oneMinusCosine;
        solidAngle = 2 * Math.PI * oneMinusCosine;
    }

    /**
     * The disk of a distant light.
     *
     * @param direction the direction in which its light travels, of any length but 0
     * @param angle that it is seen under, from edge to edge, in degrees: above 0, below 180
     * @param irradiance on a surface perpendicular to the direction
     */
    public static Sun distant(Vec3 direction, double angle, Rgb irradiance) {
        double sine = StrictMath.sin(StrictMath.toRadians(angle / 2));
        Vec3 toIt = Vec3.ZERO.minus(direction.normalized());
        return new Sun(toIt, angle / 2, irradiance.times(Rgb.gray(1 / (Math.PI * sine * sine))));
    }

    /** The integral of its radiance over the solid angle, sum of the bands. */
    public double power() {
        return (r + g + b) * solidAngle;
    }

    /** This disk with its radiance multiplied by a share of each band. */
    Sun filtered(Rgb share) {
        return new Sun(new Vec3(x, y, z), radius, share.times(new Rgb(r, g, b)));
    }

    /** The greatest band of its radiance. */
    public double max() {
        return Math.max(r, Math.max(g, b));
    }

    /** Whether a unit vector leads to the disk. */
    public boolean contains(double dx, double dy, double dz) {
        // The chord: near 1 a cosine has lost what counts.
        double ex = dx - x;
        double ey = dy - y;
        double ez = dz - z;
        return ex * ex + ey * ey + ez * ez <= 2 * oneMinusCosine;
    }

    /** The density per solid angle of {@link #sample}. */
    public double density() {
        return 1 / solidAngle;
    }

    /**
     * Samples a direction uniformly in the solid angle of the disk; {@link #density} is the density.
     *
     * @param u uniform in [0, 1)
     * @param v uniform in [0, 1), independent of u
     * @param out receives the unit vector towards the sun
     */
    public void sample(double u, double v, double[] out) {
        Warp.toDisk(u, v, out);
        Basis basis = new Basis();
        basis.around(x, y, z);
        double height = out[2] * oneMinusCosine;
        double spread = Math.sqrt(oneMinusCosine * (2 - height));
        double p = out[0] * spread;
        double q = out[1] * spread;
        double dx = Math.fma(p, basis.ax, Math.fma(q, basis.bx, x - height * x));
        double dy = Math.fma(p, basis.ay, Math.fma(q, basis.by, y - height * y));
        double dz = Math.fma(p, basis.az, Math.fma(q, basis.bz, z - height * z));
        double scale = 1 / Math.sqrt(dx * dx + dy * dy + dz * dz);
        out[0] = dx * scale;
        out[1] = dy * scale;
        out[2] = dz * scale;
    }

    /** Its irradiance on a surface that all of it shines on, from the whole cosine of the angle to its centre: for radiance 1. */
    public double irradiance(double cosineToCenter) {
        return Math.PI * sine * sine * cosineToCenter;
    }
}
