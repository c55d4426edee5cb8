package enlightenment.scene;

import enlightenment.check.Check;
import java.util.OptionalDouble;

/**
 * How much a picture may cost, or how exact it must be: whichever comes first ends the render. With nothing given,
 * {@code antialias} says how many samples there are.
 *
 * @param samples camera rays per pixel, in the mean over the picture; 1..16,777,216. The method
 *     {@code cluster} cannot do with less than about 2.3, and may take some per cent more where it learns
 * @param error root mean square error of the picture, in display units 0..1, that need not be undercut; greater than 0. It is met
 *     where the upper end of the interval that is to hold the true error is at most this
 * @param seconds time by the clock for planning and rendering; greater than 0. It is turned into a number of samples early, so
 *     that the picture can be made again with that number
 * @param depth bits per component, 1..16, of the file that is to keep the error: its rounding counts as error, too. 0 where
 *     only the picture itself, in floats, is meant. Without an error it means nothing
 */
public record Budget(OptionalDouble samples, OptionalDouble error, OptionalDouble seconds, int depth) {
    /** More samples per pixel than this are refused. */
    public static final double MAX_SAMPLES = 1 << 24;

    private static final int MAX_DEPTH = 16;

    /** No limits. */
    public static final Budget NONE =
            new Budget(OptionalDouble.empty(), OptionalDouble.empty(), OptionalDouble.empty(), 0);

    public Budget {
        if (samples.isPresent()) {
            double n = samples.getAsDouble();
            Check.that(n >= 1 && n <= MAX_SAMPLES, "samples", "must lie in 1.." + (long) MAX_SAMPLES + ", not " + n);
        }
        if (error.isPresent()) {
            double e = error.getAsDouble();
            Check.that(e > 0 && e < Double.POSITIVE_INFINITY, "error", "must be greater than 0, not " + e);
        }
        if (seconds.isPresent()) {
            double s = seconds.getAsDouble();
            Check.that(s > 0 && s < Double.POSITIVE_INFINITY, "time", "must be greater than 0, not " + s);
        }
        Check.that(depth >= 0 && depth <= MAX_DEPTH, "depth", "must lie in 0.." + MAX_DEPTH + ", not " + depth);
    }

    /** This budget with another number of samples per pixel, as {@link #samples}. */
    public Budget withSamples(double value) {
        return new Budget(OptionalDouble.of(value), error, seconds, depth);
    }

    /** This budget with another error, as {@link #error}. */
    public Budget withError(double value) {
        return new Budget(samples, OptionalDouble.of(value), seconds, depth);
    }

    /** This budget with another time, as {@link #seconds}. */
    public Budget withSeconds(double value) {
        return new Budget(samples, error, OptionalDouble.of(value), depth);
    }

    /** This budget for a file of another depth, as {@link #depth}. */
    public Budget withDepth(int value) {
        return new Budget(samples, error, seconds, value);
    }

    /**
     * The budget with which the same picture is made again: a number of samples in place of an error or a time.
     *
     * @param planned the number of samples that this budget has become
     */
    public Budget replayable(double planned) {
        return error.isEmpty() && seconds.isEmpty() ? this : NONE.withSamples(planned);
    }

    /** Whether nothing is given. */
    public boolean isNone() {
        return samples.isEmpty() && error.isEmpty() && seconds.isEmpty();
    }
}
