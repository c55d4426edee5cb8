package enlightenment.plan;

import enlightenment.report.RenderReport;
import enlightenment.scene.RenderSettings;
import java.math.BigDecimal;
import java.util.Locale;
import java.util.Optional;
import java.util.OptionalDouble;

/**
 * Decides whether a finished picture is as exact as its budget asks, and with how many samples to render it again if not. A round
 * starts from nothing: so its picture is that of {@code --samples} with its number, whatever rounds there were before
 * (docs/decisions/0008). Each takes at least a quarter more than the one before, so all of them together take at most five times
 * as much as the last; as a rule there are one or two.
 */
public final class Rounds {
    /** Target of a round as a share of the error asked for: a further round costs more than excess samples. */
    private static final double AIM = 0.95;

    /** The smallest and the largest factor from one round to the next. */
    private static final double LEAST_FACTOR = 1.25;

    private static final double MOST_FACTOR = 8;

    /** The error falls at least as n^−½ and at best as 1/n with the number of samples. */
    private static final double LEAST_SLOPE = 0.5;

    private static final double MOST_SLOPE = 1;

    /** The share of the time that is left that is planned with; a round that could take less more than that is not worth it. */
    private static final double PLANNED_TIME = 0.93;

    private static final double LEAST_WORTH = 1.1;

    /** With fewer samples per pixel the upper end of an interval tells more of the interval than of the error. */
    private static final double FEWEST_TELLING = 64;

    /** The slope of the error counts as measured from this many times the samples of the first telling round. */
    private static final double TOLD_BY = 64;

    /** A render that needs more samples per pixel than these is not begun unless its user says so. */
    private static final double TOO_MANY = 1 << 20;

    /** The limit that goes with {@link #TOO_MANY} for the prediction by independent samples, whose error falls as n^−½. */
    private static final double MANY = 1 << 19;

    private final RenderSettings.Budget budget;

    /** Samples of the first telling round; 0 before that. */
    private double firstSamples;

    private double firstError;

    /** The number of samples that would be needed, where that is too many; 0 before. */
    private double outOfReach;

    /** Samples per pixel of the last round. */
    private double samples;

    private double error;
    private boolean isLimited;

    /** The rounds of one render with this budget. */
    public Rounds(RenderSettings.Budget budget) {
        this.budget = budget;
    }

    /**
     * The number of samples for the next round; empty if the picture is exact enough, or nothing more can be done.
     *
     * @param report of the round that is over
     * @param took seconds that its rendering took
     * @param now seconds since the budget began
     */
    public OptionalDouble next(RenderReport report, double took, double now) {
        RenderReport.Sampling outcome = report.sampling();
        double n = outcome.plannedSamples();
        double most = budget.samples().orElse(RenderSettings.Budget.MAX_SAMPLES);
        double aim = aim(outcome.rounding());
        // What cannot be reached is come as near to as other limits allow.
        boolean isEndless =
                !(aim > 0) && budget.samples().isEmpty() && budget.seconds().isEmpty();
        double high = outcome.errorHigh();
        boolean hasFew = hasFewForUndersampled(outcome);
        if (!hasFew && isMet(outcome) || !(n < most) || isEndless) {
            return OptionalDouble.empty();
        }
        if (budget.samples().isEmpty()
                && budget.seconds().isEmpty()
                && isOutOfReach(n, high, outcome.estimatedError(), aim)) {
            return OptionalDouble.empty();
        }
        double next = hasFew ? Math.max(samplesFor(n, high, aim), FEWEST_TELLING) : samplesFor(n, high, aim);
        if (outcome.method() != report.settings().method()) {
            // The error of the method that is used for few samples tells little of that of the other: it may be far
            // smaller.
            boolean isPhysical = outcome.light().isPresent();
            next = Math.min(
                    next,
                    Integrators.traits(report.settings().method(), report.settings(), isPhysical)
                            .first());
        }
        samples = n;
        error = high;
        if (budget.seconds().isPresent()) {
            double left = PLANNED_TIME * (budget.seconds().getAsDouble() - now);
            double affordable = n * left / took;
            isLimited = affordable < next;
            // In this order what is no number ends it.
            if (!(affordable >= Math.min(next, LEAST_WORTH * n))) {
                return OptionalDouble.empty();
            }
            next = Math.min(affordable, next);
        }
        return OptionalDouble.of(Math.min(Tidy.of(next), most));
    }

    /**
     * About how many samples per pixel would keep the error that was asked for, whatever other limits there were, if it falls as that of
     * independent samples does; empty if it is kept, or no number of samples would do.
     */
    public static OptionalDouble samplesForError(RenderReport report) {
        OptionalDouble asked = report.settings().budget().error();
        RenderReport.Sampling outcome = report.sampling();
        if (asked.isEmpty() || report.isErrorMet()) {
            return OptionalDouble.empty();
        }
        double aim = new Rounds(RenderSettings.Budget.NONE.withError(asked.getAsDouble())).aim(outcome.rounding());
        double least = LEAST_FACTOR * outcome.plannedSamples();
        double n = Math.max(asIndependent(outcome.plannedSamples(), outcome.errorHigh(), aim), least);
        return aim > 0 && n <= RenderSettings.Budget.MAX_SAMPLES
                ? OptionalDouble.of(Tidy.of(n))
                : OptionalDouble.empty();
    }

