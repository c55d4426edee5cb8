package enlightenment.frame;

/**
 * Two unit vectors a and b that complete a third one to an orthonormal basis: T. Duff et al., "Building an orthonormal basis,
 * revisited", JCGT 2017. A mutable work object, one per thread.
 */
public final class Basis {
    public double ax;
    public double ay;
    public double az;
    public double bx;
    public double by;
    public double bz;

    /** A basis to be {@link #around set} before use. */
    public Basis() {}

    /** Completes the unit vector (x, y, z). */
    public void around(double x, double y, double z) {
        double sign = Math.copySign(1.0, z);
        double p = -1 / (sign + z);
        double q = x * y * p;
        ax = 1 + sign * x * x * p;
        ay = sign * q;
        az = -sign * x;
        bx = q;
        by = sign + y * y * p;
        bz = -y;
    }
}
