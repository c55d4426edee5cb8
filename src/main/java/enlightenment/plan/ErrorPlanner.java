package enlightenment.plan;

import enlightenment.check.Check;
import enlightenment.scene.RenderSettings;
import java.util.Locale;
import java.util.function.BooleanSupplier;
import java.util.function.Consumer;

/** The number of samples that an error takes, as far as trials tell. */
final class ErrorPlanner {
    /** The number of samples that a search begins with where no picture is surveyed. */
    private static final double FEW_SAMPLES = 2;

    /** Share of the squared error above which a file with more bits would take far fewer samples. */
    private static final double MUCH_ROUNDING = 0.5;

    private final RenderSettings settings;
    private final SamplePlans plans;
    private final Trial trial;
    private final BooleanSupplier stop;
    private final Consumer<String> notes;
    private final boolean isLast;

    /**
     * @param stop once true, nothing more is tried
     * @param notes hears what cannot be kept, or only at a price
     * @param isLast whether no round follows the picture that is planned
     */
    ErrorPlanner(
            RenderSettings settings,
            SamplePlans plans,
            Trial trial,
            BooleanSupplier stop,
            Consumer<String> notes,
            boolean isLast) {
        this.isLast = isLast;
        this.settings = settings;
        this.plans = plans;
        this.trial = trial;
        this.stop = stop;
        this.notes = notes;
    }

    /** The number of samples for which the error is as asked; at most {@code most}, which it also is if it is stopped. */
    double samples(double most) {
        TrialBlocks blocks =
                new TrialBlocks(settings, trial.display(), plans.traits().blockSide());
        ErrorTrials trials = new ErrorTrials(settings, blocks, (n, some) -> trial.render(n, some, stop), stop, isLast);
        double found = 1;
        if (trials.areTooFew()) {
            // The first round is the trial of all but the file.
            trials.findRounding();
        } else {
            found = search(trials, most);
        }
        if (!stop.getAsBoolean()) {
            checkRounding(trials);
        }
        return Math.min(found, most);
    }

    private double search(ErrorTrials trials, double most) {
        MethodTraits traits = plans.traits();
        if (!plans.isSurveyed(most)) {
            return trials.search(1, FEW_SAMPLES, most, 0);
        }
        // The error jumps where surveys begin: both sides of it are searched. Where evenly spaced rays are enough, they
        // are fewer.
        double plain = trials.search(1, 1, traits.mostBelow(), 0);
        return plain <= traits.mostBelow() || trials.isHopeless()
                ? plain
                : trials.search(traits.fewest(), traits.first(), most, plans.planningRays());
    }

    /** Refuses an error that no number of samples can keep in this file. */
    private void checkRounding(ErrorTrials trials) {
        RenderSettings.Budget budget = settings.budget();
        double asked = budget.error().orElseThrow();
        double part = trials.rounding() / asked;
        if (part * part <= MUCH_ROUNDING) {
            return;
        }
        String said = String.format(
                Locale.ROOT,
                "rounding to %d bits makes an error of about %.2g, of %s that is asked for",
                budget.depth(),
                trials.rounding(),
                Rounds.number(asked));
        boolean isLimited = budget.samples().isPresent() || budget.seconds().isPresent();
        Check.that(isLimited || !trials.isHopeless(), "error", "cannot be kept: " + said);
        notes.accept(said + (trials.isHopeless() ? ": it cannot be kept" : ": more bits would take far fewer samples"));
    }
}
