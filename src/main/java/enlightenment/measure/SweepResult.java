package enlightenment.measure;

import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;

/**
 * What each notch of a switch costs and buys.
 *
 * @param sweep the switch and the notches asked for
 * @param method the method that was used
 * @param points the notches that there was time for, ascending
 */
public record SweepResult(Sweep sweep, String method, List<Point> points) {
    public SweepResult {
        points = List.copyOf(points);
    }

    /**
     * One notch.
     *
     * @param value where the switch stands
     * @param wall seconds by the clock
     * @param cpu seconds of all processors
     * @param error root mean square error, without the reference's
     * @param judged whether the error is known: no smaller than the reference's own
     */
    public record Point(int value, Spread wall, Spread cpu, Spread error, boolean judged) {}

    /** Turns the switch as far as the time goes: up to this share of the budget. The first two notches come in any case. */
    static void run(Session session, Sweep sweep, double share) throws IOException {
        double last = 0;
        for (int i = 0; i < sweep.values().size(); i++) {
            int value = sweep.values().get(i);
            session.say(sweep.name() + " " + value);
            for (int k = 0; k < session.settings.seeds(); k++) {
                if ((i > 1 || k > 0) && !session.fits(last, share)) {
                    return;
                }
                long seed = session.settings.base().seed() + 1 + k;
                boolean done = session.has(
                        r -> r.kind().equals(sweep.kind()) && sweep.valueOf(r) == value && r.seed() == seed);
                if (!done) {
                    Meter.Timed render = session.meter.render(
                            sweep.at(session.settings.base(), value).withSeed(seed));
                    last = render.wall();
                    session.record(sweep.kind(), List.of(render));
                }
            }
        }
    }

    /** What the runs tell of a sweep. */
    static SweepResult of(Sweep sweep, String method, List<TradeRun> all, double variance) {
        Map<Integer, List<TradeRun>> byValue = new TreeMap<>();
        for (TradeRun run : all) {
            if (run.kind().equals(sweep.kind())) {
                byValue.computeIfAbsent(sweep.valueOf(run), v -> new ArrayList<>())
                        .add(run);
            }
        }
        List<Point> points = new ArrayList<>();
        byValue.forEach((value, runs) -> points.add(new Point(
                value,
                Spread.of(runs.stream().map(TradeRun::wallSeconds).toList()),
                Spread.of(runs.stream().map(TradeRun::cpuSeconds).toList()),
                Spread.of(runs.stream().map(r -> r.error(variance)).toList()),
                runs.stream().allMatch(r -> r.isJudged(variance)))));
        return new SweepResult(sweep, method, points);
    }
}
