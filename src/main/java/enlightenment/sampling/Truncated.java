package enlightenment.sampling;

/**
 * A standardised density, cut off: what {@link Proposal} needs of a family. Mutable, allocation free.
 *
 * <p>Two forms, so that nothing cancels. If the mean lies within the interval, positions t are counted from the mean. If it
 * lies outside or on an end, the interval is reflected to the positive side and positions are counted from its end
 * nearer to the mean, 0 ≤ t ≤ h: far out in a tail they could not be told apart otherwise.
 */
abstract sealed class Truncated permits TruncatedNormal, TruncatedZeta, TruncatedLinear {
    /** Below this steepness times width, differences of integrals would lose digits: the density is taken as a polynomial. */
    static final double NARROW = 0x1p-6;

    static Truncated of(Distribution family) {
        if (family instanceof NormalDistribution) {
            return new TruncatedNormal();
        }
        return family instanceof ZetaDistribution ? new TruncatedZeta() : new TruncatedLinear();
    }

    /** The smaller of p and 1 − p, which is exact. */
    static double smallerTail(double p) {
        if (!(p >= 0 && p <= 1)) {
            throw new IllegalArgumentException("a probability must lie in 0..1, not " + p);
        }
        return Math.min(p, 1 - p);
    }

    /** Cuts off outside −left..right, both greater than 0, perhaps infinite. */
    abstract void around(double left, double right);

    /**
     * Cuts off outside a..a + h, a at least 0 and finite, h greater than 0, perhaps infinite.
     *
     * @return false if there is no density at all
     */
    abstract boolean beyond(double a, double h);

    /** The position that has the share u of the probability below it, 0 &lt; u &lt; 1; it may miss the bounds by a rounding. */
    abstract double at(double u);

    /** The density at a position, which must lie within the bounds. */
    abstract double density(double t);
}
