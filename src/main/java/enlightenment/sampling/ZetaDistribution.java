package enlightenment.sampling;

/**
 * The zeta distribution: Σ n^-|x| over n = 2 … 50, with x = s·z and s = 0.8206…, the deviation of the sum, divided by its
 * integral 2 Σ 1/ln n. This is the original's symmetric zeta function without its first term, the constant 1, which has no
 * integral. It is a mixture of 49 double exponentials: peaked at the mean, with tails that fall like 2^-|x|.
 */
public final class ZetaDistribution implements Distribution {
    static final ZetaDistribution INSTANCE = new ZetaDistribution();

    private static final double SCALE = ZetaSum.DEVIATION;

    private ZetaDistribution() {}

    @Override
    public String name() {
        return "zeta";
    }

    @Override
    public double density(double z) {
        return ZetaSum.density(SCALE * Math.abs(z)) * (SCALE / (2 * ZetaSum.HALF_MASS));
    }

    @Override
    public double cumulative(double z) {
        double tail = ZetaSum.tail(SCALE * Math.abs(z)) / (2 * ZetaSum.HALF_MASS);
        return z < 0 ? tail : 1 - tail;
    }

    @Override
    public double quantile(double p) {
        double mass = 2 * ZetaSum.HALF_MASS;
        double z = ZetaSum.inverse(Math.abs(p - 0.5) * mass, Truncated.smallerTail(p) * mass) / SCALE;
        return p < 0.5 ? -z : z;
    }
}
