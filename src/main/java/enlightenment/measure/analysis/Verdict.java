package enlightenment.measure.analysis;

import enlightenment.measure.trade.Advice;
import enlightenment.measure.trade.Advice.Basis;
import enlightenment.measure.trade.TradeResult;
import enlightenment.measure.trade.TradeSettings;
import enlightenment.scene.BuiltInMethod;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;

/**
 * The advice for an error, in words. Each figure in the sentence is followed by the measurements that it comes from; what is only
 * extrapolated is marked as such and takes part in no ratio.
 *
 * @param target the error to reach
 * @param best the cost in the least time; empty if unknown
 * @param known the basis of the advice
 * @param comparisons comparisons with other configurations, as far as these were measured at the error
 * @param sentence the advice, one sentence
 */
public record Verdict(
        double target, Optional<CostEstimate> best, Basis known, List<Comparison> comparisons, String sentence) {
    /** Ratio below which times count as alike: another measurement may reverse them. */
    private static final double ALIKE = 1.1;

    /** Rounding to eight bits adds an error of 0.0011 (1/255/√12): below this error sixteen are advised. */
    private static final double NEEDS_SIXTEEN_BITS = 0.006;

    public Verdict {
        comparisons = List.copyOf(comparisons);
    }

    /**
     * The time of another configuration, both measured.
     *
     * @param cost the cost of the error with that configuration
     * @param ratio the time of that configuration divided by that of the advice
     * @param alike whether the two times are too close to tell which is shorter
     */
    public record Comparison(CostEstimate cost, double ratio, boolean alike) {}

    /** The advice for one error. */
    public static Verdict of(TradeAnalysis analysis, double target) {
        String error = "For an error of " + Digits.samples(target);
        if (!analysis.isKnown(target)) {
            return nothing(
                    target,
                    error + " there is no verdict: the reference's own error is "
                            + Digits.of(analysis.result().reference().error(), 2)
                            + ", and of smaller ones it says nothing (a larger --budget makes a better one).");
        }
        Optional<CostEstimate> best = TradeAnalysis.fastest(analysis.costs(), target);
        if (best.isEmpty()) {
            return nothing(
                    target,
                    error + " there is no verdict: the smallest errors measured are " + smallest(analysis)
                            + " (a larger --budget goes further).");
        }
        if (best.get().isMeasured()) {
            return measured(analysis, best.get(), error);
        }
        String text = error + " nothing was measured; extrapolated, " + arguments(best.get(), analysis.settings())
                + " would take " + time(best.get()) + ", and there is no comparison.";
        return new Verdict(target, best, Basis.EXTRAPOLATED, List.of(), text);
    }

    private static Verdict measured(TradeAnalysis analysis, CostEstimate best, String error) {
        List<Comparison> comparisons = new ArrayList<>();
        StringBuilder text = new StringBuilder(error);
        text.append(" use ")
                .append(arguments(best, analysis.settings()))
                .append(": ")
                .append(time(best));
        for (Configuration other : others(analysis, best)) {
            Optional<Comparison> comparison = analysis.costs(other)
                    .flatMap(r -> r.forError(best.target()))
                    .filter(CostEstimate::isMeasured)
                    .map(n -> compare(best, n));
            comparison.ifPresent(comparisons::add);
            text.append(", ")
                    .append(comparison
                            .map(c -> phrase(best, c, analysis))
                            .orElseGet(() -> notReached(analysis, other)));
        }
        flip(analysis, best).ifPresent(text::append);
        return new Verdict(
                best.target(),
                Optional.of(best),
                Basis.MEASURED,
                comparisons,
                text.append('.').toString());
    }

    private static String time(CostEstimate cost) {
        return Digits.of(cost.wall().median(), 2) + " s (" + cost.evidence() + ")";
    }

    private static Verdict nothing(double target, String sentence) {
        return new Verdict(target, Optional.empty(), Basis.NOTHING, List.of(), sentence);
    }

    /** The smallest measured error of each method. */
    private static String smallest(TradeAnalysis analysis) {
        List<String> all = new ArrayList<>();
        for (String method : analysis.methods()) {
            analysis.costs(method).stream()
                    .filter(r -> r.mostAccurate().isPresent())
                    .min(Comparator.comparingDouble(
                            r -> r.mostAccurate().orElseThrow().error().median()))
                    .ifPresent(r -> all.add(
                            Digits.of(r.mostAccurate().orElseThrow().error().median(), 2) + " by "
                                    + r.configuration().name()));
        }
        return all.isEmpty() ? "none" : String.join(" and ", all);
    }

    /** The advised method with the scene's number of light samples; other methods with that and with their best. */
    private static List<Configuration> others(TradeAnalysis analysis, CostEstimate best) {
        List<Configuration> others = new ArrayList<>();
        for (String method : analysis.methods()) {
            Configuration own = analysis.own(method);
            if (!own.equals(best.configuration())) {
                others.add(own);
            }
            if (!method.equals(best.method())) {
                analysis.best(method, best.target())
                        .filter(CostEstimate::isMeasured)
                        .map(CostEstimate::configuration)
                        .filter(c -> !c.equals(own))
                        .ifPresent(others::add);
            }
        }
        return others;
    }

    static Comparison compare(CostEstimate best, CostEstimate other) {
        double ratio = other.wall().median() / best.wall().median();
        boolean overlap = other.wall().low() <= best.wall().high();
        return new Comparison(other, ratio, ratio < ALIKE || overlap);
    }

    private static String phrase(CostEstimate best, Comparison c, TradeAnalysis analysis) {
        String name = c.cost.configuration().name()
                + (isBestVariant(c.cost, analysis) ? ", its best of " + numbers(analysis, c.cost.method()) : "");
        String bound = bound(best, c.cost);
        return (c.alike ? "about as fast as " : bound + Digits.of(c.ratio, 2) + " times faster than ") + name + " ("
                + c.cost.evidence() + ")";
    }

    /** The kind of bound of a ratio of times. A time that undercuts the target is an upper bound of the time to it. */
    static String bound(CostEstimate best, CostEstimate other) {
        if (best.undercutsTarget() == other.undercutsTarget()) {
            return "";
        }
        return other.undercutsTarget() ? "at most " : "at least ";
    }

    private static boolean isBestVariant(CostEstimate cost, TradeAnalysis analysis) {
        return !cost.configuration().equals(analysis.own(cost.method()));
    }

    private static String numbers(TradeAnalysis analysis, String method) {
        return String.join(
                ", ",
                analysis.costs().stream()
                        .map(MeasuredCosts::configuration)
                        .filter(c -> c.method().equals(method))
                        .map(Configuration::lightSamples)
                        .sorted()
                        .distinct()
                        .map(String::valueOf)
                        .toList());
    }

    private static String notReached(TradeAnalysis analysis, Configuration other) {
        return analysis.costs(other)
                .flatMap(MeasuredCosts::mostAccurate)
                .map(p -> "which " + other.name() + " was not measured to reach (its smallest error is "
                        + Digits.of(p.error().median(), 2) + ", in "
                        + Digits.of(p.wall().median(), 2) + " s)")
                .orElse("while nothing was measured of " + other.name());
    }

    /** A note if another method reaches the same FLIP in clearly less time. */
    private static Optional<String> flip(TradeAnalysis analysis, CostEstimate best) {
        if (best.flip().isEmpty()) {
            return Optional.empty();
        }
        double flip = best.flip().get();
        return analysis.costs().stream()
                .filter(r -> !r.configuration().method().equals(best.method()))
                .flatMap(r -> r.forFlip(flip).stream())
                .min((a, b) -> Double.compare(a.wall().median(), b.wall().median()))
                .filter(n -> ALIKE * n.wall().median() <= best.wall().median())
                .map(n -> "; by FLIP it is the other way round: for a FLIP of at most " + Digits.of(flip, 2) + " "
                        + n.configuration().name() + " took "
                        + Digits.of(n.wall().median(), 2) + " s (" + n.evidence() + ")");
    }

    /** The advice for all of {@link TradeResult#TARGETS}. */
    public static List<Verdict> all(TradeAnalysis analysis) {
        return TradeResult.TARGETS.stream().map(t -> of(analysis, t)).toList();
    }

    /** The most useful advice: for the largest error that some method does not reach with its smallest budget. */
    public static Verdict headline(TradeAnalysis analysis) {
        for (double target : TradeResult.TARGETS) {
            Verdict verdict = of(analysis, target);
            boolean trivial = analysis.methods().stream().allMatch(m -> analysis.costs(analysis.own(m))
                    .filter(r -> reachesAtOnce(r, target))
                    .isPresent());
            if (verdict.known == Basis.MEASURED && !trivial) {
                return verdict;
            }
        }
        return of(analysis, TradeResult.TARGETS.get(0));
    }

    private static boolean reachesAtOnce(MeasuredCosts costs, double target) {
        return costs.forError(target)
                .filter(n -> n.samples() <= costs.points().get(0).samples())
                .isPresent();
    }

    /** The advice without the measurements it is compared with. */
    public Advice advice(TradeSettings settings) {
        return new Advice(
                target,
                known,
                best.map(c -> c.configuration()
                        .settings(settings.base(), c.samples(), settings.base().seed())),
                best.map(CostEstimate::wall),
                sentence);
    }

    /** The options of {@code render} for a cost, ready to be typed. */
    public static String arguments(CostEstimate cost, TradeSettings settings) {
        return cost.configuration()
                        .options(
                                cost.samples(),
                                BuiltInMethod.RayTraceSettings.of(settings.base())
                                        .shadowSamples())
                + (cost.target() < NEEDS_SIXTEEN_BITS ? " --depth 16" : "");
    }
}
