package enlightenment.measure.analysis;

import enlightenment.measure.trade.TradeResult;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.Set;
import java.util.TreeSet;
import java.util.stream.Stream;

/**
 * The times of two methods at an error that both were measured at. Only there is the ratio of times known.
 *
 * @param error the error
 * @param smallest whether it is the smallest that both were measured to reach
 * @param best false where both take the scene's own number of light samples, true where each takes the best number measured
 * @param first the cost by the method that the settings name first
 * @param second the cost by the other one
 */
public record EqualErrorComparison(
        double error, boolean smallest, boolean best, CostEstimate first, CostEstimate second) {
    /** The time of the first method divided by that of the second. */
    public double ratio() {
        return first.wall().median() / second.wall().median();
    }

    /**
     * All comparisons that the runs allow: of the first method with each other one, with the scene's own number of light samples
     * first, in descending order of the error.
     */
    public static List<EqualErrorComparison> all(TradeAnalysis analysis) {
        List<EqualErrorComparison> all = new ArrayList<>();
        List<String> methods = analysis.settings().methods();
        for (String other : methods.subList(1, methods.size())) {
            for (boolean best : new boolean[] {false, true}) {
                List<MeasuredCosts> a = candidates(analysis, methods.get(0), best);
                List<MeasuredCosts> b = candidates(analysis, other, best);
                OptionalDouble smallest = smallest(a, b);
                if (smallest.isEmpty()) {
                    continue;
                }
                for (double error : errors(a, b, smallest.getAsDouble(), best)) {
                    compare(a, b, error, error == smallest.getAsDouble(), best).ifPresent(all::add);
                }
            }
        }
        return all;
    }

    /**
     * Where to compare, in descending order: at the target errors, at those that one side gives where it clearly undercuts a
     * target, and at the smallest that both were measured at.
     */
    private static Set<Double> errors(List<MeasuredCosts> a, List<MeasuredCosts> b, double smallest, boolean best) {
        Set<Double> errors = new TreeSet<>(Comparator.reverseOrder());
        errors.addAll(TradeResult.TARGETS);
        for (double target : TradeResult.TARGETS) {
            compare(a, b, target, false, best).ifPresent(m -> Stream.of(m.first, m.second)
                    .filter(CostEstimate::undercutsTarget)
                    .forEach(n -> errors.add(n.error())));
        }
        errors.removeIf(e -> e < smallest);
        errors.add(smallest);
        return errors;
    }

    private static List<MeasuredCosts> candidates(TradeAnalysis analysis, String method, boolean best) {
        return analysis.costs().stream()
                .filter(r -> best
                        ? r.configuration().method().equals(method)
                        : r.configuration().equals(analysis.own(method)))
                .toList();
    }

    private static Optional<EqualErrorComparison> compare(
            List<MeasuredCosts> a, List<MeasuredCosts> b, double error, boolean smallest, boolean best) {
        Optional<CostEstimate> first = TradeAnalysis.fastest(a, error).filter(CostEstimate::isMeasured);
        Optional<CostEstimate> second = TradeAnalysis.fastest(b, error).filter(CostEstimate::isMeasured);
        return first.isEmpty() || second.isEmpty()
                ? Optional.empty()
                : Optional.of(new EqualErrorComparison(error, smallest, best, first.get(), second.get()));
    }

    /** The larger of the smallest errors that either was measured at; one of the two may have gone below the reference's. */
    private static OptionalDouble smallest(List<MeasuredCosts> a, List<MeasuredCosts> b) {
        OptionalDouble known = larger(known(a), known(b));
        OptionalDouble reached = larger(
                a.stream().flatMapToDouble(r -> r.smallest().stream()).min(),
                b.stream().flatMapToDouble(r -> r.smallest().stream()).min());
        boolean oneKnown = Stream.concat(a.stream(), b.stream())
                .flatMap(r -> r.mostAccurate().stream())
                .anyMatch(p -> p.error().median() == reached.orElse(0));
        return oneKnown ? reached : known;
    }

    private static OptionalDouble known(List<MeasuredCosts> costs) {
        return costs.stream()
                .flatMap(r -> r.mostAccurate().stream())
                .mapToDouble(p -> p.error().median())
                .min();
    }

    private static OptionalDouble larger(OptionalDouble a, OptionalDouble b) {
        return a.isEmpty() || b.isEmpty()
                ? OptionalDouble.empty()
                : OptionalDouble.of(Math.max(a.getAsDouble(), b.getAsDouble()));
    }
}
