package enlightenment.measure;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;

/**
 * What a method's budgets cost and bought.
 *
 * @param method the method
 * @param points one for each budget, by ascending samples
 * @param overSamples the fitted line of error over samples per pixel taken, if two budgets or more could be judged
 * @param overTime the fitted line of error over seconds by the clock, of those budgets that take at least twice as long as
 *     the shortest render: before, the time goes into what every render has to do
 * @param insideOwnInterval in how many of the runs the true error lay inside the interval that the render gave itself
 * @param judged how many runs could be judged
 */
public record Curve(
        String method,
        List<Point> points,
        Optional<PowerLaw> overSamples,
        Optional<PowerLaw> overTime,
        int insideOwnInterval,
        int judged) {
    private static final double START = 2;

    /** How far beyond the last budget a line is followed without having been there. */
    private static final double MOST_BEYOND = 2;

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

    /** The curve of a method's ladder; other runs are passed over. */
    static Curve of(String method, List<TradeRun> runs, double referenceVariance) {
        Map<Double, List<TradeRun>> bySamples = new TreeMap<>();
        for (TradeRun run : runs) {
            if (run.method().equals(method) && run.kind().equals(TradeRun.LADDER)) {
                bySamples.computeIfAbsent(run.samples(), n -> new ArrayList<>()).add(run);
            }
        }
        List<Point> points = new ArrayList<>();
        List<TradeRun> judged = new ArrayList<>();
        for (List<TradeRun> rung : bySamples.values()) {
            Point point = point(rung, referenceVariance);
            points.add(point);
            if (point.judged) {
                judged.addAll(rung);
            }
        }
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
                method, points, fit(samples, error), overTime(judged, points, referenceVariance), inside, error.length);
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
                .filter(r -> slow.stream().anyMatch(p -> p.samples == r.samples()))
                .toList();
        if (slow.size() < 2) {
            return Optional.empty();
        }
        return fit(
                runs.stream().mapToDouble(TradeRun::wallSeconds).toArray(),
                runs.stream().mapToDouble(r -> r.error(variance)).toArray());
    }

    private static Point point(List<TradeRun> rung, double referenceVariance) {
        return new Point(
                rung.get(0).samples(),
                rung.get(0).samplesPerPixel(),
                Spread.of(rung.stream().map(TradeRun::wallSeconds).toList()),
                Spread.of(rung.stream().map(TradeRun::cpuSeconds).toList()),
                Spread.of(rung.stream().map(r -> r.error(referenceVariance)).toList()),
                Spread.of(rung.stream().map(TradeRun::flip).toList()),
                Spread.of(rung.stream().map(TradeRun::estimatedError).toList()),
                rung.stream().allMatch(r -> r.isJudged(referenceVariance)));
    }

    /** Those points whose error is known. */
    public List<Point> judgedPoints() {
        return points.stream().filter(Point::judged).toList();
    }

    /** The runs of the largest budget, if there are any. */
    Optional<Point> last() {
        return points.isEmpty() ? Optional.empty() : Optional.of(points.get(points.size() - 1));
    }

    /**
     * The budget that leads to an error, found between the points next to it in the logarithms; beyond the last point by the
     * line through the last three.
     *
     * @return the budget, the time, and whether it lies within what was measured; nothing where too little is known
     */
    Optional<Estimate> samplesFor(double error) {
        List<Point> p = judgedPoints();
        if (p.isEmpty()) {
            return Optional.empty();
        }
        if (p.get(0).error.median() <= error) {
            return Optional.of(new Estimate(
                    p.get(0).samples, p.get(0).wall.median(), p.get(0).error.median(), true));
        }
        for (int i = 1; i < p.size(); i++) {
            double above = p.get(i - 1).error.median();
            double below = p.get(i).error.median();
            if (below <= error) {
                double t = Math.log(above / error) / Math.log(above / below);
                return Optional.of(new Estimate(
                        between(p.get(i - 1).samples, p.get(i).samples, t),
                        between(p.get(i - 1).wall.median(), p.get(i).wall.median(), t),
                        error,
                        true));
            }
        }
        return extrapolated(p, error);
    }

    private static Optional<Estimate> extrapolated(List<Point> p, double error) {
        if (p.size() < 2) {
            return Optional.empty();
        }
        List<Point> end = p.subList(Math.max(p.size() - 3, 0), p.size());
        double[] samples = end.stream().mapToDouble(Point::samples).toArray();
        double[] errors = end.stream().mapToDouble(q -> q.error.median()).toArray();
        double slope = PowerLaw.fit(samples, errors).slope();
        if (slope >= 0) {
            return Optional.empty();
        }
        Point last = p.get(p.size() - 1);
        double factor = Math.pow(error / last.error.median(), 1 / slope);
        return Optional.of(new Estimate(last.samples * factor, last.wall.median() * factor, error, false));
    }

    /** The budget that takes so long undisturbed, by the same means; the first where all take longer. */
    double samplesIn(double seconds) {
        // The first budget from above that does not take so long: a disturbed run of a smaller one misleads nobody.
        int i = points.size() - 1;
        while (i > 0 && points.get(i).wall.low() > seconds) {
            i--;
        }
        if (i == points.size() - 1 || points.get(i).wall.low() > seconds) {
            double factor = i == 0 ? 1 : Math.min(seconds / points.get(i).wall.low(), MOST_BEYOND);
            return points.get(i).samples * factor;
        }
        double before = points.get(i).wall.low();
        double after = points.get(i + 1).wall.low();
        return between(
                points.get(i).samples,
                points.get(i + 1).samples,
                Math.log(seconds / before) / Math.log(after / before));
    }

    private static double between(double a, double b, double t) {
        return a * Math.pow(b / a, t);
    }

    /**
     * What an error is expected to need.
     *
     * @param samples the budget
     * @param wall seconds by the clock
     * @param error the error expected
     * @param measured whether it lies within what was measured
     */
    record Estimate(double samples, double wall, double error, boolean measured) {}
}
