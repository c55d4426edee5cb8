package enlightenment.measure;

import enlightenment.measure.analysis.Configuration;
import enlightenment.measure.analysis.Curve;
import enlightenment.measure.trade.TradeRun;
import java.util.ArrayList;
import java.util.List;

/**
 * Chooses the numbers of light samples that a method goes on with: a comparison at a bad setting says nothing about the method, but
 * running all of them over all budgets would take the time of the comparison.
 */
final class Variants {
    /** A time longer by this factor is not chance. */
    private static final double CLEARLY = 1.15;

    private static final int IN_A_ROW = 2;

    private Variants() {}

    /**
     * The variants that are worth another budget. One that gives the same image as the scene's own number is dropped at once, and
     * one that was dominated twice in a row: another number gave a smaller error in clearly less time.
     */
    static List<Configuration> worthwhile(Configuration own, List<TradeRun> series) {
        List<Configuration> left = new ArrayList<>();
        for (Configuration variant : Configuration.variants(own)) {
            if (!sameAs(own, variant, series) && !dominated(variant, series)) {
                left.add(variant);
            }
        }
        return left;
    }

    private static boolean sameAs(Configuration own, Configuration variant, List<TradeRun> series) {
        return series.stream().filter(r -> Configuration.of(r).equals(variant)).anyMatch(r -> series.stream()
                .anyMatch(o -> Configuration.of(o).equals(own)
                        && o.seed() == r.seed()
                        && o.samples() == r.samples()
                        && o.meanSquaredDifference() == r.meanSquaredDifference()
                        && o.flip() == r.flip()));
    }

    private static boolean dominated(Configuration variant, List<TradeRun> series) {
        List<Curve.Point> mine = Curve.of(variant, series, 0).points();
        if (mine.size() < IN_A_ROW) {
            return false;
        }
        List<Curve.Point> others = series.stream()
                .map(Configuration::of)
                .distinct()
                .filter(c -> c.method().equals(variant.method()) && !c.equals(variant))
                .flatMap(c -> Curve.of(c, series, 0).points().stream())
                .toList();
        return mine.subList(mine.size() - IN_A_ROW, mine.size()).stream().allMatch(p -> others.stream()
                .anyMatch(o -> o.error().median() <= p.error().median()
                        && CLEARLY * o.wall().median() <= p.wall().median()));
    }
}
