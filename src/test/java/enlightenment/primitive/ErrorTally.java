package enlightenment.primitive;

import enlightenment.math.Vec3;
import enlightenment.numeric.Scale;
import java.math.BigDecimal;
import java.math.MathContext;
import java.util.Locale;

/** Errors of the textbook's form [0] and of ours [1] over rays whose truth is known. */
final class ErrorTally {
    static final int NAIVE = 0;
    static final int OURS = 1;

    /** The allowed error of t, in roundings of the distance over the cosine of incidence: that of the vectors' file. */
    private static final double T_ROUNDINGS = 64;

    private static final MathContext DIGITS = new MathContext(40);

    int rays;
    int decided;
    final int[] wrong = new int[2];
    final int[] tOff = new int[2];

    /** NaN until something was measured. */
    final double[] relative = {Double.NaN, Double.NaN};

    final double[] ulps = {Double.NaN, Double.NaN};

    /** Judges one ray against a truth that is computed here. */
    void add(Subject s, Vec3 o, Vec3 d) {
        Truth.Verdict verdict = s.truth().judge(o, d, Truth.allowed(o, s.center(), s.size()));
        add(s, o, d, verdict, Double.NaN);
    }

    /**
     * Judges one ray.
     *
     * @param tolerance what t may be off, or NaN for 64 u D / cos
     */
    void add(Subject s, Vec3 o, Vec3 d, Truth.Verdict verdict, double tolerance) {
        rays++;
        if (!verdict.decided()) {
            return;
        }
        decided++;
        Hit hit = new Hit();
        boolean met = s.ours().intersect(Ray.of(o, d), hit);
        double t = s.naive().nearest(o, d, 0);
        boolean exact = verdict.t() != null;
        wrong[OURS] += met != exact ? 1 : 0;
        wrong[NAIVE] += (t < Primitive.MISS) != exact ? 1 : 0;
        if (!exact || !met) {
            return;
        }
        double allowed = tolerance;
        if (Double.isNaN(tolerance)) {
            double cosine = Math.abs(hit.normal().dot(d.normalized()));
            double distance = o.minus(s.center()).length() + s.size();
            allowed = T_ROUNDINGS * Scale.UNIT_ROUNDOFF * distance / cosine / d.length();
        }
        measure(s, OURS, hit.t, hit.point(), verdict.t(), allowed);
        if (t < Primitive.MISS) {
            measure(s, NAIVE, t, o.plus(d.times(t)), verdict.t(), allowed);
        }
    }

    private void measure(Subject s, int which, double t, Vec3 point, BigDecimal exact, double allowed) {
        BigDecimal error = new BigDecimal(t).subtract(exact).abs();
        tOff[which] += error.doubleValue() > allowed ? 1 : 0;
        if (exact.signum() != 0) {
            relative[which] =
                    larger(relative[which], error.divide(exact, DIGITS).doubleValue());
        }
        double off = s.truth().distance(point) / IntersectionVectorsTest.pointUlp(s.ours(), point);
        ulps[which] = larger(ulps[which], off);
    }

    private static double larger(double known, double v) {
        return known >= v ? known : v;
    }

    /** The figures as cells of a Markdown table. */
    String cells() {
        return String.format(
                Locale.ROOT,
                "%d | %d | %d | %d | %d | %d | %s | %s | %s | %s |",
                rays,
                decided,
                wrong[NAIVE],
                wrong[OURS],
                tOff[NAIVE],
                tOff[OURS],
                scientific(relative[NAIVE]),
                scientific(relative[OURS]),
                ulp(ulps[NAIVE]),
                ulp(ulps[OURS]));
    }

    private static String scientific(double v) {
        return Double.isNaN(v) ? "–" : v == 0 ? "0" : String.format(Locale.ROOT, "%.0e", v);
    }

    private static String ulp(double v) {
        return Double.isNaN(v) ? "–" : v < 1000 ? String.format(Locale.ROOT, "%.1f", v) : scientific(v);
    }
}
