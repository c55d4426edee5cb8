package enlightenment.measure;

import enlightenment.measure.analysis.Configuration;
import enlightenment.measure.analysis.Curve;
import enlightenment.measure.trade.TradeRun;
import java.util.ArrayList;
import java.util.List;

/**
 * Selection of the numbers of light samples that a method continues with. A comparison at a bad number says nothing about the method, but
 * running all numbers over all budgets would take the time of the comparison.
 */
final class Variants {
    /** Least ratio of times that counts as a clear difference. */
    private static final double CLEARLY = 1.15;

    private static final int IN_A_ROW = 2;

    private Variants() {}

    /**
     * The variants for the next budget. Variants with the image of the scene's own number are dropped at once; others after being dominated twice
     * in a row, that is, another number gave a smaller error in clearly less time.
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
