package enlightenment.measure;

import enlightenment.measure.Curve.Point;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.TreeMap;
import java.util.function.ToDoubleFunction;

/**
 * What a contender was seen to reach: all its runs, whatever they were made for. Everything that is said about errors and times
 * comes from here, with the measured points that it rests on.
 */
public final class Reach {
    /** How far below the smallest measured error a line is followed: to half of it, about one more doubling of the budget. */
    private static final double FARTHEST = 2;

    /**
     * Neighbouring budgets whose errors differ by more than this do not lie on one line: between them the method begins to work
     * in another way. Doubled samples change an error by at most about two.
     */
    private static final double WIDEST_GAP = 4;

    /** So many points say how a line goes on. */
    private static final int END = 3;

    /** A tried error this close below the one that is wanted is an answer to the question, and this little above it. */
    private static final double STILL = 0.85;

    private static final double A_LITTLE_ABOVE = 1.02;

    private final Contender contender;
    private final List<Point> points;
    private final List<TradeRun> checks;
    private final double referenceVariance;

    /** What cannot be told from the reference has at most about the reference's own error. */
    private final double floor;

    private Reach(Contender contender, List<Point> points, List<TradeRun> checks, double referenceVariance) {
        this.contender = contender;
        this.points = points;
        this.checks = checks;
        this.referenceVariance = referenceVariance;
        floor = Math.sqrt(referenceVariance);
    }

    /** What these runs say of a contender; runs of others, and with other numbers of threads, are passed over. */
    static Reach of(Contender contender, List<TradeRun> runs, int threads, double referenceVariance) {
        List<TradeRun> own = runs.stream()
                .filter(r -> r.threads() == threads && Contender.of(r).equals(contender))
                .toList();
        List<TradeRun> checks =
                own.stream().filter(r -> r.kind().equals(TradeRun.CHECK)).toList();
        return new Reach(contender, Curve.points(own, referenceVariance), checks, referenceVariance);
    }

    /** Who it is about. */
    public Contender contender() {
        return contender;
    }

    /** The measured budget that gave the smallest error, if any could be judged. */
    public Optional<Point> finest() {
        return judged().stream().min(Comparator.comparingDouble(p -> p.error().median()));
    }

    /** All budgets, by ascending samples. */
    List<Point> points() {
        return points;
    }

    /** The smallest error that it was measured to reach; the reference's own where it went below that. */
    OptionalDouble smallest() {
        return points.stream().mapToDouble(this::error).min();
    }

    private List<Point> judged() {
        return points.stream().filter(Point::judged).toList();
    }

    private double error(Point p) {
        return Math.max(p.error().median(), floor);
    }

    /** What the contender needs for an error: as tried, else as measured, else a little way beyond that. */
    public Optional<Need> forError(double target) {
        Optional<Need> tried = tried(target, STILL);
        if (tried.isPresent()) {
            return tried;
        }
        Optional<Need> measured = measured(target);
        boolean crude = measured.isEmpty() || measured.get().isMoreThanAsked();
        if (crude && tried(target, 0).isPresent()) {
            return tried(target, 0);
        }
        return measured.isPresent() ? measured : beyond(target);
    }

    /** What the contender needs for an error within what was measured, passing over what was tried for one error only. */
    Optional<Need> measured(double target) {
        return crossing(points, target, this::error);
    }

    /** What the contender needs for a mean FLIP difference of at most this, within what was measured. */
    public Optional<Need> forFlip(double flip) {
        return crossing(judged(), flip, p -> p.flip().median()).map(Need::forWhatItGives);
    }

    private Optional<Need> crossing(List<Point> all, double target, ToDoubleFunction<Point> value) {
        for (int i = 0; i < all.size(); i++) {
            Point b = all.get(i);
            double below = value.applyAsDouble(b);
            if (below > target) {
                continue;
            }
            Point a = all.get(Math.max(i - 1, 0));
            double above = value.applyAsDouble(a);
            boolean onALine = i > 0 && a.judged() && b.judged() && above <= WIDEST_GAP * below;
            if (!onALine || below == target || contender.grid()) {
                return Optional.of(at(b, target));
            }
            return Optional.of(between(a, b, target, Math.log(above / target) / Math.log(above / below)));
        }
        return Optional.empty();
    }

