package enlightenment.measure;

import java.io.IOException;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;

/**
 * Tries the advice before it is given. What the ladder says an error needs is rendered with the scene's own seed, as whoever
 * follows the advice will do: a render is a function of its settings, so they will see this very picture and this very error.
 */
final class Trial {
    private static final double SHARE = 0.93;
    private static final double SHARE_WITH_SWEEPS = 0.65;
    private static final int MOST_TRIES = 3;
    private static final int REPEATS = 3;

    /** An error this close below the one that is wanted will do, and this little above it. */
    private static final double CLOSE_ENOUGH = 0.9;

    private static final double STILL = 0.85;
    private static final double A_LITTLE_ABOVE = 1.02;
    private static final double OF_REFERENCE = 0.5;
    private static final double STEEPEST = -1.2;
    private static final double FLATTEST = -0.4;

    private final Session session;

    Trial(Session session) {
        this.session = session;
    }

    /** Tries all methods for an error, in turns. */
    void run(double target) throws IOException {
        session.say("trying what an error of " + target + " needs");
        List<String> found = new ArrayList<>();
        for (String method : session.settings.methods()) {
            if (search(method, target)) {
                found.add(method);
            }
        }
        for (int k = 1; k < Math.min(session.settings.seeds(), REPEATS); k++) {
            for (String method : found) {
                repeat(method, target, k);
            }
        }
    }

    private double share() {
        return session.settings.sweeps().isEmpty() ? SHARE : SHARE_WITH_SWEEPS;
    }

    private boolean search(String method, double target) throws IOException {
        Curve curve = session.curve(method);
        Optional<Curve.Estimate> estimate = curve.samplesFor(target);
        if (estimate.isEmpty() || !estimate.get().measured() && estimate.get().samples() > mostSamples()) {
            return false;
        }
        double slope = curve.overSamples().map(PowerLaw::slope).orElse(FLATTEST);
        double samples = estimate.get().samples();
        for (int k = 0; k < MOST_TRIES; k++) {
            if (tried(method, target, STILL).isPresent()) {
                return true;
            }
            samples = Digits.upTwo(samples);
            if (!session.fits(session.expected(method, samples), share())) {
                return false;
            }
            Meter.Timed render =
                    session.timed(method, samples, session.settings.base().seed());
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
        return tried(method, target, 0).isPresent();
    }

    /** With more samples than this, a render could not be told from the reference. */
    private double mostSamples() {
        return OF_REFERENCE
                * session.reference().parts().stream()
                        .mapToDouble(Reference.Part::samples)
                        .min()
                        .orElse(0);
    }

    private void repeat(String method, double target, int times) throws IOException {
        List<TradeRun> runs = best(method, target).orElseThrow();
        double samples = runs.get(0).samples();
        if (runs.size() > times || !session.fits(session.expected(method, samples), share())) {
            return;
        }
        Meter.Timed again =
                session.timed(method, samples, session.settings.base().seed());
        session.record(runs.get(0).withTimes(again.wall(), again.cpu()));
    }

    /** What comes closest from below; where an error jumps past the one that is wanted, anything below it. */
    private Optional<List<TradeRun>> best(String method, double target) {
        Optional<List<TradeRun>> close = tried(method, target, STILL);
        return close.isPresent() ? close : tried(method, target, 0);
    }

    /** The runs of the cheapest budget that was tried and gives the error, or less of it down to a share. */
    private Optional<List<TradeRun>> tried(String method, double target, double leastShare) {
        double variance = session.reference().variance();
        Map<Double, List<TradeRun>> bySamples = new TreeMap<>();
        for (TradeRun run :
                session.runs(r -> r.method().equals(method) && r.kind().equals(TradeRun.CHECK))) {
            bySamples.computeIfAbsent(run.samples(), n -> new ArrayList<>()).add(run);
        }
        return bySamples.values().stream()
                .filter(runs -> {
                    double error = runs.get(0).error(variance);
                    boolean least = runs.get(0).samples() <= 1;
                    return error <= A_LITTLE_ABOVE * target && (least || error >= leastShare * target);
                })
                .min(Comparator.comparingDouble(runs -> runs.get(0).samples()));
    }

    /** What a method needs for an error, as well as it is known by now. */
    Optional<Need> need(String method, double target) {
        Optional<List<TradeRun>> tried = best(method, target);
        if (tried.isPresent()) {
            List<TradeRun> runs = tried.get();
            return Optional.of(new Need(
                    method,
                    target,
                    runs.get(0).samples(),
                    runs.get(0).error(session.reference().variance()),
                    Spread.of(runs.stream().map(TradeRun::wallSeconds).toList()),
                    Optional.of(
                            Spread.of(runs.stream().map(TradeRun::cpuSeconds).toList())),
                    Need.Source.TRIED));
        }
        return session.curve(method)
                .samplesFor(target)
                .map(e -> new Need(
                        method,
                        target,
                        Digits.upTwo(e.samples()),
                        e.error(),
                        Spread.of(e.wall()),
                        Optional.empty(),
                        e.measured() ? Need.Source.BETWEEN : Need.Source.BEYOND));
    }
}
