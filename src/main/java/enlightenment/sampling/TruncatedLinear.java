package enlightenment.sampling;

/** The truncated tent, in units of its half width. */
final class TruncatedLinear extends Truncated {
    private static final double WIDTH = LinearDistribution.HALF_WIDTH;

    private boolean around;

    /** The height of the tent at position 0, and at the far end of an interval beside the mean. */
    private double start;

    private double end;

    /** The width of the interval, as far as there is density. */
    private double width;

    private double norm;
    private double under;
    private double leftMass;
    private double within;
    private double over;

    @Override
    void around(double left, double right) {
        around = true;
        start = 1;
        double l = Math.min(left / WIDTH, 1);
        double r = Math.min(right / WIDTH, 1);
        leftMass = l * (1 - 0.5 * l);
        double rightMass = r * (1 - 0.5 * r);
        under = 0.5 * (1 - l) * (1 - l);
        over = 0.5 * (1 - r) * (1 - r);
        within = leftMass + rightMass;
        norm = 1 / (WIDTH * within);
    }

    @Override
    boolean beyond(double a, double h) {
        around = false;
        start = (WIDTH - a) / WIDTH;
        if (!(start > 0)) {
            return false;
        }
        width = Math.min(h / WIDTH, start);
        end = start - width;
        norm = 2 / (WIDTH * width * (start + end));
        return true;
    }

    @Override
    double at(double u) {
        if (!around) {
            double used = u * width * (start + end);
            double rest = Math.sqrt((1 - u) * start * start + u * end * end);
            return WIDTH * used / (start + rest);
        }
        double fromMiddle = Math.fma(u, within, -leftMass);
        return fromMiddle < 0
                ? -WIDTH * LinearDistribution.fromPeak(Math.fma(u, within, under), -fromMiddle)
                : WIDTH * LinearDistribution.fromPeak(Math.fma(1 - u, within, over), fromMiddle);
    }

    @Override
    double density(double t) {
        return norm * Math.max(start - Math.abs(t) / WIDTH, 0);
    }
}
