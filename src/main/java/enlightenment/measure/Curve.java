package enlightenment.measure;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;

/**
 * What a contender's ladder of budgets cost and bought.
 *
 * @param contender method and number of light points
 * @param points one for each budget, by ascending samples
 * @param overSamples the fitted line of error over samples per pixel taken, if two budgets or more could be judged
 * @param overTime the fitted line of error over seconds by the clock, of those budgets that take at least twice as long as
 *     the shortest render: before, the time goes into what every render has to do
 * @param insideOwnInterval in how many of the runs the true error lay inside the interval that the render gave itself
 * @param judged how many runs could be judged
 */
public record Curve(
        Contender contender,
        List<Point> points,
        Optional<PowerLaw> overSamples,
        Optional<PowerLaw> overTime,
        int insideOwnInterval,
        int judged) {
    private static final double START = 2;

    public Curve {
        points = List.copyOf(points);
    }

    /**
     * The runs of one budget.
     *
     * @param samples the budget of camera rays per pixel
     * @param samplesPerPixel camera rays per pixel that were taken
     * @param wall seconds by the clock
     * @param cpu seconds of all processors
     * @param error root mean square error, without the reference's
     * @param flip mean FLIP difference
     * @param estimated the error that the renders expected of themselves
     * @param judged whether every run differs enough from the reference to be judged
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

    /** The curve of a contender's ladder; other runs are passed over. */
    static Curve of(Contender contender, List<TradeRun> runs, double referenceVariance) {
        List<TradeRun> ladder = runs.stream()
                .filter(r -> r.kind().equals(TradeRun.LADDER) && Contender.of(r).equals(contender))
                .toList();
        List<Point> points = points(ladder, referenceVariance);
        List<TradeRun> judged = ladder.stream()
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
                contender,
                points,
                fit(samples, error),
                overTime(judged, points, referenceVariance),
                inside,
                error.length);
    }

    /** A line needs two places; small budgets of a method with a survey may all come to the same number of samples. */
    private static Optional<PowerLaw> fit(double[] x, double[] y) {
        return Arrays.stream(x).distinct().count() < 2 ? Optional.empty() : Optional.of(PowerLaw.fit(x, y));
    }

    private static Optional<PowerLaw> overTime(List<TradeRun> judged, List<Point> points, double variance) {
        double shortest =
                points.stream().mapToDouble(p -> p.wall.median()).min().orElse(0);
        List<Point> slow = points.stream()
                .filter(p -> p.judged && p.wall.median() >= START * shortest)
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

    /** The runs of each budget together, by ascending budget. */
    static List<Point> points(List<TradeRun> runs, double referenceVariance) {
        Map<Double, List<TradeRun>> bySamples = new TreeMap<>();
        for (TradeRun run : runs) {
            bySamples.computeIfAbsent(budget(run), n -> new ArrayList<>()).add(run);
        }
        return bySamples.values().stream()
                .map(rung -> point(rung, referenceVariance))
                .toList();
    }

    private static double budget(TradeRun run) {
        return run.samples() == 0 ? run.antialias() * run.antialias() : run.samples();
    }

    private static Point point(List<TradeRun> rung, double referenceVariance) {
        return new Point(
                budget(rung.get(0)),
                rung.get(0).samplesPerPixel(),
                Spread.of(rung.stream().map(TradeRun::wallSeconds).toList()),
                Spread.of(rung.stream().map(TradeRun::cpuSeconds).toList()),
                Spread.of(rung.stream().map(r -> r.error(referenceVariance)).toList()),
                Spread.of(rung.stream().map(TradeRun::flip).toList()),
                Spread.of(rung.stream().map(TradeRun::estimatedError).toList()),
                rung.stream().allMatch(r -> r.isJudged(referenceVariance)));
    }

    /** The method. */
    public String method() {
        return contender.method();
    }

    /** Those points whose error is known. */
    public List<Point> judgedPoints() {
        return points.stream().filter(Point::judged).toList();
    }
}
