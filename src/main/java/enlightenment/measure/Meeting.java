package enlightenment.measure;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.Set;
import java.util.TreeSet;
import java.util.stream.Stream;

/**
 * An error that two methods were both measured at: here, and only here, can it be said how many times faster one of them is.
 *
 * @param error the error
 * @param smallest whether it is the smallest that both were measured to reach
 * @param best false where both took the scene's own number of light points, true where each took the best number that was measured
 * @param first what the method needs that is named first in the settings
 * @param second what the other one needs
 */
public record Meeting(double error, boolean smallest, boolean best, Need first, Need second) {
    /** How many times as long the first method takes as the second. */
    public double ratio() {
        return first.wall().median() / second.wall().median();
    }

    /** All that can be told: for the errors asked about and for the smallest one, first with the scene's own light points. */
    public static List<Meeting> all(TradeResult result) {
        List<Meeting> all = new ArrayList<>();
        List<String> methods = result.settings().methods();
        for (String other : methods.subList(1, methods.size())) {
            for (boolean best : new boolean[] {false, true}) {
                List<Reach> a = candidates(result, methods.get(0), best);
                List<Reach> b = candidates(result, other, best);
                OptionalDouble finest = finest(a, b);
                if (finest.isEmpty()) {
                    continue;
                }
                for (double error : errors(a, b, finest.getAsDouble(), best)) {
                    meet(a, b, error, error == finest.getAsDouble(), best).ifPresent(all::add);
                }
            }
        }
        return all;
    }

    /**
     * Where to compare, in descending order: the errors asked about, those that one side gives where it gives clearly less than
     * asked, and the smallest that both were measured at.
     */
    private static Set<Double> errors(List<Reach> a, List<Reach> b, double finest, boolean best) {
        Set<Double> errors = new TreeSet<>(Comparator.reverseOrder());
        errors.addAll(TradeResult.TARGETS);
        for (double target : TradeResult.TARGETS) {
            meet(a, b, target, false, best).ifPresent(m -> Stream.of(m.first, m.second)
                    .filter(Need::isMoreThanAsked)
                    .forEach(n -> errors.add(n.error())));
        }
        errors.removeIf(e -> e < finest);
        errors.add(finest);
        return errors;
    }

    private static List<Reach> candidates(TradeResult result, String method, boolean best) {
        return result.reaches().stream()
                .filter(r -> best
                        ? r.contender().method().equals(method)
                        : r.contender().equals(result.settings().own(method)))
                .toList();
    }

    private static Optional<Meeting> meet(List<Reach> a, List<Reach> b, double error, boolean smallest, boolean best) {
        Optional<Need> first = TradeResult.quickest(a, error).filter(Need::isMeasured);
        Optional<Need> second = TradeResult.quickest(b, error).filter(Need::isMeasured);
        return first.isEmpty() || second.isEmpty()
                ? Optional.empty()
                : Optional.of(new Meeting(error, smallest, best, first.get(), second.get()));
    }

    /** The larger one of the smallest errors that both were measured at; one of the two may have gone below the reference's. */
    private static OptionalDouble finest(List<Reach> a, List<Reach> b) {
        OptionalDouble known = larger(known(a), known(b));
        OptionalDouble reached = larger(
                a.stream().flatMapToDouble(r -> r.smallest().stream()).min(),
                b.stream().flatMapToDouble(r -> r.smallest().stream()).min());
        boolean oneKnown = Stream.concat(a.stream(), b.stream())
                .flatMap(r -> r.finest().stream())
                .anyMatch(p -> p.error().median() == reached.orElse(0));
        return oneKnown ? reached : known;
    }

    private static OptionalDouble known(List<Reach> reaches) {
        return reaches.stream()
                .flatMap(r -> r.finest().stream())
                .mapToDouble(p -> p.error().median())
                .min();
    }

    private static OptionalDouble larger(OptionalDouble a, OptionalDouble b) {
        return a.isEmpty() || b.isEmpty()
                ? OptionalDouble.empty()
                : OptionalDouble.of(Math.max(a.getAsDouble(), b.getAsDouble()));
    }
}
