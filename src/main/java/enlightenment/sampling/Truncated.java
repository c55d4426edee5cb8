package enlightenment.sampling;

/**
 * A standardised density truncated to an interval, as {@link Proposal} uses it. Mutable, allocation free.
 *
 * <p>Two forms, so that nothing cancels. If the mean lies within the interval, positions t are relative to the mean. If it lies outside or
 * on an end, the interval is reflected to the positive side and positions are relative to the end nearer to the mean, 0 ≤ t ≤ h: far out in
 * a tail, doubles could not distinguish them otherwise.
 */
abstract sealed class Truncated permits TruncatedNormal, TruncatedZeta, TruncatedLinear {
    /** Below this product of steepness and width, where differences of integrals lose digits, the density is a polynomial. */
    static final double NARROW = 0x1p-6;

    static Truncated of(Distribution family) {
        if (family instanceof NormalDistribution) {
            return new TruncatedNormal();
        }
        if (family instanceof ZetaDistribution) {
            return new TruncatedZeta();
        }
        if (family instanceof LinearDistribution) {
            return new TruncatedLinear();
        }
        throw new AssertionError("no truncated form of the distribution " + family.name());
    }

    /** The smaller of p and 1 − p, which is exact. */
    static double smallerTail(double p) {
        if (!(p >= 0 && p <= 1)) {
            throw new IllegalArgumentException("a probability must lie in 0..1, not " + p);
        }
        return Math.min(p, 1 - p);
    }

    /** Truncates to −left..right, both greater than 0, possibly infinite. */
    abstract void around(double left, double right);

    /**
     * Truncates to a..a + h, a at least 0 and finite, h greater than 0, possibly infinite.
     *
     * @return false if there is no density at all
     */
    abstract boolean beyond(double a, double h);

    /** The quantile u, 0 &lt; u &lt; 1, as a position; rounding may put it just outside the bounds. */
    abstract double at(double u);

    /** The density at a position, which must lie within the bounds. */
    abstract double density(double t);
}