    /** The number of samples for an error if samples were independent. */
    private static double asIndependent(double n, double e, double aim) {
        return n * StrictMath.pow(e / aim, 1 / LEAST_SLOPE);
    }

    /**
     * Whether the error has fallen so slowly that a render which goes on so would hardly end.
     *
     * @param e the upper end of its interval
     * @param told the error itself, as estimated
     */
    private boolean isOutOfReach(double n, double e, double told, double aim) {
        if (firstSamples == 0 && n >= FEWEST_TELLING) {
            firstSamples = n;
            firstError = e;
        }
        if (firstSamples == 0 || n < TOLD_BY * firstSamples || !(aim > 0)) {
            return false;
        }
        double inAll = StrictMath.log(firstError / e) / StrictMath.log(n / firstSamples);
        double last = StrictMath.log(error / e) / StrictMath.log(n / samples);
        double slope = Math.max(inAll, last);
        double needed = slope > 0 ? n * StrictMath.pow(e / aim, 1 / slope) : Double.POSITIVE_INFINITY;
        // Upper ends jump where rare bright samples come up first: what independent samples of the estimated
        // error would do is tried.
        outOfReach = needed > TOO_MANY && asIndependent(n, told, aim) > MANY ? needed : 0;
        return outOfReach > 0;
    }

    /** Why nothing more is tried though the error is not kept; empty if there is no such reason. */
    public Optional<String> reasonForStopping() {
        if (outOfReach == 0) {
            return Optional.empty();
        }
        String rate = outOfReach <= RenderSettings.Budget.MAX_SAMPLES
                ? "at this rate about " + number(Tidy.of(outOfReach)) + " samples per pixel would be needed"
                : "it has hardly fallen over the last rounds";
        return Optional.of("the error falls too slowly with this method: " + rate
                + "; try another method, or --time or --samples for the best within a limit");
    }

    /** The part of the budget that decided the last number: error, samples or time. */
    public String decidedBy(double next) {
        return isLimited
                ? "time"
                : next < budget.samples().orElse(RenderSettings.Budget.MAX_SAMPLES) ? "error" : "samples";
    }

    /** The note about a picture that a further round follows. */
    public String note(RenderReport report, double next) {
        if (isMet(report.sampling())) {
            return String.format(
                    Locale.ROOT,
                    "%s samples per pixel are too few to tell the error, as some light is undersampled: once more with %s",
                    number(report.sampling().plannedSamples()),
                    number(next));
        }
        return String.format(
                Locale.ROOT,
                "error up to %.3g with %s samples per pixel, more than %s: once more with %s",
                report.sampling().errorInFile(),
                number(report.sampling().plannedSamples()),
                number(budget.error().orElse(0)),
                number(next));
    }

    /**
     * The note where a further round was stopped, or not begun for that reason.
     *
     * @param report of the last round that was not
     */
    public static String stopped(RenderReport report) {
        return "stopped: the picture is that of the round before, with "
                + number(report.sampling().plannedSamples()) + " samples per pixel";
    }

    /** A number with as many digits as it has, and no exponent. */
    public static String number(double value) {
        return BigDecimal.valueOf(value).stripTrailingZeros().toPlainString();
    }

    /**
     * Whether so few samples were taken of a scene with undersampled light that hardly any has found it: they agree without it, and the
     * upper end of the interval lies below the true error more often than not (docs/notes/error-estimation.md).
     */
    private boolean hasFewForUndersampled(RenderReport.Sampling outcome) {
        return budget.error().isPresent()
                && outcome.plannedSamples() < FEWEST_TELLING
                && outcome.light().filter(l -> !l.undersampled().isEmpty()).isPresent();
    }

    private boolean isMet(RenderReport.Sampling outcome) {
        return budget.error().isEmpty()
                || outcome.errorInFile() <= budget.error().getAsDouble();
    }

    /** The error that the samples may leave. */
    private double aim(double rounding) {
        double asked = budget.error().orElse(0);
        return AIM * Math.sqrt(Math.max(asked * asked - rounding * rounding, 0));
    }

    private double samplesFor(double n, double e, double aim) {
        double slope = ErrorSearch.USUAL_SLOPE;
        if (samples > 0 && n > samples) {
            double seen = StrictMath.log(error / e) / StrictMath.log(n / samples);
            slope = seen > LEAST_SLOPE ? Math.min(seen, MOST_SLOPE) : LEAST_SLOPE;
        }
        double factor = StrictMath.pow(e / aim, 1 / slope);
        return n * (factor > LEAST_FACTOR ? Math.min(factor, MOST_FACTOR) : LEAST_FACTOR);
    }
}