    private Need at(Point p, double target) {
        return new Need(
                contender,
                target,
                p.samples(),
                error(p),
                p.wall(),
                positive(p.cpu()),
                Optional.of(p.flip().median()),
                p.judged() ? Need.Source.MEASURED : Need.Source.BELOW,
                List.of(error(p)));
    }

    private Need between(Point a, Point b, double target, double t) {
        return new Need(
                contender,
                target,
                Digits.upTwo(between(a.samples(), b.samples(), t)),
                between(a.error().median(), b.error().median(), t),
                Spread.of(between(a.wall().median(), b.wall().median(), t)),
                positive(Spread.of(between(a.cpu().median(), b.cpu().median(), t))),
                Optional.of(between(a.flip().median(), b.flip().median(), t)),
                Need.Source.BETWEEN,
                List.of(a.error().median(), b.error().median()));
    }

    private static Optional<Spread> positive(Spread s) {
        return s.median() > 0 ? Optional.of(s) : Optional.empty();
    }

    /** Along a straight line in the logarithms. */
    static double between(double a, double b, double t) {
        return a > 0 && b > 0 ? a * Math.pow(b / a, t) : a + t * (b - a);
    }

    private Optional<Need> beyond(double target) {
        List<Point> judged = judged();
        if (judged.size() < 2 || contender.grid()) {
            return Optional.empty();
        }
        List<Point> end = judged.subList(Math.max(judged.size() - END, 0), judged.size());
        double[] samples = end.stream().mapToDouble(Point::samples).toArray();
        double[] errors = end.stream().mapToDouble(this::error).toArray();
        double slope = PowerLaw.fit(samples, errors).slope();
        Point last = end.get(end.size() - 1);
        if (slope >= 0 || target * FARTHEST < error(last)) {
            return Optional.empty();
        }
        double factor = Math.pow(target / error(last), 1 / slope);
        return Optional.of(new Need(
                contender,
                target,
                Digits.upTwo(last.samples() * factor),
                target,
                Spread.of(last.wall().median() * factor),
                Optional.empty(),
                Optional.empty(),
                Need.Source.BEYOND,
                List.of(finest().orElse(last).error().median())));
    }

    /** The cheapest budget that was rendered with the scene's seed and gives the error, or less of it down to a share. */
    Optional<Need> tried(double target, double leastShare) {
        Map<Double, List<TradeRun>> bySamples = new TreeMap<>();
        for (TradeRun run : checks) {
            bySamples.computeIfAbsent(run.samples(), n -> new ArrayList<>()).add(run);
        }
        return bySamples.values().stream()
                .filter(runs -> {
                    double error = error(runs);
                    boolean least = runs.get(0).samples() <= 1;
                    return error <= A_LITTLE_ABOVE * target && (least || error >= leastShare * target);
                })
                .min(Comparator.comparingDouble(runs -> runs.get(0).samples()))
                .map(runs -> tried(runs, target));
    }

    private double error(List<TradeRun> same) {
        return Math.max(same.get(0).error(referenceVariance), floor);
    }

    private Need tried(List<TradeRun> runs, double target) {
        double error = error(runs);
        return new Need(
                contender,
                target,
                runs.get(0).samples(),
                error,
                Spread.of(runs.stream().map(TradeRun::wallSeconds).toList()),
                positive(Spread.of(runs.stream().map(TradeRun::cpuSeconds).toList())),
                Optional.of(runs.get(0).flip()),
                runs.get(0).isJudged(referenceVariance) ? Need.Source.TRIED : Need.Source.BELOW,
                List.of(error));
    }

    /** The budget that takes so long undisturbed: between budgets that were rendered, or in proportion beyond. */
    double samplesIn(double seconds) {
        Point before = points.get(0);
        for (Point p : points) {
            if (p.wall().low() > seconds && p != before) {
                double t = Math.log(seconds / before.wall().low())
                        / Math.log(p.wall().low() / before.wall().low());
                return between(before.samples(), p.samples(), Math.max(t, 0));
            }
            before = p.wall().low() <= seconds ? p : before;
        }
        return before.samples() * Math.min(Math.max(seconds / before.wall().low(), 1), FARTHEST);
    }
}
