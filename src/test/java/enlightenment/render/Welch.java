package enlightenment.render;

import java.util.Arrays;

/**
 * B. L. Welch's test of two means of samples whose variances may differ ("The generalization of Student's problem",
 * 1947), with the degrees of freedom of Satterthwaite.
 */
public final class Welch {
    private static final int PANELS = 2000;

    /** Relative rounding of sums of some thousand numbers of either sign: noise-free samples may differ by it. */
    private static final double ROUNDING = 4096 * Math.ulp(1.0);

    private final double difference;
    private final double standardError;
    private final double freedom;

    private Welch(double difference, double standardError, double freedom) {
        this.difference = difference;
        this.standardError = standardError;
        this.freedom = freedom;
    }

    public static Welch of(double[] a, double[] b) {
        double meanA = mean(a);
        double meanB = mean(b);
        double va = variance(a, meanA) / a.length;
        double vb = variance(b, meanB) / b.length;
        double rounding = ROUNDING * Math.max(Math.abs(meanA), Math.abs(meanB));
        double both = va + vb + rounding * rounding;
        double parts = va * va / (a.length - 1) + vb * vb / (b.length - 1);
        double most = a.length + b.length - 2;
        double freedom = parts > 0 ? Math.min(both * both / parts, most) : most;
        return new Welch(meanA - meanB, Math.sqrt(both), freedom);
    }

    /** How many standard errors lie between the means. */
    public double deviations() {
        return standardError == 0 ? 0 : difference / standardError;
    }

    public double standardError() {
        return standardError;
    }

    /**
     * The probability of a difference at least as great, of either sign, if the means are equal. With t = √ν tan θ Student's
     * density is proportional to cos^(ν − 1) θ, so it is a quotient of two integrals over θ.
     */
    public double probability() {
        double from = Math.atan(Math.abs(deviations()) / Math.sqrt(freedom));
        return integral(from) / integral(0);
    }

    private double integral(double from) {
        double step = (Math.PI / 2 - from) / (2 * PANELS);
        double sum = 0;
        for (int k = 0; k <= 2 * PANELS; k++) {
            double f = Math.pow(Math.max(Math.cos(from + k * step), 0), freedom - 1);
            sum += f * (k == 0 || k == 2 * PANELS ? 1 : k % 2 == 1 ? 4 : 2);
        }
        return sum * step / 3;
    }

    /** Šidák's level for one of so many comparisons, for an error of any of them with this probability. */
    public static double sidak(double level, int comparisons) {
        return -Math.expm1(Math.log1p(-level) / comparisons);
    }

    static double mean(double[] x) {
        return Arrays.stream(x).sum() / x.length;
    }

    static double variance(double[] x, double mean) {
        return Arrays.stream(x).map(v -> (v - mean) * (v - mean)).sum() / (x.length - 1);
    }
}
