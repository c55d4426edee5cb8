package enlightenment.measure.analysis;

import enlightenment.measure.analysis.Curve.Point;
import enlightenment.measure.trade.Spread;
import enlightenment.measure.trade.TradeRun;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.TreeMap;
import java.util.function.ToDoubleFunction;

/**
 * The costs of errors with one configuration, from runs of all kinds. Each result names the measurements it is based on.
 */
public final class MeasuredCosts {
    /** Ratio of the smallest measured error to the smallest extrapolated one: at most about two doublings of the budget. */
    private static final double MAX_EXTRAPOLATION = 2;

    /**
     * Largest ratio of the errors of neighbouring budgets that are interpolated. Twice the samples change an error by a factor of at most about two;
     * a larger change means that the method behaves differently.
     */
    private static final double MAX_GAP = 4;

    /** Number of the last points whose power law is extrapolated. */
    private static final int LAST_POINTS = 3;

    /** Largest ratio of a tried error to the target that it counts for. */
    private static final double TOLERANCE = 1.02;

    private final Configuration configuration;
    private final List<Point> points;
    private final List<TradeRun> checks;
    private final double referenceVariance;

    /** The reference's own error, an approximate bound of errors that cannot be distinguished from it. */
    private final double floor;

    private MeasuredCosts(
            Configuration configuration, List<Point> points, List<TradeRun> checks, double referenceVariance) {
        this.configuration = configuration;
        this.points = points;
        this.checks = checks;
        this.referenceVariance = referenceVariance;
        floor = Math.sqrt(referenceVariance);
    }

    /** The costs of a configuration; runs of others, and with other numbers of threads, are ignored. */
    public static MeasuredCosts of(
            Configuration configuration, List<TradeRun> runs, int threads, double referenceVariance) {
        List<TradeRun> own = runs.stream()
                .filter(r -> r.threads() == threads && Configuration.of(r).equals(configuration))
                .toList();
        List<TradeRun> checks =
                own.stream().filter(r -> r.kind().equals(TradeRun.CHECK)).toList();
        return new MeasuredCosts(configuration, Curve.points(own, referenceVariance), checks, referenceVariance);
    }

    /** The configuration. */
    public Configuration configuration() {
        return configuration;
    }

    /** The measured budget that gave the smallest error, if any could be judged. */
    public Optional<Point> mostAccurate() {
        return judged().stream().min(Comparator.comparingDouble(p -> p.error().median()));
    }

    /** The points of all budgets, by ascending samples. */
    public List<Point> points() {
        return points;
    }

    /** The smallest measured error; the reference's own if an error is below that. */
    OptionalDouble smallest() {
        return points.stream().mapToDouble(this::error).min();
    }

    private List<Point> judged() {
        return points.stream().filter(Point::judged).toList();
    }

    private double error(Point p) {
        return Math.max(p.error().median(), floor);
    }

    /** The cost of an error: tried, else measured or interpolated, else extrapolated within limits. */
    public Optional<CostEstimate> forError(double target) {
        Optional<CostEstimate> tried = tried(target, CostEstimate.CLOSE);
        if (tried.isPresent()) {
            return tried;
        }
        Optional<CostEstimate> measured = measured(target);
        boolean loose = measured.isEmpty() || measured.get().undercutsTarget();
        if (loose && tried(target, 0).isPresent()) {
            return tried(target, 0);
        }
        return measured.isPresent() ? measured : beyond(target);
    }

    /** The cost of an error within the measured range, in which tried runs count as others. */
    Optional<CostEstimate> measured(double target) {
        return crossing(points, target, this::error);
    }

    /** The cost of a bound of the mean FLIP difference, within the measured range. */
    public Optional<CostEstimate> forFlip(double flip) {
        return crossing(judged(), flip, p -> p.flip().median()).map(CostEstimate::atItsOwnError);
    }

    private Optional<CostEstimate> crossing(List<Point> all, double target, ToDoubleFunction<Point> value) {
        for (int i = 0; i < all.size(); i++) {
            Point b = all.get(i);
            double below = value.applyAsDouble(b);
            if (below > target) {
                continue;
            }
            Point a = all.get(Math.max(i - 1, 0));
            double above = value.applyAsDouble(a);
            boolean sameLaw = i > 0 && a.judged() && b.judged() && above <= MAX_GAP * below;
            if (!sameLaw || below == target || configuration.grid()) {
                return Optional.of(at(b, target));
            }
            return Optional.of(between(a, b, target, Math.log(above / target) / Math.log(above / below)));
        }
        return Optional.empty();
    }

