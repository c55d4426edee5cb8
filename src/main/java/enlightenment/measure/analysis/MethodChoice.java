package enlightenment.measure.analysis;

import enlightenment.scene.Method;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;

/**
 * The choice of method for a scene, in words: the fastest methods by range of errors. Only measured errors count. Methods that do not sample all
 * light of the scene are left out, with a sentence about the missing light.
 *
 * @param ranges ranges from the largest error down; neighbouring ranges have different methods. Empty without a choice
 * @param leftOut light that is not sampled by the methods left out, one sentence each without a full stop
 * @param sentence the ranges in a sentence or two; empty with fewer than two methods to choose from
 */
public record MethodChoice(List<Range> ranges, List<String> leftOut, Optional<String> sentence) {
    /** The errors that methods are compared at. */
    private static final List<Double> ERRORS = List.of(0.2, 0.1, 0.05, 0.02, 0.01, 0.005, 0.002, 0.001);

    public MethodChoice {
        ranges = List.copyOf(ranges);
        leftOut = List.copyOf(leftOut);
    }

    /**
     * Errors for which the same methods are fastest.
     *
     * @param largest the largest error compared
     * @param smallest the smallest error compared
     * @param methods the fastest methods; more than one if their times are alike
     * @param rivals the fastest of the other methods at the smallest error that one was measured at, and the method that is used by
     *     default, if it is another one; empty where no other was measured in this range and found slower
     * @param alone the largest of these errors that no other method was measured to reach
     */
    public record Range(
            double largest, double smallest, List<String> methods, List<Rival> rivals, Optional<Double> alone) {
        public Range {
            methods = List.copyOf(methods);
            rivals = List.copyOf(rivals);
        }
    }

    /**
     * A slower method.
     *
     * @param error the error of the comparison
     * @param cost the cost of the error by this method
     * @param ratio the time of this method divided by that of the fastest
     * @param bound whether the ratio is a bound: "at least ", "at most ", or empty
     */
    public record Rival(double error, CostEstimate cost, double ratio, String bound) {}

    /** The measured costs of the methods at one error, the fastest first. */
    private record Place(double error, List<CostEstimate> costs) {
        CostEstimate fastest() {
            return costs.get(0);
        }

        /** The fastest method and those with times alike. */
        List<String> good() {
            return costs.stream()
                    .filter(n -> n == fastest() || Verdict.compare(fastest(), n).alike())
                    .map(CostEstimate::method)
                    .toList();
        }
    }

    /** The choice that the runs of a measurement allow. */
    public static MethodChoice of(TradeAnalysis analysis) {
        List<String> leftOut = List.copyOf(analysis.result().blindSpots().values());
        if (analysis.methods().size() < 2) {
            return new MethodChoice(List.of(), leftOut, Optional.empty());
        }
        List<Place> places = places(analysis, ERRORS);
        if (places.isEmpty()) {
            // A hard scene, or little time: only larger errors, or those between, can be compared.
            places = places(analysis, reached(analysis));
        }
        List<Range> ranges = new ArrayList<>();
        for (int from = 0; from < places.size(); ) {
            List<String> methods = new ArrayList<>(places.get(from).good());
            int to = from + 1;
            while (to < places.size()) {
                List<String> both = new ArrayList<>(methods);
                both.retainAll(places.get(to).good());
                if (both.isEmpty()) {
                    break;
                }
                methods = both;
                to++;
            }
            ranges.add(range(places.subList(from, to), methods));
            from = to;
        }
        return new MethodChoice(ranges, leftOut, Optional.of(sentence(ranges)));
    }

    /** The smallest errors that several methods were measured to reach, with two digits. */
    private static List<Double> reached(TradeAnalysis analysis) {
        return EqualErrorComparison.all(analysis).stream()
                .filter(m -> m.best() && m.smallest())
                .map(m -> Digits.upTwoOf(m.error()))
                .distinct()
                .toList();
    }

