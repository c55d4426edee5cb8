package enlightenment.sampling;

/**
 * The normal distribution, the paper's own proposal: density exp(−z²/2) / √(2π).
 *
 * <p>Sources of the approximations: {@link NormalIntegral}.
 */
public final class NormalDistribution implements Distribution {
    static final NormalDistribution INSTANCE = new NormalDistribution();

    private NormalDistribution() {}

    @Override
    public String name() {
        return "normal";
    }

    @Override
    public double density(double z) {
        return NormalIntegral.bell(z) * NormalIntegral.PEAK;
    }

    @Override
    public double cumulative(double z) {
        return z < 0 ? NormalIntegral.tail(-z) : 0.5 + NormalIntegral.central(z);
    }

    @Override
    public double quantile(double p) {
        return NormalIntegral.inverse(p - 0.5, Truncated.smallerTail(p));
    }
}
