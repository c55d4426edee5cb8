package enlightenment.measure;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;

/**
 * What to do for an error, in words. Each figure in the sentence is followed by the measured points that it comes from: tried,
 * measured, interpolated between two of them; what is only extrapolated is called so, and no ratio is made of it.
 *
 * @param target the error
 * @param best what leads there in the least time; nothing where that cannot be told
 * @param known how the sentence is known
 * @param comparisons the others, as far as they were measured there
 * @param sentence the advice: one sentence without a full stop inside but in numbers
 */
public record Verdict(double target, Optional<Need> best, Known known, List<Comparison> comparisons, String sentence) {
    /** Less of a difference than this nobody notices, and another run may turn round. */
    private static final double ALIKE = 1.1;

    /** Eight bits round by 0.0011 (1/255/√12): errors below this are kept in sixteen. */
    private static final double NEEDS_SIXTEEN_BITS = 0.006;

    public Verdict {
        comparisons = List.copyOf(comparisons);
    }

    /** How a sentence is known. */
    public enum Known {
        /** The advice was measured, and so was everything that it is compared with in numbers. */
        MEASURED,
        /** Nothing was measured there; the advice is extrapolated and the sentence says so. */
        EXTRAPOLATED,
        /** Nothing can be told, and the sentence says why. */
        NOTHING
    }

    /**
     * How much longer another way takes, both measured.
     *
     * @param need what the other needs
     * @param ratio its time divided by that of the advice
     * @param alike whether the two cannot be told apart
     */
    public record Comparison(Need need, double ratio, boolean alike) {}

    /** The advice for one error. */
    public static Verdict of(TradeResult result, double target) {
        String error = "For an error of " + Digits.samples(target);
        if (!result.isKnown(target)) {
            return nothing(
                    target,
                    error + " there is no verdict: the reference's own error is "
                            + Digits.of(result.reference().error(), 2)
                            + ", and of smaller ones it says nothing (a larger --budget makes a better one).");
        }
        Optional<Need> best = TradeResult.quickest(result.reaches(), target);
        if (best.isEmpty()) {
            return nothing(
                    target,
                    error + " there is no verdict: the smallest errors measured are " + smallest(result)
                            + " (a larger --budget goes further).");
        }
        if (best.get().isMeasured()) {
            return measured(result, best.get(), error);
        }
        String text = error + " nothing was measured; extrapolated, " + arguments(best.get(), result.settings())
                + " would take " + time(best.get()) + ", and there is no comparison.";
        return new Verdict(target, best, Known.EXTRAPOLATED, List.of(), text);
    }

    private static Verdict measured(TradeResult result, Need best, String error) {
        List<Comparison> comparisons = new ArrayList<>();
        StringBuilder text = new StringBuilder(error);
        text.append(" use ")
                .append(arguments(best, result.settings()))
                .append(": ")
                .append(time(best));
        for (Contender other : others(result, best)) {
            Optional<Comparison> comparison = result.reach(other)
                    .flatMap(r -> r.forError(best.target()))
                    .filter(Need::isMeasured)
                    .map(n -> compare(best, n));
            comparison.ifPresent(comparisons::add);
            text.append(", ")
                    .append(comparison.map(c -> phrase(best, c, result)).orElseGet(() -> notReached(result, other)));
        }
        flip(result, best).ifPresent(text::append);
        return new Verdict(
                best.target(),
                Optional.of(best),
                Known.MEASURED,
                comparisons,
                text.append('.').toString());
    }

    private static String time(Need need) {
        return Digits.of(need.wall().median(), 2) + " s (" + need.evidence() + ")";
    }

    private static Verdict nothing(double target, String sentence) {
        return new Verdict(target, Optional.empty(), Known.NOTHING, List.of(), sentence);
    }

    /** The smallest error of each method. */
    private static String smallest(TradeResult result) {
        List<String> all = new ArrayList<>();
        for (String method : result.settings().methods()) {
            result.reaches().stream()
                    .filter(r ->
                            r.contender().method().equals(method) && r.finest().isPresent())
                    .min(Comparator.comparingDouble(
                            r -> r.finest().orElseThrow().error().median()))
                    .ifPresent(r ->
                            all.add(Digits.of(r.finest().orElseThrow().error().median(), 2) + " by "
                                    + r.contender().name()));
        }
        return all.isEmpty() ? "none" : String.join(" and ", all);
    }

