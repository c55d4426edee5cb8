package enlightenment.measure;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;

/**
 * What to do for an error, in words.
 *
 * @param target the error
 * @param best what leads there in the least time, if anything is known to
 * @param sentence the advice: one sentence without a full stop inside but in numbers
 */
public record Verdict(double target, Optional<Need> best, String sentence) {
    /** Less of a difference than this nobody notices, and another run may turn round. */
    private static final double ALIKE = 1.1;

    /** Eight bits round by 0.0011 (1/255/√12): errors below this are kept in sixteen. */
    private static final double NEEDS_SIXTEEN_BITS = 0.006;

    /** The advice for one error. */
    public static Verdict of(TradeResult result, double target) {
        List<Need> needs = new ArrayList<>();
        for (String method : result.settings().methods()) {
            result.need(method, target).ifPresent(needs::add);
        }
        // What was rendered goes before what is only expected.
        Optional<Need> best = needs.stream()
                .min(Comparator.<Need>comparingInt(n -> n.source() == Need.Source.BEYOND ? 1 : 0)
                        .thenComparingDouble(n -> n.wall().median()));
        String error = "For an error of " + Digits.samples(target);
        if (best.isEmpty()) {
            return new Verdict(target, best, error + " nothing is known: there was no time to find out.");
        }
        StringBuilder text = new StringBuilder(error).append(" use ").append(arguments(best.get()));
        text.append(": ").append(seconds(best.get()));
        for (String method : result.settings().methods()) {
            if (!method.equals(best.get().method())) {
                text.append(", ").append(compared(best.get(), result.need(method, target), method));
            }
        }
        return new Verdict(target, best, text.append('.').toString());
    }

    /** The advice for all of {@link TradeResult#TARGETS}. */
    public static List<Verdict> all(TradeResult result) {
        return TradeResult.TARGETS.stream().map(t -> of(result, t)).toList();
    }

    /** The advice that says most: for the largest error that is not had with a single sample by every method. */
    public static Verdict headline(TradeResult result) {
        for (double target : TradeResult.TARGETS) {
            Verdict verdict = of(result, target);
            boolean trivial = result.settings().methods().stream()
                    .allMatch(m ->
                            result.need(m, target).filter(n -> n.samples() <= 1).isPresent());
            if (verdict.best.isPresent() && !trivial) {
                return verdict;
            }
        }
        return of(result, TradeResult.TARGETS.get(0));
    }

    /** The options of {@code render} that the advice names, ready to be typed. */
    public static String arguments(Need need) {
        return "--method " + need.method() + " --samples " + Digits.samples(need.samples())
                + (need.target() < NEEDS_SIXTEEN_BITS ? " --depth 16" : "");
    }

    private static String seconds(Need need) {
        String time = Digits.of(need.wall().median(), 2) + " s";
        return switch (need.source()) {
            case TRIED -> time;
            case BETWEEN -> "about " + time;
            case BEYOND -> "probably about " + time + " (not tried: the line in the chart goes on there)";
        };
    }

    private static String compared(Need best, Optional<Need> other, String method) {
        if (other.isEmpty()) {
            return "which " + method + " did not reach in the time given";
        }
        double ratio = other.get().wall().median() / best.wall().median();
        boolean overlap = other.get().wall().low() <= best.wall().high();
        if (ratio < ALIKE || overlap) {
            return "which is about as fast as " + method;
        }
        boolean guess = other.get().source() == Need.Source.BEYOND || best.source() == Need.Source.BEYOND;
        return (guess ? "probably " : "") + Digits.of(ratio, 2) + " times faster than " + method;
    }
}
