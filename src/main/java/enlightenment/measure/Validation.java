package enlightenment.measure;

import enlightenment.measure.analysis.Configuration;
import enlightenment.measure.analysis.CostEstimate;
import enlightenment.measure.analysis.Curve;
import enlightenment.measure.analysis.Digits;
import enlightenment.measure.analysis.MeasuredCosts;
import enlightenment.measure.analysis.PowerLaw;
import enlightenment.measure.analysis.TradeAnalysis;
import enlightenment.measure.trade.TradeRun;
import java.io.IOException;
import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;

/**
 * Validation of the advice: renders the budget estimated for an error with the scene's own seed. A render is a function of its settings, so
 * that following the advice gives exactly this image and this error.
 */
final class Validation {
    private static final double SHARE = 0.88;
    private static final double SHARE_WITH_SWEEPS = 0.64;
    private static final int MAX_TRIES = 3;
    private static final int REPEATS = 3;

    /** Share of the target from which an error is close enough: a smaller budget would hardly reach the target. */
    private static final double CLOSE_ENOUGH = 0.9;

    /** Limits of the slope of error over samples that the next budget is computed with. */
    private static final double STEEPEST = -1.2;

    private static final double FLATTEST = -0.4;

    private final Session session;

    Validation(Session session) {
        this.session = session;
    }

    /** Validates all methods for an error, with the scene's number of light samples and with the best so far. */
    void run(double target) throws IOException {
        if (target < session.reference().error()) {
            // The target could not be distinguished from the reference's error.
            return;
        }
        session.say("trying the budgets for an error of " + target);
        List<Configuration> found = new ArrayList<>();
        for (Configuration configuration : candidates(target)) {
            if (search(configuration, target)) {
                found.add(configuration);
            }
        }
        for (int k = 1; k < Math.min(session.settings.seeds(), REPEATS); k++) {
            for (Configuration configuration : found) {
                repeat(configuration, target, k);
            }
        }
    }

    private List<Configuration> candidates(double target) {
        Set<Configuration> candidates = new LinkedHashSet<>();
        for (String method : session.settings.methods()) {
            if (session.blind.contains(method)) {
                // The advice never names this method.
                continue;
            }
            candidates.add(Configuration.ofScene(session.settings, method));
            List<MeasuredCosts> costs = session.costs(method).stream()
                    .filter(r -> !r.configuration().grid())
                    .toList();
            TradeAnalysis.fastest(costs, target).ifPresent(n -> candidates.add(n.configuration()));
        }
        return List.copyOf(candidates);
    }

    private double share() {
        return session.settings.sweeps().isEmpty() ? SHARE : SHARE_WITH_SWEEPS;
    }

    private boolean search(Configuration configuration, double target) throws IOException {
        Optional<CostEstimate> estimate = session.costs(configuration).forError(target);
        if (estimate.isEmpty()) {
            return false;
        }
        double slope = Curve.of(
                        configuration,
                        session.runs(r -> true),
                        session.reference().variance())
                .overSamples()
                .map(PowerLaw::slope)
                .orElse(FLATTEST);
        double samples = estimate.get().samples();
        for (int k = 0; k < MAX_TRIES; k++) {
            if (tried(configuration, target, CostEstimate.CLOSE).isPresent()) {
                return true;
            }
            samples = Digits.upTwo(samples);
            if (!session.fits(session.expected(configuration, samples), share())) {
                return false;
            }
            TimedRenderer.Timed render = session.timed(
                    configuration, samples, session.settings.base().seed());
            double error = session.record(TradeRun.CHECK, List.of(render))
                    .get(0)
                    .error(session.reference().variance());
            boolean close = error <= target && (error >= CLOSE_ENOUGH * target || samples <= 1);
            if (close || error == 0) {
                break;
            }
            double steep = Math.min(Math.max(slope, STEEPEST), FLATTEST);
            samples = Math.max(samples * Math.pow(target / error, 1 / steep), 1);
        }
        return tried(configuration, target, 0).isPresent();
    }

    private Optional<CostEstimate> tried(Configuration configuration, double target, double minShare) {
        return session.costs(configuration).tried(target, minShare);
    }

    private void repeat(Configuration configuration, double target, int times) throws IOException {
        CostEstimate cost = tried(configuration, target, CostEstimate.CLOSE)
                .or(() -> tried(configuration, target, 0))
                .orElseThrow();
        double samples = cost.samples();
        if (cost.wall().count() > times || !session.fits(session.expected(configuration, samples), share())) {
            return;
        }
        long seed = session.settings.base().seed();
        TradeRun run = session.runs(r -> r.kind().equals(TradeRun.CHECK)
                        && Configuration.of(r).equals(configuration)
                        && r.samples() == samples)
                .get(0);
        TimedRenderer.Timed again = session.timed(configuration, samples, seed);
        session.record(run.withTimes(again.wall(), again.cpu()));
    }
}