    private CostEstimate at(Point p, double target) {
        return new CostEstimate(
                configuration,
                target,
                p.samples(),
                error(p),
                p.wall(),
                positive(p.cpu()),
                Optional.of(p.flip().median()),
                p.judged() ? CostEstimate.Source.MEASURED : CostEstimate.Source.BELOW,
                List.of(error(p)));
    }

    private CostEstimate between(Point a, Point b, double target, double t) {
        return new CostEstimate(
                configuration,
                target,
                Digits.upTwo(between(a.samples(), b.samples(), t)),
                between(a.error().median(), b.error().median(), t),
                Spread.of(between(a.wall().median(), b.wall().median(), t)),
                positive(Spread.of(between(a.cpu().median(), b.cpu().median(), t))),
                Optional.of(between(a.flip().median(), b.flip().median(), t)),
                CostEstimate.Source.BETWEEN,
                List.of(a.error().median(), b.error().median()));
    }

    private static Optional<Spread> positive(Spread s) {
        return s.median() > 0 ? Optional.of(s) : Optional.empty();
    }

    /** Interpolates along a power law; linearly if a value is 0. */
    static double between(double a, double b, double t) {
        return a > 0 && b > 0 ? a * Math.pow(b / a, t) : a + t * (b - a);
    }

    private Optional<CostEstimate> beyond(double target) {
        List<Point> judged = judged();
        if (judged.size() < 2 || configuration.grid()) {
            return Optional.empty();
        }
        List<Point> end = judged.subList(Math.max(judged.size() - LAST_POINTS, 0), judged.size());
        double[] samples = end.stream().mapToDouble(Point::samples).toArray();
        double[] errors = end.stream().mapToDouble(this::error).toArray();
        double slope = PowerLaw.fit(samples, errors).slope();
        Point last = end.get(end.size() - 1);
        if (slope >= 0 || target * MAX_EXTRAPOLATION < error(last)) {
            return Optional.empty();
        }
        double factor = Math.pow(target / error(last), 1 / slope);
        return Optional.of(new CostEstimate(
                configuration,
                target,
                Digits.upTwo(last.samples() * factor),
                target,
                Spread.of(last.wall().median() * factor),
                Optional.empty(),
                Optional.empty(),
                CostEstimate.Source.BEYOND,
                List.of(mostAccurate().orElse(last).error().median())));
    }

    /** The smallest budget, rendered with the scene's seed, with an error between a share of the target and the target. */
    public Optional<CostEstimate> tried(double target, double minShare) {
        Map<Double, List<TradeRun>> bySamples = new TreeMap<>();
        for (TradeRun run : checks) {
            bySamples.computeIfAbsent(run.samples(), n -> new ArrayList<>()).add(run);
        }
        return bySamples.values().stream()
                .filter(runs -> {
                    double error = error(runs);
                    boolean smallest = runs.get(0).samples() <= 1;
                    return error <= TOLERANCE * target && (smallest || error >= minShare * target);
                })
                .min(Comparator.comparingDouble(runs -> runs.get(0).samples()))
                .map(runs -> tried(runs, target));
    }

    private double error(List<TradeRun> same) {
        return Math.max(same.get(0).error(referenceVariance), floor);
    }

    private CostEstimate tried(List<TradeRun> runs, double target) {
        double error = error(runs);
        return new CostEstimate(
                configuration,
                target,
                runs.get(0).samples(),
                error,
                Spread.of(runs.stream().map(TradeRun::wallSeconds).toList()),
                positive(Spread.of(runs.stream().map(TradeRun::cpuSeconds).toList())),
                Optional.of(runs.get(0).flip()),
                runs.get(0).isJudged(referenceVariance) ? CostEstimate.Source.TRIED : CostEstimate.Source.BELOW,
                List.of(error));
    }

    /** The budget for an undisturbed time in seconds: interpolated, or in proportion to the last one beyond. */
    public double samplesIn(double seconds) {
        Point before = points.get(0);
        for (Point p : points) {
            if (p.wall().low() > seconds && p != before) {
                double t = Math.log(seconds / before.wall().low())
                        / Math.log(p.wall().low() / before.wall().low());
                return between(before.samples(), p.samples(), Math.max(t, 0));
            }
            before = p.wall().low() <= seconds ? p : before;
        }
        return before.samples() * Math.min(Math.max(seconds / before.wall().low(), 1), MAX_EXTRAPOLATION);
    }
}