    /** The advice's own method as the scene has it, and the other methods as the scene has them and at their best. */
    private static List<Contender> others(TradeResult result, Need best) {
        List<Contender> others = new ArrayList<>();
        for (String method : result.settings().methods()) {
            Contender own = result.settings().own(method);
            if (!own.equals(best.contender())) {
                others.add(own);
            }
            if (!method.equals(best.method())) {
                result.best(method, best.target())
                        .filter(Need::isMeasured)
                        .map(Need::contender)
                        .filter(c -> !c.equals(own))
                        .ifPresent(others::add);
            }
        }
        return others;
    }

    private static Comparison compare(Need best, Need other) {
        double ratio = other.wall().median() / best.wall().median();
        boolean overlap = other.wall().low() <= best.wall().high();
        return new Comparison(other, ratio, ratio < ALIKE || overlap);
    }

    private static String phrase(Need best, Comparison c, TradeResult result) {
        String name = c.need.contender().name()
                + (isBestVariant(c.need, result) ? ", its best of " + numbers(result, c.need.method()) : "");
        String bound = bound(best, c.need);
        return (c.alike ? "about as fast as " : bound + Digits.of(c.ratio, 2) + " times faster than ") + name + " ("
                + c.need.evidence() + ")";
    }

    /** A time that was spent on more than was asked for says at most how long the error would have taken. */
    private static String bound(Need best, Need other) {
        if (best.isMoreThanAsked() == other.isMoreThanAsked()) {
            return "";
        }
        return other.isMoreThanAsked() ? "at most " : "at least ";
    }

    private static boolean isBestVariant(Need need, TradeResult result) {
        return !need.contender().equals(result.settings().own(need.method()));
    }

    private static String numbers(TradeResult result, String method) {
        return String.join(
                ", ",
                result.reaches().stream()
                        .map(Reach::contender)
                        .filter(c -> c.method().equals(method))
                        .map(Contender::lightPoints)
                        .sorted()
                        .distinct()
                        .map(String::valueOf)
                        .toList());
    }

    private static String notReached(TradeResult result, Contender other) {
        return result.reach(other)
                .flatMap(Reach::finest)
                .map(p -> "which " + other.name() + " was not measured to reach (its smallest error is "
                        + Digits.of(p.error().median(), 2) + ", in "
                        + Digits.of(p.wall().median(), 2) + " s)")
                .orElse("while nothing was measured of " + other.name());
    }

    /** What FLIP says, where another method makes a picture as good by FLIP in clearly less time. */
    private static Optional<String> flip(TradeResult result, Need best) {
        if (best.flip().isEmpty()) {
            return Optional.empty();
        }
        double flip = best.flip().get();
        return result.reaches().stream()
                .filter(r -> !r.contender().method().equals(best.method()))
                .flatMap(r -> r.forFlip(flip).stream())
                .min((a, b) -> Double.compare(a.wall().median(), b.wall().median()))
                .filter(n -> ALIKE * n.wall().median() <= best.wall().median())
                .map(n -> "; by FLIP it is the other way round: for a FLIP of at most " + Digits.of(flip, 2) + " "
                        + n.contender().name() + " took "
                        + Digits.of(n.wall().median(), 2) + " s (" + n.evidence() + ")");
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
                            result.own(m, target).filter(n -> n.samples() <= 1).isPresent());
            if (verdict.known == Known.MEASURED && !trivial) {
                return verdict;
            }
        }
        return of(result, TradeResult.TARGETS.get(0));
    }

    /** The options of {@code render} that the advice names, ready to be typed. */
    public static String arguments(Need need, TradeSettings settings) {
        return need.contender().options(need.samples(), settings.base().shadowSamples())
                + (need.target() < NEEDS_SIXTEEN_BITS ? " --depth 16" : "");
    }
}
