package enlightenment.measure;

import java.io.IOException;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;

/**
 * Renders with 1, 2, 4, ... samples per pixel (and 2.5), several times each. The methods take turns, render by render: a machine with
 * neighbours then disturbs all of them alike. A method that takes a number of light points climbs with others as well, as far as
 * there is time and as long as they are worth it.
 */
final class Ladder {
    private static final double SHARE = 0.72;
    private static final double SHARE_WITH_SWEEPS = 0.52;

    /** These are rendered once whatever they take: with fewer there is nothing to tell. */
    private static final int LEAST_RUNGS = 4;

    /** Powers of two, which the samplers like best, and where the cluster method begins to have a survey: from there it is another. */
    private static final double[] SAMPLES = {1, 2, 2.5, 4, 8, 16, 32, 64, 128, 256, 512, 1024, 2048, 4096};

    /** One sample tells little of how many light points are best, and half samples are of interest to surveys only. */
    private static final int VARIANTS_FROM = 2;

    /** A render with more than this share of the reference's samples has nothing better to be compared with. */
    private static final double OF_REFERENCE = 0.25;

    /** Seeds of neighbouring rungs are this far apart, so that no two renders share their random numbers. */
    private static final long RUNG = TradeSettings.MAX_SEEDS;

    private final Session session;

    Ladder(Session session) {
        this.session = session;
    }

    void climb() throws IOException {
        for (int rung = 0; rung < rungs(); rung++) {
            double samples = SAMPLES[rung];
            session.say(samples == 1 ? "1 sample per pixel" : Digits.samples(samples) + " samples per pixel");
            boolean none = true;
            for (int k = 0; k < session.settings.seeds(); k++) {
                List<Contender> climbers = climbers(rung, k);
                if (!climbers.isEmpty()) {
                    step(climbers, samples, session.settings.base().seed() + 1 + k + rung * RUNG, k);
                    none = false;
                }
            }
            if (none) {
                return;
            }
        }
    }

    /** Who takes this rung: the methods as the scene has them, then what fits in of the rest, the cheapest first. */
    private List<Contender> climbers(int rung, int turn) {
        double samples = SAMPLES[rung];
        List<Contender> own =
                session.settings.methods().stream().map(session.settings::own).toList();
        boolean needed = rung < LEAST_RUNGS && turn == 0;
        List<Contender> climbers = new ArrayList<>();
        if (needed || own.stream().noneMatch(c -> isDone(c, rung)) && fits(own, samples)) {
            climbers.addAll(own);
        }
        List<Contender> others = new ArrayList<>(own);
        if (samples >= VARIANTS_FROM && samples == Math.rint(samples)) {
            others.addAll(variants(own));
        }
        others.sort(Comparator.comparingDouble(c -> session.expected(c, samples)));
        for (Contender other : others) {
            if (!climbers.contains(other) && !isDone(other, rung)) {
                climbers.add(other);
                if (!fits(climbers, samples)) {
                    climbers.remove(other);
                }
            }
        }
        return climbers;
    }

    /** Whether its error went below the reference's own: more samples would tell nothing. */
    private boolean isDone(Contender contender, int rung) {
        return rung >= LEAST_RUNGS
                && Curve.of(
                                contender,
                                session.runs(r -> r.samples() == SAMPLES[rung - 1]),
                                session.reference().variance())
                        .points()
                        .stream()
                        .anyMatch(p -> !p.judged());
    }

    private List<Contender> variants(List<Contender> own) {
        List<TradeRun> ladder = session.runs(r -> r.kind().equals(TradeRun.LADDER));
        return own.stream()
                .flatMap(c -> Variants.worthGoingOn(c, ladder).stream())
                .toList();
    }

    private boolean fits(List<Contender> contenders, double samples) {
        double share = session.settings.sweeps().isEmpty() ? SHARE : SHARE_WITH_SWEEPS;
        double seconds = contenders.stream()
                .mapToDouble(c -> session.expected(c, samples))
                .sum();
        return session.fits(seconds, share);
    }

    private int rungs() {
        double most = session.reference().parts().stream()
                .mapToDouble(Reference.Part::samples)
                .min()
                .orElse(Double.POSITIVE_INFINITY);
        int rungs = LEAST_RUNGS;
        while (rungs < SAMPLES.length && SAMPLES[rungs] <= OF_REFERENCE * most) {
            rungs++;
        }
        return rungs;
    }

    private void step(List<Contender> contenders, double samples, long seed, int turn) throws IOException {
        List<Meter.Timed> renders = new ArrayList<>();
        for (int i = 0; i < contenders.size(); i++) {
            // Who goes first changes, too.
            Contender contender = contenders.get((i + turn) % contenders.size());
            boolean done = session.has(r -> r.kind().equals(TradeRun.LADDER)
                    && Contender.of(r).equals(contender)
                    && r.samples() == samples
                    && r.seed() == seed);
            if (!done) {
                renders.add(session.timed(contender, samples, seed));
            }
        }
        session.record(TradeRun.LADDER, renders);
    }
}
