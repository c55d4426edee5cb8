package enlightenment.emitter;

import enlightenment.numeric.Angles;

/**
 * A triangle as it is seen from a point, sampled evenly over its solid angle: J. Arvo, "Stratified sampling of spherical triangles",
 * SIGGRAPH 1995. For triangles that cover some thousandths of a steradian or more. A mutable work object.
 */
final class SphericalTriangle {
    /** The last direction chosen, of length 1. */
    double x;

    double y;
    double z;

    /** The solid angle: A. van Oosterom and J. Strackee, "The solid angle of a plane triangle", 1983; accurate at every distance. */
    double solidAngle;

    private final double[] a = new double[3];
    private final double[] b = new double[3];
    private final double[] c = new double[3];

    /** The unit vector across a towards c. */
    private final double[] acrossA = new double[3];

    private double alpha;
    private double cosAlpha;
    private double sinAlpha;
    private double cosAb;

    /** Sets the corner k to the offset (x, y, z) from where it is seen, whose length is returned. */
    double corner(int k, double x, double y, double z) {
        double[] corner = k == 0 ? a : k == 1 ? b : c;
        double len = Math.sqrt(x * x + y * y + z * z);
        double inverse = len > 0 ? 1 / len : 0;
        corner[0] = x * inverse;
        corner[1] = y * inverse;
        corner[2] = z * inverse;
        return len;
    }

    /** @param determinant the absolute value of that of the unit corners: height over the plane · 2 area / the product of the distances */
    void measure(double determinant) {
        double denominator = 1 + dot(a, b) + dot(b, c) + dot(c, a);
        solidAngle = 2 * Angles.atan2(determinant, denominator);
    }

    /** Prepares {@link #choose}. */
    void prepare() {
        cosAb = dot(a, b);
        double ca = dot(c, a);
        double towardsB = 0;
        double square = 0;
        for (int k = 0; k < 3; k++) {
            acrossA[k] = c[k] - ca * a[k];
            double other = b[k] - cosAb * a[k];
            towardsB += acrossA[k] * other;
            square += acrossA[k] * acrossA[k];
        }
        double inverse = square > 0 ? 1 / Math.sqrt(square) : 0;
        for (int k = 0; k < 3; k++) {
            acrossA[k] *= inverse;
        }
        double sine = (b[1] * c[2] - b[2] * c[1]) * a[0]
                + (b[2] * c[0] - b[0] * c[2]) * a[1]
                + (b[0] * c[1] - b[1] * c[0]) * a[2];
        alpha = Angles.atan2(Math.abs(sine), towardsB);
        sinAlpha = StrictMath.sin(alpha);
        cosAlpha = StrictMath.cos(alpha);
    }

    /** Chooses the direction for (u, v) in the unit square. */
    void choose(double u, double v) {
        double angle = Math.fma(u, solidAngle, -alpha);
        double s = StrictMath.sin(angle);
        double t = StrictMath.cos(angle);
        double p = t - cosAlpha;
        double r = Math.fma(sinAlpha, cosAb, s);
        double q = ((r * t - p * s) * cosAlpha - r) / ((r * s + p * t) * sinAlpha);
        // At u = 0 both may vanish: that is the corner c's side.
        q = q >= -1 && q <= 1 ? q : q > 1 ? 1 : q < -1 ? -1 : dot(c, a);
        double qq = Math.sqrt((1 - q) * (1 + q));
        double cx = Math.fma(q, a[0], qq * acrossA[0]);
        double cy = Math.fma(q, a[1], qq * acrossA[1]);
        double cz = Math.fma(q, a[2], qq * acrossA[2]);
        double along = cx * b[0] + cy * b[1] + cz * b[2];
        double down = v * Math.max(1 - along, 0);
        double w = 1 - down;
        cx -= along * b[0];
        cy -= along * b[1];
        cz -= along * b[2];
        double length = Math.sqrt(cx * cx + cy * cy + cz * cz);
        double across = length > 0 ? Math.sqrt(down * (2 - down)) / length : 0;
        x = Math.fma(w, b[0], across * cx);
        y = Math.fma(w, b[1], across * cy);
        z = Math.fma(w, b[2], across * cz);
    }

    private static double dot(double[] p, double[] q) {
        return p[0] * q[0] + p[1] * q[1] + p[2] * q[2];
    }
}
