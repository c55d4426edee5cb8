package enlightenment.sampling;

import enlightenment.numeric.Exponential;

/** The truncated normal density: exp(−t(a + t/2)) times a constant; a is 0 around the mean. */
final class TruncatedNormal extends Truncated {
    /** From here on, positions are computed from the logarithm of the tail, which does not underflow. */
    private static final int FAR = 4;

    /** Newton's method stops at this relative step: the remaining error is about its square. Two or three steps are enough. */
    private static final double SMALL_STEP = 0x1p-30;

    private static final int MAX_STEPS = 8;

    private enum Form {
        AROUND,
        NARROW,
        TAIL,
        FAR
    }

    private final NarrowInterval narrow = new NarrowInterval();
    private Form form;
    private double a;
    private double norm;

    /** Probabilities before truncation: below the lower end, within, above the upper end, and from the lower end to the mean. */
    private double under;

    private double within;
    private double over;
    private double leftMass;

    /** Far out: the tail beyond a divided by exp(−a²/2), and the fraction of it that lies in the interval. */
    private double scaledTail;

    private double cut;

    @Override
    void around(double left, double right) {
        form = Form.AROUND;
        a = 0;
        leftMass = NormalIntegral.central(left);
        under = NormalIntegral.tail(left);
        double rightMass = NormalIntegral.central(right);
        over = NormalIntegral.tail(right);
        within = leftMass + rightMass;
        norm = NormalIntegral.PEAK / within;
    }

    @Override
    boolean beyond(double a, double h) {
        this.a = a;
        if (h * Math.max(a, 1) <= NARROW) {
            narrow(h);
        } else {
            tail(h);
        }
        return true;
    }

    private void narrow(double h) {
        form = Form.NARROW;
        double centre = a + 0.5 * h;
        double[] c = narrow.coefficients;
        c[0] = 1;
        c[1] = -centre;
        for (int j = 1; j < c.length - 1; j++) {
            // Hermite's recurrence, from f' = −z f.
            c[j + 1] = -(centre * c[j] + c[j - 1]) / (j + 1);
        }
        norm = 1 / (narrow.prepare(h) * Exponential.exp(exponent(0.5 * h, a)));
    }

    private void tail(double h) {
        scaledTail = NormalIntegral.scaledTail(a);
        double end = a + h;
        double remains = end == Double.POSITIVE_INFINITY
                ? 0
                : Exponential.exp(exponent(h, a)) * (NormalIntegral.scaledTail(end) / scaledTail);
        cut = 1 - remains;
        norm = NormalIntegral.PEAK / (scaledTail * cut);
        form = a < FAR ? Form.TAIL : Form.FAR;
        if (form == Form.TAIL) {
            // exp(−a²/2) does not underflow here.
            double tail = NormalIntegral.tail(a);
            within = tail * cut;
            over = tail * remains;
        }
    }

    private static double exponent(double t, double from) {
        return -t * (from + 0.5 * t);
    }

    @Override
    double at(double u) {
        if (form == Form.AROUND) {
            double fromMiddle = Math.fma(u, within, -leftMass);
            double tail = Math.fma(fromMiddle < 0 ? u : 1 - u, within, fromMiddle < 0 ? under : over);
            return NormalIntegral.inverse(fromMiddle, tail);
        }
        if (form == Form.TAIL) {
            double tail = Math.fma(1 - u, within, over);
            return NormalIntegral.inverse(0.5 - tail, tail) - a;
        }
        return form == Form.NARROW ? narrow.at(u) : atFar(u);
    }

    /** Solves a·t + t²/2 + ln(S(a)/S(a + t)) = −ln(1 − u·cut), S being the scaled tail. */
    private double atFar(double u) {
        double target = -StrictMath.log1p(-u * cut);
        double hazard = NormalIntegral.PEAK / scaledTail;
        double t = 2 * target / (hazard + Math.sqrt(Math.fma(hazard, hazard, 2 * target)));
        for (int i = 0; i < MAX_STEPS; i++) {
            double s = NormalIntegral.scaledTail(a + t);
            double excess = t * (a + 0.5 * t) + Exponential.log(scaledTail / s) - target;
            double step = excess * s / NormalIntegral.PEAK;
            t -= step;
            if (Math.abs(step) <= SMALL_STEP * t) {
                break;
            }
        }
        return t;
    }

    @Override
    double density(double t) {
        return norm * Exponential.exp(exponent(t, a));
    }
}
