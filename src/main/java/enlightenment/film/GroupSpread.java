package enlightenment.film;

/**
 * What groups of independent paths tell about the error of the mean of all of them, where pixels may err together: a path may reach
 * several.
 *
 * <p>If the means of the groups have the covariance C/N_g, N_g being numbers of paths, then each group's difference from the mean of
 * those before it, times the root of N_g M/(N_g + M) with their number M, has the covariance C (F. R. Helmert 1876), and these contrasts
 * do not depend on each other. So their squares tell the trace of C, the sum of all squared errors to be expected; and the products of
 * two contrasts, summed over all pixels and squared, the trace of C², which says by how much that sum may differ from what is expected:
 * its variance is 2 tr C² for normal numbers.
 */
final class GroupSpread {
    private final int contrasts;
    private final double[] contrast;

    /** Products of two contrasts, summed over all components of all pixels. */
    private final double[][] products;

    /** Of the variances of pixels, and of their squares. */
    private double sum;

    private double squares;

    /** @param groups how many groups there are, at least 2 */
    GroupSpread(int groups) {
        contrasts = groups - 1;
        contrast = new double[contrasts];
        products = new double[contrasts][contrasts];
    }

    /**
     * Adds the means of a component of a pixel.
     *
     * @param means of the groups
     * @param paths of the groups, at least 1 each
     * @return the estimated variance of the mean of all paths, times their number
     */
    double add(double[] means, long[] paths) {
        double mean = means[0];
        double number = paths[0];
        double variance = 0;
        for (int k = 0; k < contrasts; k++) {
            double n = paths[k + 1];
            double d = means[k + 1] - mean;
            contrast[k] = d * Math.sqrt(n * number / (n + number));
            number += n;
            mean += d * n / number;
            variance += contrast[k] * contrast[k];
        }
        for (int k = 0; k < contrasts; k++) {
            for (int j = 0; j < k; j++) {
                products[k][j] += contrast[k] * contrast[j];
            }
        }
        return variance / contrasts;
    }

    /** Adds the sum of what {@link #add} gave for the three components of a pixel. */
    void addPixel(double variances) {
        sum += variances;
        squares += variances * variances;
    }

    /**
     * The variance of the logarithm of the ratio of what the groups tell, to the squared error as it is: of sums of squares with the
     * variances 2/(G − 1) tr C² and 2 tr C²; half of that.
     */
    double inverse() {
        // Of pixels that err each for itself. The shares of n equal ones in the sum have the Dirichlet distribution
        // whose parameters are h, half the number of contrasts. The mean of the sum of their squares is
        // (h + 1)/(n h + 1), and 1/n is sought.
        double share = squares / (sum * sum);
        double half = 0.5 * contrasts;
        double inverse = share * half / (half + 1 - share);
        double together = 0;
        int pairs = 0;
        for (int k = 0; k < contrasts; k++) {
            for (int j = 0; j < k; j++) {
                together += products[k][j] * products[k][j];
                pairs++;
            }
        }
        if (pairs > 0) {
            inverse = Math.max(inverse, together / pairs / (sum * sum));
        }
        return (1 + 1.0 / contrasts) * inverse;
    }
}