    /** Costs at the given errors in descending order, as far as measured and not reached with a single sample. */
    private static List<Place> places(TradeAnalysis analysis, List<Double> errors) {
        List<Place> places = new ArrayList<>();
        for (double error : errors) {
            List<CostEstimate> costs = analysis.methods().stream()
                    .flatMap(m -> analysis.best(m, error).stream())
                    .filter(CostEstimate::isMeasured)
                    .sorted((a, b) -> Double.compare(a.wall().median(), b.wall().median()))
                    .toList();
            boolean trivial = !costs.isEmpty()
                    && costs.get(0).samples() <= 1
                    && costs.get(0).undercutsTarget();
            if (analysis.isKnown(error) && !costs.isEmpty() && !trivial && isCompared(analysis, costs)) {
                places.add(new Place(error, costs));
            }
        }
        return places;
    }

    /** Whether another method was measured at this error, or at any other. */
    private static boolean isCompared(TradeAnalysis analysis, List<CostEstimate> costs) {
        return costs.size() > 1
                || analysis.costs().stream()
                        .anyMatch(r ->
                                !r.configuration().method().equals(costs.get(0).method())
                                        && r.mostAccurate().isPresent());
    }

    private static Range range(List<Place> places, List<String> methods) {
        Place last = places.get(places.size() - 1);
        List<Rival> rivals = List.of();
        Optional<Double> alone = Optional.empty();
        for (Place place : places) {
            List<CostEstimate> others = place.costs.stream()
                    .filter(n -> !methods.contains(n.method()) && !place.good().contains(n.method()))
                    .toList();
            if (alone.isEmpty() && place.costs.size() == 1) {
                alone = Optional.of(place.error);
            }
            if (!others.isEmpty()) {
                Stream<CostEstimate> byDefault =
                        others.stream().skip(1).filter(n -> n.method().equals(Method.RAYTRACE.word()));
                rivals = Stream.concat(others.stream().limit(1), byDefault)
                        .map(n -> rival(place, methods, n))
                        .toList();
            }
        }
        return new Range(places.get(0).error, last.error, methods, rivals, alone);
    }

    private static Rival rival(Place place, List<String> methods, CostEstimate other) {
        CostEstimate chosen = place.costs.stream()
                .filter(n -> methods.contains(n.method()))
                .findFirst()
                .orElseThrow();
        return new Rival(place.error, other, Verdict.compare(chosen, other).ratio(), Verdict.bound(chosen, other));
    }

    private static String sentence(List<Range> ranges) {
        if (ranges.isEmpty()) {
            return "Which method to use for this scene is not known: too little was measured to compare them"
                    + " (a larger --budget goes further).";
        }
        List<String> parts = new ArrayList<>();
        for (int i = 0; i < ranges.size(); i++) {
            parts.add(name(ranges.get(i)) + where(ranges, i) + why(ranges.get(i)));
        }
        return "For this scene use " + String.join("; ", parts) + ".";
    }

    private static String name(Range range) {
        return String.join(" or ", range.methods);
    }

    private static String where(List<Range> ranges, int i) {
        Range range = ranges.get(i);
        if (ranges.size() == 1) {
            return "";
        }
        if (i == 0) {
            return " for errors of " + Digits.samples(range.smallest) + " and more";
        }
        String largest = Digits.samples(range.largest);
        if (i == ranges.size() - 1) {
            return " for errors of " + largest + " and less";
        }
        return range.largest == range.smallest
                ? " for an error of " + largest
                : " for errors of " + largest + " to " + Digits.samples(range.smallest);
    }

    private static String why(Range range) {
        String alike = range.methods.size() > 1
                ? ", which take about as long (measured down to an error of " + Digits.samples(range.smallest) + ")"
                : "";
        List<String> reasons = new ArrayList<>();
        if (!range.rivals.isEmpty()) {
            List<String> slower = range.rivals.stream()
                    .map(r -> r.bound + Digits.of(r.ratio, 2) + " times faster than " + r.cost.method())
                    .toList();
            double error = range.rivals.get(0).error;
            reasons.add(String.join(" and ", slower) + " at an error of " + Digits.samples(error));
        }
        range.alone.ifPresent(
                error -> reasons.add("no other was measured to reach an error of " + Digits.samples(error)));
        return alike + (reasons.isEmpty() ? "" : ": " + String.join(", and ", reasons));
    }
}
