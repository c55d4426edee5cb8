package enlightenment.film;

import enlightenment.film.VarianceDecay.Curve;

/**
 * {@link VarianceDecay} for path-traced light. Nearly all of its variance is that of independent samples, whose two figures have the ratio
 * 2 and whose first figure is the variance. Two effects depart from that.
 *
 * <p>A part may fall faster. If a variance falls as n^−p, the ratio is R = 2^p and the share 1/(R − 1); mixed with independent noise it
 * lies on the straight line from (2, 1) to there. Between the pure power, which is the least, and the line to p = 2, which is the most,
 * lies what is to be expected; where variances have just begun to fall, they will for once fall faster than they go on to, and the root of
 * the line is the most.
 *
 * <p>What falls faster than the square as far as it is seen need not go on so. A choice of paths, between light and nothing with
 * probability p, takes a stratified number: all of n samples but one are certain, and the variance is {np}(1 − {np})/n² with the fractional
 * part {np}, which goes up and down from one power of two to the next. With m, the distance of n p/2 from the next integer, R is either 2
 * or 2(1 − m)/m, and the share 1 − 2m: so for R above 2 it is (R − 2)/(R + 2), which grows to 1; in the mean over p it is that of a square,
 * ⅓. Smooth light has R = 8 as well, and a share of 1/7. So from R = 4 on what is to be expected stays ⅓, and all is possible.
 *
 * <p>The screen may saturate. A bright sample that one pixel of many has met shows less than in proportion to its share of the mean: if it
 * shows as its share's power γ, n samples that each are such a one with a small probability give halves, quarters and squared error in the
 * proportion 4^γ/4 : 16^γ/8 : 1, so R = 4^γ/2 and the share is 2/R: from 1 where nothing is lost to 4 where the screen shows white whatever
 * the share.
 */
final class PathDecay {
    /** The ratio of independent samples. */
    private static final double INDEPENDENT = 2;

    /** The ratio of a variance that falls as the square, and what is left of the figure then. */
    private static final double SQUARE = 4;

    private static final double OF_SQUARE = 1.0 / 3;

    /** The share where the screen shows white: as many as four quarters. */
    private static final double SATURATED = 4;

    /**
     * FITTED, as the powers below: how far the share was found from what is expected, on pictures of noise of many kinds (exponential, of
     * one in four, of sparks of 1 in 300, log-normal, slight noise on edges), in the dark and where most is white, with 4 to 64 samples.
     */
    private static final double LEAST = 0.6;

    private static final double MOST = 1.15;

    /** Between the pure power (0) and the line (1). */
    private static final double USUAL = 0.7;

    /** Where the screen saturates, the means of few samples are too dark, too, of which their differences tell nothing. */
    private static final double BIASED = 1.4;

    /** Of a pair the figure is a difference of greater ones; less than this share is taken for chance. */
    private static final double PAIR_LEAST_SHARE = 0.3;

    /** The most of one to three samples; FITTED on the same pictures, but for those that such samples show only as black or white. */
    private static final double FEW_MOST = 2.5;

    private PathDecay() {}

    /**
     * The share of the first figure that is left.
     *
     * @param level binary logarithm of the number of samples, or negative for numbers of which there is none
     * @param ratio of the second figure to the first
     */
    static double share(Curve curve, int level, double ratio) {
        if (level == 0 || level == 1) {
            double share = level == 0 ? 1 : Math.max(Math.min(ratio, 1), PAIR_LEAST_SHARE);
            // Of so few it cannot be told how far the screen has saturated.
            return curve == Curve.LEAST ? LEAST * share : curve == Curve.MOST ? FEW_MOST : share;
        }
        if (ratio <= INDEPENDENT) {
            double share = Math.min(INDEPENDENT / Math.max(ratio, 1 / SATURATED), SATURATED);
            return curve == Curve.LEAST
                    ? LEAST * share
                    : curve == Curve.MOST ? MOST * StrictMath.pow(share, BIASED) : share;
        }
        double power = 1 / (ratio - 1);
        if (ratio >= SQUARE) {
            return switch (curve) {
                case LEAST -> LEAST * power;
                case MIDDLE -> OF_SQUARE;
                case MOST -> MOST * Math.max((ratio - INDEPENDENT) / (ratio + INDEPENDENT), Math.sqrt(OF_SQUARE));
            };
        }
        double line = 1 - (1 - OF_SQUARE) * (ratio - INDEPENDENT) / (SQUARE - INDEPENDENT);
        return switch (curve) {
            case LEAST -> LEAST * power;
            case MIDDLE -> StrictMath.pow(power, 1 - USUAL) * StrictMath.pow(line, USUAL);
            case MOST -> MOST * Math.sqrt(line);
        };
    }
}
