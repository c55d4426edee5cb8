package enlightenment.measure.analysis;

import enlightenment.measure.trade.Spread;
import enlightenment.measure.trade.Sweep;
import enlightenment.measure.trade.TradeRun;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;

/**
 * Time and accuracy of each value of a swept setting.
 *
 * @param sweep the setting and the values asked for
 * @param method the method of all renders
 * @param points the rendered values, ascending
 */
public record SweepResult(Sweep sweep, String method, List<Point> points) {
    public SweepResult {
        points = List.copyOf(points);
    }

    /**
     * The runs with one value.
     *
     * @param value the value of the setting
     * @param wall seconds by the clock
     * @param cpu seconds of all processors
     * @param error root mean square error, the reference's taken off
     * @param judged whether every run's error can be distinguished from the reference's
     */
    public record Point(int value, Spread wall, Spread cpu, Spread error, boolean judged) {}

    /** The values of a sweep as the runs show them; those of other kinds are ignored. */
    public static SweepResult of(Sweep sweep, String method, List<TradeRun> all, double referenceVariance) {
        Map<Integer, List<TradeRun>> byValue = new TreeMap<>();
        for (TradeRun run : all) {
            if (run.kind().equals(sweep.kind())) {
                byValue.computeIfAbsent(sweep.valueOf(run), v -> new ArrayList<>())
                        .add(run);
            }
        }
        List<Point> points = new ArrayList<>();
        byValue.forEach((value, runs) -> points.add(point(value, runs, referenceVariance)));
        return new SweepResult(sweep, method, points);
    }

    private static Point point(int value, List<TradeRun> runs, double referenceVariance) {
        return new Point(
                value,
                Spread.of(runs.stream().map(TradeRun::wallSeconds).toList()),
                Spread.of(runs.stream().map(TradeRun::cpuSeconds).toList()),
                Spread.of(runs.stream().map(r -> r.error(referenceVariance)).toList()),
                runs.stream().allMatch(r -> r.isJudged(referenceVariance)));
    }
}
