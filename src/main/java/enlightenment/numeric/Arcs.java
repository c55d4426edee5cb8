package enlightenment.numeric;

/**
 * Lengths of arcs from their cosines, and sines and cosines of any angle of one turn: by fused operations and roots only, so the same on
 * every machine, and several times as fast as {@link StrictMath}.
 */
public final class Arcs {
    /** From here on {@link #overSine} holds: the cosine of 120°. */
    public static final double LEAST_COSINE = -0.5;

    /** The polynomial of {@link #nearOne}: coefficients of even and of odd powers. */
    private static final double E1 = 0.05714285714079507;

    private static final double E2 = 0.011544008764042558;
    private static final double E3 = 0.002485954425869126;
    private static final double E4 = 0.000539566898913318;
    private static final double E5 = 1.4743017805349805e-05;
    private static final double E6 = -0.000132157752596636;
    private static final double O0 = 0.13333333333334924;
    private static final double O1 = 0.02539682550179677;
    private static final double O2 = 0.00532804927222027;
    private static final double O3 = 0.0011731553423059266;
    private static final double O4 = 0.0003126151535212897;
    private static final double O5 = 0.00023105799880840196;
    private static final double O6 = 9.195087903114487e-05;

    private static final double TWO_OVER_PI = 2 / Math.PI;
    private static final double HALF_PI = Math.PI / 2;

    /** π/2 less {@link #HALF_PI}. */
    private static final double HALF_PI_REST = 6.123233995736766e-17;

    private Arcs() {}

    /**
     * θ/sin θ of an angle of 0..120°, whose length times a cross product of unit vectors is then free of any division.
     *
     * @param cosine cos θ, in {@link #LEAST_COSINE}..1; 1 may be exceeded by rounding
     * @return with an error of at most 2 units in the last place up to 60°, and 3 beyond
     */
    public static double overSine(double cosine) {
        if (cosine >= 0.5) {
            return nearOne(1 - cosine);
        }
        // With the half angle h: 2h/(2 sin h cos h).
        double half = Math.sqrt(Math.fma(0.5, cosine, 0.5));
        return nearOne(1 - half) / half;
    }

    /**
     * {@link #overSine} of t = 1 − cos θ in 0..1/2. The polynomial goes through 1 + t q(t) = acos(1 − t)/√(t (2 − t)) at the zeros of
     * Chebyshev's polynomial of degree 14 in that range: its relative error is below 1.3·10⁻¹⁷, that of the rounded coefficients included.
     * Even and odd powers apart, as that halves the time until the sum is there.
     */
    private static double nearOne(double t) {
        double z = t * t;
        double even = Math.fma(z, E6, E5);
        even = Math.fma(z, even, E4);
        even = Math.fma(z, even, E3);
        even = Math.fma(z, even, E2);
        even = Math.fma(z, even, E1);
        even = Math.fma(z, even, 1.0 / 3);
        double odd = Math.fma(z, O6, O5);
        odd = Math.fma(z, odd, O4);
        odd = Math.fma(z, odd, O3);
        odd = Math.fma(z, odd, O2);
        odd = Math.fma(z, odd, O1);
        odd = Math.fma(z, odd, O0);
        return Math.fma(t, Math.fma(t, odd, even), 1);
    }

    /** sin x for |x| ≤ 2π, with an error below 2.3·10⁻¹⁶. */
    public static double sine(double x) {
        double quarter = Math.rint(x * TWO_OVER_PI);
        double rest = rest(x, quarter);
        double s = ((int) quarter & 1) == 0 ? sineNearZero(rest) : cosineNearZero(rest);
        return ((int) quarter & 2) == 0 ? s : -s;
    }

    /** cos x for |x| ≤ 2π, with an error below 2.3·10⁻¹⁶. */
    public static double cosine(double x) {
        double quarter = Math.rint(x * TWO_OVER_PI);
        double rest = rest(x, quarter);
        double c = ((int) quarter & 1) == 0 ? cosineNearZero(rest) : sineNearZero(rest);
        return (((int) quarter + 1) & 2) == 0 ? c : -c;
    }

    /** What is left of x beyond some quarters of a turn. */
    private static double rest(double x, double quarters) {
        return Math.fma(-quarters, HALF_PI_REST, Math.fma(-quarters, HALF_PI, x));
    }

    /** sin x for |x| ≤ π/4, to 2 units in the last place: Taylor's series in Horner form, whose first omitted term is below 2^-57 there. */
    public static double sineNearZero(double x) {
        double z = x * x;
        double p = Math.fma(z, 1.0 / 355687428096000.0, -1.0 / 1307674368000.0);
        p = Math.fma(z, p, 1.0 / 6227020800.0);
        p = Math.fma(z, p, -1.0 / 39916800.0);
        p = Math.fma(z, p, 1.0 / 362880.0);
        p = Math.fma(z, p, -1.0 / 5040.0);
        p = Math.fma(z, p, 1.0 / 120.0);
        p = Math.fma(z, p, -1.0 / 6.0);
        return Math.fma(z * x, p, x);
    }

    /** cos x for |x| ≤ π/4, as {@link #sineNearZero}. */
    public static double cosineNearZero(double x) {
        double z = x * x;
        double p = Math.fma(z, -1.0 / 6402373705728000.0, 1.0 / 20922789888000.0);
        p = Math.fma(z, p, -1.0 / 87178291200.0);
        p = Math.fma(z, p, 1.0 / 479001600.0);
        p = Math.fma(z, p, -1.0 / 3628800.0);
        p = Math.fma(z, p, 1.0 / 40320.0);
        p = Math.fma(z, p, -1.0 / 720.0);
        p = Math.fma(z, p, 1.0 / 24.0);
        p = Math.fma(z, p, -0.5);
        return Math.fma(z, p, 1);
    }
}
