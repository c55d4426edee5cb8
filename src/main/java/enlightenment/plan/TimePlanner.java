package enlightenment.plan;

import enlightenment.work.Stopwatch;
import java.util.function.BooleanSupplier;
import java.util.function.Consumer;

/** The number of samples that a time is enough for, as far as trials tell. */
final class TimePlanner {
    /** A trial has this share of the blocks, or this many of them if that is more. */
    private static final double SHARE = 1.0 / 16;

    private static final double FEWEST_BLOCKS = 64;

    private final int threads;
    private final SamplePlans plans;
    private final Trial trial;
    private final BooleanSupplier cancelled;
    private final Consumer<String> notes;

    /**
     * @param threads that render
     * @param notes hears what cannot be kept
     */
    TimePlanner(int threads, SamplePlans plans, Trial trial, BooleanSupplier cancelled, Consumer<String> notes) {
        this.threads = threads;
        this.plans = plans;
        this.trial = trial;
        this.cancelled = cancelled;
        this.notes = notes;
    }

    /**
     * The number of samples that take this time: that of the fastest trials, and 1 where there is no time for any. Where it is far more than
     * what is wanted, it is not known any better than that.
     *
     * @param seconds the budget
     * @param time since the budget began
     * @param passes how much time the render takes, in multiples of what its samples take
     * @param wanted the samples per pixel that are taken if there is time for them
     */
    double samples(double seconds, Stopwatch time, double passes, double wanted) {
        Trial.Piece piece = trial.piece(SHARE, FEWEST_BLOCKS);
        Pace pace = new Pace(seconds, plans.tracedPixels() * passes, piece.pixels(), wanted);
        BooleanSupplier over = () -> cancelled.getAsBoolean() || time.seconds() >= seconds;
        boolean surveyed = false;
        do {
            double n = pace.next();
            if (plans.isSurveyed(n) != surveyed) {
                surveyed = !surveyed;
                pace.otherRays();
                // What is worked out only once must not count as part of a trial.
                plans.prepareSurveyed();
                // How fast other rays are is not known yet.
                n = surveyed ? plans.traits().fewest() : n;
            }
            double before = time.seconds();
            double processors = time.processorSeconds();
            double worked = trial.processorSeconds();
            piece.render(n, over);
            double now = time.seconds();
            if (!over.getAsBoolean()) {
                double took = undisturbed(
                        now - before, time.processorSeconds() - processors, trial.processorSeconds() - worked);
                pace.tried(n, took, now);
            }
        } while (!over.getAsBoolean()
                && !(pace.isPlenty() && plans.isSurveyed(wanted) == surveyed)
                && pace.isWorthTrying());
        double planned = pace.planned(time.seconds());
        if (planned < 1 && !cancelled.getAsBoolean()) {
            notes.accept(
                    "time " + Rounds.number(seconds) + " s is too short: the least is taken, one sample per pixel");
        }
        return plans.isSurveyed(planned) && !surveyed ? plans.traits().mostBelow() : Tidy.of(planned);
    }

    /**
     * The duration of a trial without the just-in-time compiler's share. The compiler shares the processors with the first seconds of a
     * render, and with little of the rest.
     *
     * @param took its duration
     * @param processors seconds of all threads of this process meanwhile
     * @param worked those of the trial alone
     */
    private double undisturbed(double took, double processors, double worked) {
        if (!(processors > worked) || !(worked > 0)) {
            return took;
        }
        return Math.min(Math.max(took * (worked / processors), worked / threads), took);
    }
}
