package enlightenment.measure.analysis;

import enlightenment.scene.Method;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;

/**
 * Which method to use for a scene, in plain words: for which errors one takes less time than all others. Only what was measured counts; a
 * method that cannot see all of the scene is left out, and it is said what it cannot see.
 *
 * @param ranges the answer, from the largest error down; neighbouring ranges have other methods. Empty where there is nothing to choose
 * @param leftOut what the methods that are left out cannot see, one sentence each without a full stop
 * @param sentence all of it but what is left out, in a sentence or two; empty where fewer than two methods can be chosen from
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
     * @param smallest the smallest one
     * @param methods the fastest; more than one where their times are alike
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
     * A method that is slower.
     *
     * @param error where it was compared
     * @param cost what the error costs with it
     * @param ratio its time divided by that of the fastest
     * @param bound what the ratio is: "at least ", "at most ", or empty
     */
    public record Rival(double error, CostEstimate cost, double ratio, String bound) {}

    /** What was measured at one error: the costs of the methods, the fastest first. */
    private record Place(double error, List<CostEstimate> costs) {
        CostEstimate fastest() {
            return costs.get(0);
        }

        /** The fastest and those that take about as long. */
        List<String> good() {
            return costs.stream()
                    .filter(n -> n == fastest() || Verdict.compare(fastest(), n).alike())
                    .map(CostEstimate::method)
                    .toList();
        }
    }

    /** The choice that the runs of a trade allow. */
    public static MethodChoice of(TradeAnalysis analysis) {
        List<String> leftOut = List.copyOf(analysis.result().blindSpots().values());
        if (analysis.methods().size() < 2) {
            return new MethodChoice(List.of(), leftOut, Optional.empty());
        }
        List<Place> places = places(analysis, ERRORS);
        if (places.isEmpty()) {
            // A hard scene, or little time: what there is to compare are larger errors, or those between.
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

    /** Those of some errors, in descending order, where methods were measured and that take more than a single sample. */
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

    /** Whether another method was measured there, or at least somewhere else. */
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
