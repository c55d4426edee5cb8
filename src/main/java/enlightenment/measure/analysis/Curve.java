package enlightenment.measure.analysis;

import enlightenment.measure.trade.Spread;
import enlightenment.measure.trade.TradeRun;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;

/**
 * Error and time of one configuration over its budgets of 1, 2, 4, ... samples per pixel.
 *
 * @param configuration method and number of light samples
 * @param points points, one for each budget, by ascending samples
 * @param overSamples the fitted power law of error over samples per pixel, if at least two budgets could be judged
 * @param overTime the fitted power law of error over seconds by the clock, of the budgets that take at least twice as long as the
 *     shortest render: below that, fixed costs dominate
 * @param insideOwnInterval number of judged runs with the measured error in the render's own 95 % interval
 * @param judged number of runs with an error that can be distinguished from the reference's
 */
public record Curve(
        Configuration configuration,
        List<Point> points,
        Optional<PowerLaw> overSamples,
        Optional<PowerLaw> overTime,
        int insideOwnInterval,
        int judged) {
    /** Ratio to the shortest time from which fixed costs do not dominate a render. */
    private static final double FIXED_COST = 2;

    public Curve {
        points = List.copyOf(points);
    }

    /**
     * The runs of one budget.
     *
     * @param samples the budget of camera rays per pixel
     * @param samplesPerPixel camera rays per pixel that were traced
     * @param wall seconds by the clock
     * @param cpu seconds of all processors
     * @param error root mean square error, the reference's taken off
     * @param flip mean FLIP difference
     * @param estimated the error that the renders estimated of themselves
     * @param judged whether every run's error can be distinguished from the reference's
     */
    public record Point(
            double samples,
            double samplesPerPixel,
            Spread wall,
            Spread cpu,
            Spread error,
            Spread flip,
            Spread estimated,
            boolean judged) {}

    /** The curve of a configuration from its runs of kind {@link TradeRun#BUDGET_SERIES}; other runs are ignored. */
    public static Curve of(Configuration configuration, List<TradeRun> runs, double referenceVariance) {
        List<TradeRun> series = runs.stream()
                .filter(r -> r.kind().equals(TradeRun.BUDGET_SERIES)
                        && Configuration.of(r).equals(configuration))
                .toList();
        List<Point> points = points(series, referenceVariance);
        List<TradeRun> judged = series.stream()
                .filter(r -> points.stream().anyMatch(p -> p.judged && p.samples == budget(r)))
                .toList();
        double[] error =
                judged.stream().mapToDouble(r -> r.error(referenceVariance)).toArray();
        double[] samples =
                judged.stream().mapToDouble(TradeRun::samplesPerPixel).toArray();
        int inside = 0;
        for (int i = 0; i < error.length; i++) {
            TradeRun run = judged.get(i);
            inside += run.estimatedLow() <= error[i] && error[i] <= run.estimatedHigh() ? 1 : 0;
        }
        return new Curve(
                configuration,
                points,
                fit(samples, error),
                overTime(judged, points, referenceVariance),
                inside,
                error.length);
    }

    /** A fit, if there are two different x. Small budgets of a method with a survey may have equal numbers of samples. */
    private static Optional<PowerLaw> fit(double[] x, double[] y) {
        return Arrays.stream(x).distinct().count() < 2 ? Optional.empty() : Optional.of(PowerLaw.fit(x, y));
    }

    private static Optional<PowerLaw> overTime(List<TradeRun> judged, List<Point> points, double variance) {
        double shortest =
                points.stream().mapToDouble(p -> p.wall.median()).min().orElse(0);
        List<Point> slow = points.stream()
                .filter(p -> p.judged && p.wall.median() >= FIXED_COST * shortest)
                .toList();
        List<TradeRun> runs = judged.stream()
                .filter(r -> slow.stream().anyMatch(p -> p.samples == budget(r)))
                .toList();
        if (slow.size() < 2) {
            return Optional.empty();
        }
        return fit(
                runs.stream().mapToDouble(TradeRun::wallSeconds).toArray(),
                runs.stream().mapToDouble(r -> r.error(variance)).toArray());
    }

    /** Points of the budgets, each from all of its runs, by ascending budget. */
    static List<Point> points(List<TradeRun> runs, double referenceVariance) {
        Map<Double, List<TradeRun>> bySamples = new TreeMap<>();
        for (TradeRun run : runs) {
            bySamples.computeIfAbsent(budget(run), n -> new ArrayList<>()).add(run);
        }
        return bySamples.values().stream()
                .map(same -> point(same, referenceVariance))
                .toList();
    }

    private static double budget(TradeRun run) {
        return run.samples() == 0 ? run.antialias() * run.antialias() : run.samples();
    }

    private static Point point(List<TradeRun> same, double referenceVariance) {
        return new Point(
                budget(same.get(0)),
                same.get(0).samplesPerPixel(),
                Spread.of(same.stream().map(TradeRun::wallSeconds).toList()),
                Spread.of(same.stream().map(TradeRun::cpuSeconds).toList()),
                Spread.of(same.stream().map(r -> r.error(referenceVariance)).toList()),
                Spread.of(same.stream().map(TradeRun::flip).toList()),
                Spread.of(same.stream().map(TradeRun::estimatedError).toList()),
                same.stream().allMatch(r -> r.isJudged(referenceVariance)));
    }

    /** The method. */
    public String method() {
        return configuration.method();
    }

    /** The points whose error can be distinguished from the reference's. */
    public List<Point> judgedPoints() {
        return points.stream().filter(Point::judged).toList();
    }
}
