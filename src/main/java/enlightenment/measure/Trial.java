package enlightenment.measure;

import java.io.IOException;
import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;

/**
 * Tries the advice before it is given. What the ladder says an error needs is rendered with the scene's own seed, as whoever
 * follows the advice will do: a render is a function of its settings, so they will see this very picture and this very error.
 */
final class Trial {
    private static final double SHARE = 0.88;
    private static final double SHARE_WITH_SWEEPS = 0.64;
    private static final int MOST_TRIES = 3;
    private static final int REPEATS = 3;

    /** An error this close below the one that is wanted will do, and this little above it. */
    private static final double CLOSE_ENOUGH = 0.9;

    private static final double STILL = 0.85;
    private static final double STEEPEST = -1.2;
    private static final double FLATTEST = -0.4;

    private final Session session;

    Trial(Session session) {
        this.session = session;
    }

    /** Tries all methods for an error, in turns: with the scene's light points, and with the number that seems best. */
    void run(double target) throws IOException {
        if (target < session.reference().error()) {
            // Nothing could be told of it.
            return;
        }
        session.say("trying what an error of " + target + " needs");
        List<Contender> found = new ArrayList<>();
        for (Contender contender : candidates(target)) {
            if (search(contender, target)) {
                found.add(contender);
            }
        }
        for (int k = 1; k < Math.min(session.settings.seeds(), REPEATS); k++) {
            for (Contender contender : found) {
                repeat(contender, target, k);
            }
        }
    }

    private List<Contender> candidates(double target) {
        Set<Contender> candidates = new LinkedHashSet<>();
        for (String method : session.settings.methods()) {
            candidates.add(session.settings.own(method));
            List<Reach> reaches = session.reaches(method).stream()
                    .filter(r -> !r.contender().grid())
                    .toList();
            TradeResult.quickest(reaches, target).ifPresent(n -> candidates.add(n.contender()));
        }
        return List.copyOf(candidates);
    }

    private double share() {
        return session.settings.sweeps().isEmpty() ? SHARE : SHARE_WITH_SWEEPS;
    }

    private boolean search(Contender contender, double target) throws IOException {
        Optional<Need> estimate = session.reach(contender).forError(target);
        if (estimate.isEmpty()) {
            return false;
        }
        double slope = Curve.of(
                        contender, session.runs(r -> true), session.reference().variance())
                .overSamples()
                .map(PowerLaw::slope)
                .orElse(FLATTEST);
        double samples = estimate.get().samples();
        for (int k = 0; k < MOST_TRIES; k++) {
            if (tried(contender, target, STILL).isPresent()) {
                return true;
            }
            samples = Digits.upTwo(samples);
            if (!session.fits(session.expected(contender, samples), share())) {
                return false;
            }
            Meter.Timed render =
                    session.timed(contender, samples, session.settings.base().seed());
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
        return tried(contender, target, 0).isPresent();
    }

    private Optional<Need> tried(Contender contender, double target, double leastShare) {
        return session.reach(contender).tried(target, leastShare);
    }

    private void repeat(Contender contender, double target, int times) throws IOException {
        Need need = tried(contender, target, STILL)
                .or(() -> tried(contender, target, 0))
                .orElseThrow();
        double samples = need.samples();
        if (need.wall().count() > times || !session.fits(session.expected(contender, samples), share())) {
            return;
        }
        long seed = session.settings.base().seed();
        TradeRun run = session.runs(r ->
                        r.kind().equals(TradeRun.CHECK) && Contender.of(r).equals(contender) && r.samples() == samples)
                .get(0);
        Meter.Timed again = session.timed(contender, samples, seed);
        session.record(run.withTimes(again.wall(), again.cpu()));
    }
}
