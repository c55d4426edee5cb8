package enlightenment.emitter;

import enlightenment.numeric.Angles;
import enlightenment.numeric.Arcs;

/**
 * A triangle as it is seen from a point, sampled evenly over its solid angle as in J. Arvo, "Stratified sampling of spherical triangles",
 * SIGGRAPH 1995, but without differences that cancel where corners are nearly opposite: at grazing angles, and next to needles. For
 * triangles that cover some thousandths of a steradian or more. A mutable work object.
 *
 * <p>Half the solid angle Ω is the angle of the complex number (a + b)·(a + c) + i det(a, b, c) of the unit corners, whichever comes
 * first (A. van Oosterom and J. Strackee, "The solid angle of a plane triangle", 1983, whose 1 + a·b + b·c + c·a is that product). With −a
 * for a it is that of the other triangle that the planes at a cut off, κ = α − Ω/2. A point d of the side a c leaves u Ω next to the
 * side a b where
 *
 * <p>tan(ad/2) tan(ab/2) = sin(uΩ/2)/sin(κ + (1 − u)Ω/2).
 *
 * <p>What is left are the roundings of the corners: those of a receiver that is moved by a few units in the last place of its farthest
 * corner's distance.
 */
final class SphericalTriangle {
    /** The last sampled direction, of length 1. */
    double x;

    double y;
    double z;

    /** The solid angle; valid after {@link #measure}. */
    double solidAngle;

    private final double[] a = new double[3];
    private final double[] b = new double[3];
    private final double[] c = new double[3];

    /** The unit vector perpendicular to a, towards c. */
    private final double[] acrossA = new double[3];

    /** The determinant of the unit corners, not negative. */
    private double determinant;

    private double kappa;

    /** Twice the sine and the cosine of half the side a b. */
    private double chord;

    private double sum;

    /** Sets corner k to the offset (x, y, z) from the viewer; returns its length. */
    double corner(int k, double x, double y, double z) {
        double[] corner = k == 0 ? a : k == 1 ? b : c;
        double len = Math.sqrt(x * x + y * y + z * z);
        double inverse = len > 0 ? 1 / len : 0;
        corner[0] = x * inverse;
        corner[1] = y * inverse;
        corner[2] = z * inverse;
        return len;
    }

    /**
     * Computes the solid angle, after all corners are set.
     *
     * @param determinant of the unit corners, absolute: height over the plane · 2 area / the product of the distances
     */
    void measure(double determinant) {
        this.determinant = determinant;
        solidAngle = 2 * Angles.atan2(determinant, denominator(1));
    }

    /**
     * 1 + s a·b + b·c + s c·a as the product of two sums of corners. Its error is some roundings of these, and they are no longer than
     * they need be if the third sum is the longest.
     *
     * @param s the sign of a: −1 for the triangle that has −a instead
     */
    private double denominator(double s) {
        double ab = s * dot(a, b);
        double ca = s * dot(c, a);
        double bc = dot(b, c);
        if (bc >= ab && bc >= ca) {
            return dotOfSums(a, b, s, c, s);
        }
        return ca >= ab ? dotOfSums(b, a, s, c, 1) : dotOfSums(c, a, s, b, 1);
    }

    /** (p + s q)·(p + t r). */
    private static double dotOfSums(double[] p, double[] q, double s, double[] r, double t) {
        double dot = 0;
        for (int k = 0; k < 3; k++) {
            dot = Math.fma(Math.fma(s, q[k], p[k]), Math.fma(t, r[k], p[k]), dot);
        }
        return dot;
    }

    /** Prepares {@link #choose}; call after {@link #measure}. */
    void prepare() {
        kappa = Angles.atan2(determinant, denominator(-1));
        chord = Math.sqrt(dotOfSums(a, b, -1, b, -1));
        sum = Math.sqrt(dotOfSums(a, b, 1, b, 1));
        double ca = dot(c, a);
        for (int k = 0; k < 3; k++) {
            acrossA[k] = c[k] - ca * a[k];
        }
        double square = dot(acrossA, acrossA);
        double inverse = square > 0 ? 1 / Math.sqrt(square) : 0;
        for (int k = 0; k < 3; k++) {
            acrossA[k] *= inverse;
        }
    }

    /** Samples the direction for (u, v) in the unit square. */
    void choose(double u, double v) {
        double half = 0.5 * solidAngle;
        // tan(ad/2) is n/m.
        double n = sum * Arcs.sine(u * half);
        double m = chord * Arcs.sine(Math.fma(1 - u, half, kappa));
        double square = n * n + m * m;
        double inverse = square > 0 ? 1 / square : 0;
        double cosine = (m - n) * (m + n) * inverse;
        double sine = 2 * n * m * inverse;
        double dx = Math.fma(cosine, a[0], sine * acrossA[0]);
        double dy = Math.fma(cosine, a[1], sine * acrossA[1]);
        double dz = Math.fma(cosine, a[2], sine * acrossA[2]);
        // 1 - b·d and 1 + b·d, then the part of the former that the arc from b has where it is cut.
        double apart = 0.5 * square(dx - b[0], dy - b[1], dz - b[2]);
        double opposite = 0.5 * square(dx + b[0], dy + b[1], dz + b[2]);
        double down = v * apart;
        double along = 1 - apart;
        dx -= along * b[0];
        dy -= along * b[1];
        dz -= along * b[2];
        double length = Math.sqrt(square(dx, dy, dz));
        double across = length > 0 ? Math.sqrt(down * Math.fma(1 - v, apart, opposite)) / length : 0;
        double w = 1 - down;
        x = Math.fma(w, b[0], across * dx);
        y = Math.fma(w, b[1], across * dy);
        z = Math.fma(w, b[2], across * dz);
    }

    private static double square(double x, double y, double z) {
        return x * x + y * y + z * z;
    }

    private static double dot(double[] p, double[] q) {
        return p[0] * q[0] + p[1] * q[1] + p[2] * q[2];
    }
}
