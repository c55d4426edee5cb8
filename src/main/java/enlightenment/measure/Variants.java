package enlightenment.measure;

import java.util.ArrayList;
import java.util.List;

/**
 * Which other numbers of light points are worth going on with: comparing a method at a bad setting says nothing of the method, but
 * trying all of them on the whole ladder would take the time that the comparison needs.
 */
final class Variants {
    /** By so much slower than others is not chance, and never comes back by chance. */
    private static final double CLEARLY = 1.15;

    private static final int IN_A_ROW = 2;

    private Variants() {}

    /**
     * Those that are worth another rung. What gives the same picture as the scene's own number is given up at once, and so is
     * what twice in a row was surpassed: another number of the same method gave a smaller error in clearly less time.
     */
    static List<Contender> worthGoingOn(Contender own, List<TradeRun> ladder) {
        List<Contender> left = new ArrayList<>();
        for (Contender variant : Contender.variants(own)) {
            if (!sameAs(own, variant, ladder) && !surpassed(variant, ladder)) {
                left.add(variant);
            }
        }
        return left;
    }

    private static boolean sameAs(Contender own, Contender variant, List<TradeRun> ladder) {
        return ladder.stream().filter(r -> Contender.of(r).equals(variant)).anyMatch(r -> ladder.stream()
                .anyMatch(o -> Contender.of(o).equals(own)
                        && o.seed() == r.seed()
                        && o.samples() == r.samples()
                        && o.meanSquaredDifference() == r.meanSquaredDifference()
                        && o.flip() == r.flip()));
    }

    private static boolean surpassed(Contender variant, List<TradeRun> ladder) {
        List<Curve.Point> mine = Curve.of(variant, ladder, 0).points();
        if (mine.size() < IN_A_ROW) {
            return false;
        }
        List<Curve.Point> others = ladder.stream()
                .map(Contender::of)
                .distinct()
                .filter(c -> c.method().equals(variant.method()) && !c.equals(variant))
                .flatMap(c -> Curve.of(c, ladder, 0).points().stream())
                .toList();
        return mine.subList(mine.size() - IN_A_ROW, mine.size()).stream().allMatch(p -> others.stream()
                .anyMatch(o -> o.error().median() <= p.error().median()
                        && CLEARLY * o.wall().median() <= p.wall().median()));
    }
}
