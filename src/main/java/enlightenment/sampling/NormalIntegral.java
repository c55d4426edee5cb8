package enlightenment.sampling;

import enlightenment.numeric.Exponential;

/**
 * Integrals of the normal density and their inverse, for z ≥ 0. Each is accurate to a few units in the last place, in the
 * tails too, until it underflows.
 *
 * <p>Sources: W. J. Cody, "Rational Chebyshev approximations for the error function", Mathematics of Computation 23
 * (1969), the coefficients of his CALERF; M. J. Wichura, "Algorithm AS 241: the percentage points of the normal
 * distribution", Applied Statistics 37 (1988), PPND16. Their relative errors, measured with 40 digits, are below 1.1e-16.
 */
final class NormalIntegral {
    /** The density at 0, 1/√(2π). */
    static final double PEAK = 1 / Math.sqrt(2 * Math.PI);

    private static final double ROOT_HALF = Math.sqrt(0.5);
    private static final double ONE_BY_ROOT_PI = 1 / Math.sqrt(Math.PI);

    /** Where Cody's central approximation ends, in units of √2 standard deviations. */
    private static final double CODY_CENTRAL = 0.46875;

    /** Where Wichura's central approximation ends, as a probability from the median, and its square. */
    private static final double WICHURA_CENTRAL = 0.425;

    private static final double WICHURA_CENTRAL_SQUARED = 0.180625;

    private NormalIntegral() {}

    /** exp(−z²/2), corrected for the rounding of the square. */
    static double bell(double z) {
        double square = z * z;
        double rest = Math.fma(z, z, -square);
        double e = Exponential.exp(-0.5 * square);
        // For an infinite or huge z the correction is NaN.
        return e == 0 ? 0 : Math.fma(-0.5 * rest, e, e);
    }

    /** The integral of the density from 0 to z ≥ 0. */
    static double central(double z) {
        double y = z * ROOT_HALF;
        return y <= CODY_CENTRAL ? middle(y) : 0.5 - bell(z) * scaled(y);
    }

    /** The integral of the density from z ≥ 0 to ∞. */
    static double tail(double z) {
        double y = z * ROOT_HALF;
        return y <= CODY_CENTRAL ? 0.5 - middle(y) : bell(z) * scaled(y);
    }

    /** The tail from z ≥ 0 divided by exp(−z²/2): it never underflows for z below 1e150. */
    static double scaledTail(double z) {
        double y = z * ROOT_HALF;
        return y <= CODY_CENTRAL ? (0.5 - middle(y)) / bell(z) : scaled(y);
    }

    /** Half the error function for |y| ≤ 0.46875. */
    private static double middle(double y) {
        double s = y * y;
        double p = Math.fma(s, 1.85777706184603153E-1, 3.16112374387056560E0);
        p = Math.fma(s, p, 1.13864154151050156E2);
        p = Math.fma(s, p, 3.77485237685302021E2);
        p = Math.fma(s, p, 3.20937758913846947E3);
        double q = s + 2.36012909523441209E1;
        q = Math.fma(s, q, 2.44024637934444173E2);
        q = Math.fma(s, q, 1.28261652607737228E3);
        q = Math.fma(s, q, 2.84423683343917062E3);
        return 0.5 * y * (p / q);
    }

    /** Half of exp(y²)·erfc y for y ≥ 0.46875. */
    private static double scaled(double y) {
        return 0.5 * (y <= 4 ? scaledNear(y) : scaledFar(y));
    }

    private static double scaledNear(double y) {
        double p = Math.fma(y, 2.15311535474403846E-8, 5.64188496988670089E-1);
        p = Math.fma(y, p, 8.88314979438837594E0);
        p = Math.fma(y, p, 6.61191906371416295E1);
        p = Math.fma(y, p, 2.98635138197400131E2);
        p = Math.fma(y, p, 8.81952221241769090E2);
        p = Math.fma(y, p, 1.71204761263407058E3);
        p = Math.fma(y, p, 2.05107837782607147E3);
        p = Math.fma(y, p, 1.23033935479799725E3);
        double q = y + 1.57449261107098347E1;
        q = Math.fma(y, q, 1.17693950891312499E2);
        q = Math.fma(y, q, 5.37181101862009858E2);
        q = Math.fma(y, q, 1.62138957456669019E3);
        q = Math.fma(y, q, 3.29079923573345963E3);
        q = Math.fma(y, q, 4.36261909014324716E3);
        q = Math.fma(y, q, 3.43936767414372164E3);
        q = Math.fma(y, q, 1.23033935480374942E3);
        return p / q;
    }

