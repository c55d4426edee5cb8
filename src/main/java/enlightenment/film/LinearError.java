package enlightenment.film;

/**
 * What the samples tell of the error of linear light, beside that of what a screen shows.
 *
 * @param relative root of the mean, over pixels and bands, of the variance over m² + (0.05 M)², where m is the pixel's value and M
 *     the mean of the band over the picture; NaN where most pixels have a single sample
 * @param kurtosis how unevenly the squared differences of halves are spread over the pixels: the sum of their squares, over that of
 *     the squared means of blocks of 32 × 32 pixels; 1 where all are equal, n where one of n has all. The greater one of what a
 *     screen shows and of relative linear light
 * @param grows whether what is shown differs more between halves than between quarters of the samples: pixels turn bright one by one,
 *     and most of those that will have not done so yet
 */
public record LinearError(double relative, double kurtosis, boolean grows) {
    /** Above this few bright samples carry the error, and what tells of it may have missed some. */
    private static final double HEAVY = 100;

    /** Whether few bright samples carry the error, so that it may be underestimated. */
    public boolean hasHeavyTail() {
        return kurtosis > HEAVY || grows;
    }
}
