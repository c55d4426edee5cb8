package enlightenment.emitter;

import enlightenment.frame.BallCone;
import enlightenment.numeric.Angles;

/**
 * Irradiance of an unoccluded ball of radiance 1, whole or cut by the horizon (J. M. Snyder, "Area light sources for real-time graphics",
 * 1996), rearranged so that nothing cancels far away or where the ball touches the horizon.
 *
 * <p>With s, c the sine and cosine of the cone's half angle and k the cosine between normal and axis: π·k·s² where k ≥ s; for |k| &lt; s,
 * with T = √(s² − k²), A = atan2(T, −ck) and z = T/c, it is s²·k·A + s²·z − (z − atan z). For a far ball the last bracket is a series. If
 * little is above the horizon the terms cancel to the fifth order; with p = sin A = T/(s·σ), σ² = 1 − k², and g(p) = p − √(1 − p²)·asin p =
 * p³/3 + 2p⁵/15 + 8p⁷/105 + …, the same is (σ/c)·(s³·g(p) − g(sp)), of which the cubic terms vanish and all others are positive.
 */
final class SphereIrradiance {
    /** Below this the series in p is used; p² = 1/4 loses 2 bits a term. */
    private static final double LITTLE = 0.5;

    private static final double SERIES_TANGENT = 0.25;
    private static final int TERMS = 26;

    private SphereIrradiance() {}

    /** The irradiance of a receiver with this unit normal at the cone's apex, outside of the ball. */
    static double of(BallCone cone, double nx, double ny, double nz) {
        double k = nx * cone.wx + ny * cone.wy + nz * cone.wz;
        double s = cone.sine;
        if (k >= s) {
            return Math.PI * k * s * s;
        }
        return k <= -s ? 0 : cut(s, cone.cosine, k);
    }

    /** The irradiance where the horizon cuts the ball: |k| &lt; s. */
    static double cut(double s, double c, double k) {
        double t = Math.sqrt((s - k) * (s + k));
        double across = Math.sqrt((1 - k) * (1 + k));
        double p = t / (s * across);
        if (k < 0 && p < LITTLE) {
            return little(s, c, p) * across;
        }
        double slice = s * s * k * Angles.atan2(t, -c * k);
        if (t < SERIES_TANGENT * c) {
            double z = t / c;
            return slice + z * (s * s - excess(z));
        }
        return slice + (Angles.atan2(t, c) - c * t);
    }

    /** (z − atan z)/z = z²/3 − z⁴/5 + … for z below 1/4; the first omitted term is below 2^-57. */
    private static double excess(double z) {
        double q = z * z;
        double sum = 0;
        for (int n = 27; n >= 3; n -= 2) {
            sum = Math.fma(-q, sum, 1.0 / n);
        }
        return q * sum;
    }

    /**
     * s³·g(p) − g(sp), over c: s³·c·p⁵·Σ b(j)·p^2j·(1 + s² + … + s^2j), b(0) = 2/15, b(j)/b(j − 1) = (2j + 2)/(2j + 5).
     */
    private static double little(double s, double c, double p) {
        double q = p * p;
        double square = s * s;
        double sum = 0;
        double term = 2.0 / 15;
        double powers = 1;
        for (int j = 0; j < TERMS; j++) {
            sum = Math.fma(term, powers, sum);
            term *= q * ((2 * j + 4.0) / (2 * j + 7.0));
            powers = Math.fma(powers, square, 1);
        }
        return s * square * c * q * q * p * sum;
    }
}