    private static double scaledFar(double y) {
        double s = 1 / (y * y);
        double p = Math.fma(s, 1.63153871373020978E-2, 3.05326634961232344E-1);
        p = Math.fma(s, p, 3.60344899949804439E-1);
        p = Math.fma(s, p, 1.25781726111229246E-1);
        p = Math.fma(s, p, 1.60837851487422766E-2);
        p = Math.fma(s, p, 6.58749161529837803E-4);
        double q = s + 2.56852019228982242E0;
        q = Math.fma(s, q, 1.87295284992346725E0);
        q = Math.fma(s, q, 5.27905102951428412E-1);
        q = Math.fma(s, q, 6.05183413124413191E-2);
        q = Math.fma(s, q, 2.33520497626869185E-3);
        return (ONE_BY_ROOT_PI - s * (p / q)) / y;
    }

    /**
     * The z with this probability between 0 and z, negative for a negative one.
     *
     * @param tail the probability beyond z, away from 0, which is accurate where the other is not
     */
    static double inverse(double fromMiddle, double tail) {
        return Math.abs(fromMiddle) <= WICHURA_CENTRAL
                ? inverseCentral(fromMiddle)
                : Math.copySign(inverseTail(tail), fromMiddle);
    }

    private static double inverseTail(double tail) {
        double r = Math.sqrt(-Exponential.log(tail));
        if (r <= 5) {
            return inverseNear(r - 1.6);
        }
        return r < Double.POSITIVE_INFINITY ? inverseFar(r - 5) : r;
    }

    private static double inverseCentral(double v) {
        double r = Math.fma(-v, v, WICHURA_CENTRAL_SQUARED);
        double p = Math.fma(r, 2.5090809287301226727E3, 3.3430575583588128105E4);
        p = Math.fma(r, p, 6.7265770927008700853E4);
        p = Math.fma(r, p, 4.5921953931549871457E4);
        p = Math.fma(r, p, 1.3731693765509461125E4);
        p = Math.fma(r, p, 1.9715909503065514427E3);
        p = Math.fma(r, p, 1.3314166789178437745E2);
        p = Math.fma(r, p, 3.3871328727963666080E0);
        double q = Math.fma(r, 5.2264952788528545610E3, 2.8729085735721942674E4);
        q = Math.fma(r, q, 3.9307895800092710610E4);
        q = Math.fma(r, q, 2.1213794301586595867E4);
        q = Math.fma(r, q, 5.3941960214247511077E3);
        q = Math.fma(r, q, 6.8718700749205790830E2);
        q = Math.fma(r, q, 4.2313330701600911252E1);
        q = Math.fma(r, q, 1);
        return v * (p / q);
    }

    private static double inverseNear(double r) {
        double p = Math.fma(r, 7.74545014278341407640E-4, 2.27238449892691845833E-2);
        p = Math.fma(r, p, 2.41780725177450611770E-1);
        p = Math.fma(r, p, 1.27045825245236838258E0);
        p = Math.fma(r, p, 3.64784832476320460504E0);
        p = Math.fma(r, p, 5.76949722146069140550E0);
        p = Math.fma(r, p, 4.63033784615654529590E0);
        p = Math.fma(r, p, 1.42343711074968357734E0);
        double q = Math.fma(r, 1.05075007164441684324E-9, 5.47593808499534494600E-4);
        q = Math.fma(r, q, 1.51986665636164571966E-2);
        q = Math.fma(r, q, 1.48103976427480074590E-1);
        q = Math.fma(r, q, 6.89767334985100004550E-1);
        q = Math.fma(r, q, 1.67638483018380384940E0);
        q = Math.fma(r, q, 2.05319162663775882187E0);
        q = Math.fma(r, q, 1);
        return p / q;
    }

    private static double inverseFar(double r) {
        double p = Math.fma(r, 2.01033439929228813265E-7, 2.71155556874348757815E-5);
        p = Math.fma(r, p, 1.24266094738807843860E-3);
        p = Math.fma(r, p, 2.65321895265761230930E-2);
        p = Math.fma(r, p, 2.96560571828504891230E-1);
        p = Math.fma(r, p, 1.78482653991729133580E0);
        p = Math.fma(r, p, 5.46378491116411436990E0);
        p = Math.fma(r, p, 6.65790464350110377720E0);
        double q = Math.fma(r, 2.04426310338993978564E-15, 1.42151175831644588870E-7);
        q = Math.fma(r, q, 1.84631831751005468180E-5);
        q = Math.fma(r, q, 7.86869131145613259100E-4);
        q = Math.fma(r, q, 1.48753612908506148525E-2);
        q = Math.fma(r, q, 1.36929880922735805310E-1);
        q = Math.fma(r, q, 5.99832206555887937690E-1);
        q = Math.fma(r, q, 1);
        return p / q;
    }
}
