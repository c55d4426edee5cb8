package enlightenment.bsdf;

/**
 * The phase function of L. Henyey and J. Greenstein ("Diffuse radiation in the galaxy", 1941) at a point of a medium. It is its own
 * density, so that every sample has weight 1. Value and density are per steradian, without a cosine. Normal and colour of the
 * {@link Scattering} are not read.
 */
public final class HenyeyGreenstein implements Bsdf {
    private final double g;

    /** (1 − |g|)², (1 − g²)/4π and 2|g|. */
    private final double narrow;

    private final double scale;
    private final double twice;

    /**
     * A phase function.
     *
     * @param g the mean cosine between the directions of travel before and after, above −1 and below 1
     */
    public HenyeyGreenstein(double g) {
        this.g = g;
        narrow = (1 - Math.abs(g)) * (1 - Math.abs(g));
        scale = (1 - g) * (1 + g) / (4 * Math.PI);
        twice = 2 * Math.abs(g);
    }

    @Override
    public boolean isDelta() {
        return false;
    }

    @Override
    public boolean transmits() {
        return true;
    }

    @Override
    public void evaluate(Scattering s) {
        double p = pdf(s);
        s.pdf = p;
        s.value(p, p, p);
    }

    /** The denominator is 1 + g² − 2g·cosθ, written as (1 − |g|)² + 2|g|·(1 ∓ cosθ) with the difference of unit vectors for the latter. */
    @Override
    public double pdf(Scattering s) {
        double sign = g < 0 ? -1 : 1;
        double x = Math.fma(sign, s.ox, s.ix);
        double y = Math.fma(sign, s.oy, s.iy);
        double z = Math.fma(sign, s.oz, s.iz);
        double d = Math.fma(twice, (x * x + y * y + z * z) / 2, narrow);
        return scale / (d * Math.sqrt(d));
    }

    /**
     * Samples by the inverse of the distribution: with ξ uniform, s = 2ξ − 1 and q = 1 + gs both 1 − cosθ = (1 − g)²(1 − s)(2 + g(1 +
     * s))/2q² and 1 + cosθ = (1 + g)²(1 + s)(2 − g(1 − s))/2q² without a difference of near numbers, whatever g is.
     */
    @Override
    public boolean sample(Scattering s, double u, double v, double choice) {
        // The squared radius is uniform, and independent of the angle.
        s.toDisk(u, v);
        double below = 2 * s.disk2;
        double above = 2 - below;
        double q = Math.fma(g, above - 1, 1);
        double half = 1 / (2 * q * q);
        double forward = (1 - g) * (1 - g) * below * Math.fma(g, above, 2) * half;
        double backward = (1 + g) * (1 + g) * above * Math.fma(-g, below, 2) * half;
        double sine = Math.sqrt(forward * backward);
        double across = s.disk2 > 0 ? sine / Math.sqrt(s.disk2) : 0;
        s.directFrom(across * s.diskX, across * s.diskY, (backward - forward) / 2);
        double root = (1 - g) * (1 + g) / q;
        s.pdf = scale / (root * root * root);
        s.value(1, 1, 1);
        s.delta = false;
        s.transmitted = true;
        return true;
    }
}
