package enlightenment.sampling;

import enlightenment.numeric.Exponential;

/** The truncated zeta density. Inside, x is the position in units of {@link ZetaSum}. */
final class TruncatedZeta extends Truncated {
    private static final double SCALE = ZetaSum.DEVIATION;

    private enum Form {
        AROUND,
        NARROW,
        TAIL,
        FAR
    }

    private final NarrowInterval narrow = new NarrowInterval();
    private final double[] scratch = ZetaSum.scratch();
    private Form form;

    /** The origin of positions. */
    private double start;

    private double norm;
    private double under;
    private double leftMass;
    private double within;
    private double over;

    /** Far out: the fraction of the exponential that lies in the interval. */
    private double cut;

    @Override
    void around(double left, double right) {
        form = Form.AROUND;
        start = 0;
        leftMass = ZetaSum.central(SCALE * left);
        under = ZetaSum.tail(SCALE * left);
        over = ZetaSum.tail(SCALE * right);
        within = leftMass + ZetaSum.central(SCALE * right);
        norm = SCALE / within;
    }

    @Override
    boolean beyond(double a, double h) {
        start = SCALE * a;
        double width = SCALE * h;
        if (start >= ZetaSum.FAR) {
            form = Form.FAR;
            cut = -StrictMath.expm1(-ZetaSum.SLOWEST * width);
            norm = SCALE * ZetaSum.SLOWEST / cut;
        } else if (width * ZetaSum.FASTEST <= NARROW) {
            form = Form.NARROW;
            double centre = start + 0.5 * width;
            ZetaSum.expand(centre, narrow.coefficients, scratch);
            norm = SCALE / (narrow.prepare(width) * ZetaSum.density(centre));
        } else {
            form = Form.TAIL;
            over = ZetaSum.tail(start + width);
            within = ZetaSum.tail(start) - over;
            norm = SCALE / within;
        }
        return true;
    }

    @Override
    double at(double u) {
        if (form == Form.AROUND) {
            return atAround(u) / SCALE;
        }
        if (form == Form.TAIL) {
            double tail = Math.fma(1 - u, within, over);
            return (ZetaSum.inverse(ZetaSum.HALF_MASS - tail, tail) - start) / SCALE;
        }
        return (form == Form.NARROW ? narrow.at(u) : -StrictMath.log1p(-u * cut) / ZetaSum.SLOWEST) / SCALE;
    }

    private double atAround(double u) {
        double fromMiddle = Math.fma(u, within, -leftMass);
        return fromMiddle < 0
                ? -ZetaSum.inverse(-fromMiddle, Math.fma(u, within, under))
                : ZetaSum.inverse(fromMiddle, Math.fma(1 - u, within, over));
    }

    @Override
    double density(double t) {
        double x = SCALE * t;
        return norm * (form == Form.FAR ? Exponential.exp(-ZetaSum.SLOWEST * x) : ZetaSum.density(start + Math.abs(x)));
    }
}
