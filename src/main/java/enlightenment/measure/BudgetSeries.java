package enlightenment.measure;

import enlightenment.measure.analysis.Configuration;
import enlightenment.measure.analysis.Curve;
import enlightenment.measure.analysis.Digits;
import enlightenment.measure.trade.TradeRun;
import enlightenment.measure.trade.TradeSettings;
import java.io.IOException;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;

/**
 * The series of renders with budgets of 1, 2, 4, ... samples per pixel (and 2.5), several times each. Methods alternate render by render, so that
 * other load of the machine affects all of them alike. A method is left out of budgets at which another one replaces it. A method with a fixed
 * number of light samples also runs with other numbers, as far as time allows and while they may still be the best.
 */
final class BudgetSeries {
    private static final double SHARE = 0.72;
    private static final double SHARE_WITH_SWEEPS = 0.52;

    /** Number of budgets that are rendered at least once, whatever their time: fewer give no curve. */
    private static final int MIN_BUDGETS = 4;

    /** Number of budgets that each method left out of the first ones renders at least. */
    private static final int MIN_OWN_BUDGETS = 2;

    /** The budgets: powers of two, at which low-discrepancy samples are best, and 2.5, where the cluster method begins its survey. */
    private static final double[] SAMPLES = {1, 2, 2.5, 4, 8, 16, 32, 64, 128, 256, 512, 1024, 2048, 4096};

    /** The least budget, in samples per pixel, with other numbers of light samples; fractional budgets have none either. */
    private static final int VARIANTS_FROM = 2;

    /**
     * The largest budget as a share of the reference's by the same method. Above it, the reference would not be clearly more accurate.
     */
    private static final double MAX_OF_REFERENCE = 0.25;

    /** Distance of the seeds of neighbouring budgets, so that no two renders share random numbers. */
    private static final long SEED_STEP = TradeSettings.MAX_SEEDS;

    private final Session session;

    BudgetSeries(Session session) {
        this.session = session;
    }

    void run() throws IOException {
        for (int index = 0; index < SAMPLES.length; index++) {
            double samples = SAMPLES[index];
            session.say(samples == 1 ? "1 sample per pixel" : Digits.samples(samples) + " samples per pixel");
            boolean none = true;
            for (int k = 0; k < session.settings.seeds(); k++) {
                List<Configuration> takers = configurations(index, k);
                if (!takers.isEmpty()) {
                    step(takers, samples, session.settings.base().seed() + 1 + k + index * SEED_STEP, k);
                    none = false;
                }
            }
            if (none && index >= lastNeeded()) {
                return;
            }
        }
    }

    /** Configurations that render a budget: the scene's own of each method, then variants that fit, the cheapest first. */
    private List<Configuration> configurations(int index, int turn) {
        double samples = SAMPLES[index];
        List<Configuration> own = session.settings.methods().stream()
                .filter(m -> samples >= session.fewest(m))
                .map(m -> Configuration.ofScene(session.settings, m))
                .filter(c -> isNeeded(c, index) || isBelowTheReference(c.method(), samples))
                .toList();
        List<Configuration> chosen = new ArrayList<>();
        if (own.stream().noneMatch(c -> isDone(c, index)) && fits(own, samples)) {
            chosen.addAll(own);
        } else if (turn == 0) {
            own.stream().filter(c -> isNeeded(c, index)).forEach(chosen::add);
        }
        List<Configuration> others = new ArrayList<>(own);
        if (samples >= VARIANTS_FROM && samples == Math.rint(samples)) {
            others.addAll(variants(own));
        }
        others.sort(Comparator.comparingDouble(c -> session.expected(c, samples)));
        for (Configuration other : others) {
            if (!chosen.contains(other) && !isDone(other, index)) {
                chosen.add(other);
                if (!fits(chosen, samples)) {
                    chosen.remove(other);
                }
            }
        }
        return chosen;
    }

    private int lastNeeded() {
        return session.settings.methods().stream()
                .mapToInt(m -> first(m) + MIN_OWN_BUDGETS - 1)
                .reduce(MIN_BUDGETS - 1, Math::max);
    }

    private boolean isNeeded(Configuration own, int index) {
        return index < MIN_BUDGETS || index < first(own.method()) + MIN_OWN_BUDGETS;
    }

    /** Index of the first budget that a method renders. */
    private int first(String method) {
        int index = 0;
        while (SAMPLES[index] < session.fewest(method)) {
            index++;
        }
        return index;
    }

    /** Whether a smaller budget had an error indistinguishable from the reference's, so that larger ones add nothing. */
    private boolean isDone(Configuration configuration, int index) {
        return index >= MIN_BUDGETS
                && !isNeeded(configuration, index)
                && Curve.of(
                                configuration,
                                session.runs(r -> r.samples() > 0 && r.samples() < SAMPLES[index]),
                                session.reference().variance())
                        .points()
                        .stream()
                        .anyMatch(p -> !p.judged());
    }

    private List<Configuration> variants(List<Configuration> own) {
        List<TradeRun> series = session.runs(r -> r.kind().equals(TradeRun.BUDGET_SERIES));
        return own.stream()
                .flatMap(c -> Variants.worthwhile(c, series).stream())
                .toList();
    }

    private boolean fits(List<Configuration> configurations, double samples) {
        double share = session.settings.sweeps().isEmpty() ? SHARE : SHARE_WITH_SWEEPS;
        double seconds = configurations.stream()
                .mapToDouble(c -> session.expected(c, samples))
                .sum();
        return session.fits(seconds, share);
    }

    /** Whether the reference would be clearly more accurate than a budget; true for methods that the reference does not use. */
    private boolean isBelowTheReference(String method, double samples) {
        return session.reference().parts().stream()
                .filter(part -> part.method().equals(method))
                .allMatch(part -> samples <= MAX_OF_REFERENCE * part.samples());
    }

    private void step(List<Configuration> configurations, double samples, long seed, int turn) throws IOException {
        List<TimedRenderer.Timed> renders = new ArrayList<>();
        for (int i = 0; i < configurations.size(); i++) {
            // The order rotates with each turn, as the first render may find the machine in another state.
            Configuration configuration = configurations.get((i + turn) % configurations.size());
            boolean done = session.has(r -> r.kind().equals(TradeRun.BUDGET_SERIES)
                    && Configuration.of(r).equals(configuration)
                    && r.samples() == samples
                    && r.seed() == seed);
            if (!done) {
                renders.add(session.timed(configuration, samples, seed));
            }
        }
        session.record(TradeRun.BUDGET_SERIES, renders);
    }
}
