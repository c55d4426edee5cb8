package enlightenment.plan;

/**
 * Searches for the number of samples for which the error is as asked, from errors measured at a few numbers.
 *
 * <p>As a rule the error falls between n^−½ and 1/n. It falls far more steeply where a method has a fixed cost that is most
 * of n: then the numbers that are known to be too few and enough take over, and what is not known to be enough is not the
 * answer.
 */
final class ErrorSearch {
    /** An error this close below what is asked, by a factor, is close enough. */
    private static final double CLOSE = 1.25;

    /** Numbers of samples this close need no telling apart. */
    private static final double SAME = 1.04;

    /** The largest factor from one number of samples to the next. */
    private static final double LONGEST_STEP = 8;

    /** The smallest factor after too few samples: smaller steps may stay on the same plateau of the error. */
    private static final double SHORTEST_STEP = 1.1;

    private static final double LEAST_SLOPE = 0.5;
    static final double USUAL_SLOPE = 0.75;

    /** The steepest slope of the error: 1/n, unless other rays are followed. */
    private static final double MOST_SLOPE = 1;

    /** Least step as a share of the logarithmic interval between too few and enough, so that either side shrinks. */
    private static final double LEAST_SHARE = 0.15;

    private final double error;
    private final double least;
    private final double most;

    /** The largest number that is too few and the smallest that is enough, with their errors. */
    private double few;

    private double fewError;
    private double enough = Double.POSITIVE_INFINITY;
    private double enoughError;
    private double last;
    private double lastError;

    ErrorSearch(double error, double least, double most) {
        this.error = error;
        this.least = least;
        this.most = most;
    }

    /** Records the error of a number of samples. */
    void found(double n, double e) {
        last = n;
        lastError = e;
        if (e <= error && n <= enough) {
            enough = n;
            enoughError = e;
        } else if (e > error && n >= few) {
            few = n;
            fewError = e;
        }
    }

    /** Whether a number is known to be enough. */
    boolean isFound() {
        return enough < Double.POSITIVE_INFINITY;
    }

    /** Whether another trial would tell little. */
    boolean isOver() {
        return isOutOfReach()
                || enough <= few * SAME
                || enough <= least * SAME
                || few >= most
                || lastError <= error && lastError >= error / CLOSE;
    }

    /** Whether even the largest number is too few, as far as can be told. */
    private boolean isOutOfReach() {
        return !isFound() && few > 0 && StrictMath.pow(few / most, MOST_SLOPE) * fewError > error;
    }

    /** The number of samples to try next. */
    double next() {
        return Math.min(Math.max(between(), least), most);
    }

    private double between() {
        if (few == 0 || enough == Double.POSITIVE_INFINITY) {
            double factor = lastError == 0 ? 0 : StrictMath.pow(lastError / error, 1 / USUAL_SLOPE);
            double least = lastError > error ? SHORTEST_STEP : 1 / LONGEST_STEP;
            return last * Math.min(Math.max(factor, least), LONGEST_STEP);
        }
        return inside(Math.min(Math.max(share(), LEAST_SHARE), 1 - LEAST_SHARE));
    }

    /** The logarithmic position of the error asked for between too few and enough, if the error is a power. */
    private double share() {
        return enoughError > 0 ? StrictMath.log(fewError / error) / StrictMath.log(fewError / enoughError) : 0.5;
    }

    private double inside(double share) {
        return few * StrictMath.pow(enough / few, share);
    }

    /**
     * The number of samples that is enough: one that was tried, since the error may fall in steps in between; if none was, one
     * beyond what was tried.
     */
    double answer() {
        if (isFound()) {
            return enough;
        }
        return Math.min(Math.max(few * StrictMath.pow(fewError / error, 1 / LEAST_SLOPE), least), most);
    }
}
