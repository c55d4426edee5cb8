package enlightenment.measure.analysis;

/**
 * A power law y = factor · x^slope, fitted by least squares to the logarithms.
 *
 * @param slope the exponent; −½ for the error of independent samples
 * @param slopeLow lower end of the 95 % confidence interval of the slope (Student's t, for logarithms with independent normal
 *     residuals); −infinity with two points, which leave no residuals
 * @param slopeHigh upper end of that interval
 * @param factor the value at x = 1
 * @param points number of fitted points, at least 2
 */
public record PowerLaw(double slope, double slopeLow, double slopeHigh, double factor, int points) {
    /** The 97.5 % quantile of the standard normal distribution. */
    private static final double Z = 1.959963984540054;

    /**
     * Fits a power law.
     *
     * @param x positive, at least two different values
     * @param y positive, one for each x
     * @throws IllegalArgumentException if the points determine no law
     */
    public static PowerLaw fit(double[] x, double[] y) {
        int n = x.length;
        if (n < 2 || y.length != n) {
            throw new IllegalArgumentException("a line needs at least two points, not " + n);
        }
        double meanX = 0;
        double meanY = 0;
        for (int i = 0; i < n; i++) {
            if (!(x[i] > 0 && y[i] > 0)) {
                throw new IllegalArgumentException("logarithms need positive numbers, not " + x[i] + ", " + y[i]);
            }
            meanX += Math.log(x[i]) / n;
            meanY += Math.log(y[i]) / n;
        }
        double xx = 0;
        double xy = 0;
        for (int i = 0; i < n; i++) {
            double dx = Math.log(x[i]) - meanX;
            xx += dx * dx;
            xy += dx * (Math.log(y[i]) - meanY);
        }
        if (!(xx > 0)) {
            throw new IllegalArgumentException("all points have the same x");
        }
        double slope = xy / xx;
        double half = n == 2 ? Double.POSITIVE_INFINITY : student(n - 2) * standardError(x, y, meanX, meanY, slope, xx);
        return new PowerLaw(slope, slope - half, slope + half, Math.exp(meanY - slope * meanX), n);
    }

    private static double standardError(double[] x, double[] y, double meanX, double meanY, double slope, double xx) {
        double squares = 0;
        for (int i = 0; i < x.length; i++) {
            double residual = Math.log(y[i]) - meanY - slope * (Math.log(x[i]) - meanX);
            squares += residual * residual;
        }
        return Math.sqrt(squares / (x.length - 2) / xx);
    }

    /** The 97.5 % quantile of Student's t: exact for 1 and 2 degrees of freedom, else the Cornish-Fisher expansion. */
    static double student(int degrees) {
        if (degrees == 1) {
            return Math.tan(Math.PI * 0.475);
        }
        if (degrees == 2) {
            return 0.95 * Math.sqrt(2 / (1 - 0.95 * 0.95));
        }
        double z2 = Z * Z;
        double a = Z * (z2 + 1) / 4;
        double b = Z * ((5 * z2 + 16) * z2 + 3) / 96;
        double c = Z * (((3 * z2 + 19) * z2 + 17) * z2 - 15) / 384;
        double v = 1.0 / degrees;
        return Z + v * (a + v * (b + v * c));
    }

    /** The value at x. */
    public double at(double x) {
        return factor * Math.pow(x, slope);
    }
}
