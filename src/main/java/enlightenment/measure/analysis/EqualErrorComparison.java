package enlightenment.measure.analysis;

import enlightenment.measure.trade.TradeResult;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.Set;
import java.util.TreeSet;

/**
 * The times of methods at an error that at least two of them reached in measured renders.
 *
 * @param error the error
 * @param smallest whether the error is the smallest that all of these methods were measured to reach
 * @param best false where each takes the scene's own number of light samples, true where each takes the best number measured
 * @param costs the cost by each method that was measured there, at least two, in the order of the settings
 */
public record EqualErrorComparison(double error, boolean smallest, boolean best, List<CostEstimate> costs) {
    private static final int FEWEST = 2;

    public EqualErrorComparison {
        costs = List.copyOf(costs);
    }

    /** The cost in the least time. */
    public CostEstimate fastest() {
        return costs.stream()
                .min(Comparator.comparingDouble(n -> n.wall().median()))
                .orElseThrow();
    }

    /** The time of one of the {@link #costs} divided by that of the fastest. */
    public double timesAsLong(CostEstimate cost) {
        return cost.wall().median() / fastest().wall().median();
    }

    /**
     * All comparisons of methods that sample all light of the scene. Those with the scene's own number of light samples are first; errors descend.
     */
    public static List<EqualErrorComparison> all(TradeAnalysis analysis) {
        List<EqualErrorComparison> all = new ArrayList<>();
        for (boolean best : new boolean[] {false, true}) {
            List<List<MeasuredCosts>> methods = analysis.methods().stream()
                    .map(m -> candidates(analysis, m, best))
                    .toList();
            Set<Double> smallest = smallest(methods);
            for (double error : errors(methods, smallest)) {
                List<CostEstimate> costs = measured(methods, error);
                if (costs.size() >= FEWEST) {
                    all.add(new EqualErrorComparison(error, smallest.contains(error), best, costs));
                }
            }
        }
        return all;
    }

    /**
     * Errors to compare at, in descending order: the targets, errors of methods that clearly undercut a target, and the smallest.
     */
    private static Set<Double> errors(List<List<MeasuredCosts>> methods, Set<Double> smallest) {
        Set<Double> errors = new TreeSet<>(Comparator.reverseOrder());
        errors.addAll(TradeResult.TARGETS);
        for (double target : TradeResult.TARGETS) {
            List<CostEstimate> there = measured(methods, target);
            if (there.size() >= FEWEST) {
                there.stream().filter(CostEstimate::undercutsTarget).forEach(n -> errors.add(n.error()));
            }
        }
        // Below the smallest error that two methods reached, there is no comparison.
        double end = smallest.stream().min(Double::compare).orElse(Double.POSITIVE_INFINITY);
        errors.removeIf(e -> e < end);
        errors.addAll(smallest);
        return errors;
    }

    private static List<MeasuredCosts> candidates(TradeAnalysis analysis, String method, boolean best) {
        return best
                ? analysis.costs(method)
                : analysis.costs(analysis.own(method)).stream().toList();
    }

    private static List<CostEstimate> measured(List<List<MeasuredCosts>> methods, double error) {
        return methods.stream()
                .map(costs -> TradeAnalysis.fastest(costs, error))
                .flatMap(Optional::stream)
                .filter(CostEstimate::isMeasured)
                .toList();
    }

    /**
     * The smallest errors that two, three, ... methods were all measured at: each the largest of the smallest ones of its methods. One of
     * them may have gone below the reference's own error, by an unknown amount.
     */
    private static Set<Double> smallest(List<List<MeasuredCosts>> methods) {
        double[] reached = methods.stream()
                .map(EqualErrorComparison::reached)
                .flatMapToDouble(OptionalDouble::stream)
                .sorted()
                .toArray();
        double[] known = methods.stream()
                .map(EqualErrorComparison::known)
                .flatMapToDouble(OptionalDouble::stream)
                .sorted()
                .toArray();
        Set<Double> smallest = new TreeSet<>(Comparator.reverseOrder());
        for (int i = 1; i < reached.length; i++) {
            if (isKnown(methods, reached[i])) {
                smallest.add(reached[i]);
            } else if (i < known.length) {
                smallest.add(known[i]);
            }
        }
        return smallest;
    }

    private static boolean isKnown(List<List<MeasuredCosts>> methods, double error) {
        return methods.stream()
                .flatMap(List::stream)
                .flatMap(r -> r.mostAccurate().stream())
                .anyMatch(p -> p.error().median() == error);
    }

    private static OptionalDouble reached(List<MeasuredCosts> costs) {
        return costs.stream().flatMapToDouble(r -> r.smallest().stream()).min();
    }

    private static OptionalDouble known(List<MeasuredCosts> costs) {
        return costs.stream()
                .flatMap(r -> r.mostAccurate().stream())
                .mapToDouble(p -> p.error().median())
                .min();
    }
}
