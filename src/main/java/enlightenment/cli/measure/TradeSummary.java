package enlightenment.cli.measure;

import enlightenment.measure.analysis.CostEstimate;
import enlightenment.measure.analysis.EqualErrorComparison;
import enlightenment.measure.analysis.TradeAnalysis;
import java.util.List;
import java.util.Locale;

/**
 * The errors at which at least two methods were measured, and the time that each of them took, as comma-separated values: a line for each.
 * docs/notes/trade.md lists the columns.
 */
final class TradeSummary {
    private static final String HEADER =
            "error,smallestReached,lightPoints,method,timesAsLong,methodLightPoints,samples,seconds,cpuSeconds,"
                    + "errorItGives,flip,known";

    private TradeSummary() {}

    static String of(TradeAnalysis result) {
        StringBuilder text = new StringBuilder(HEADER).append('\n');
        for (EqualErrorComparison m : EqualErrorComparison.all(result)) {
            for (CostEstimate n : m.costs()) {
                text.append(String.join(",", cells(m, n))).append('\n');
            }
        }
        return text.toString();
    }

    private static List<String> cells(EqualErrorComparison m, CostEstimate n) {
        return List.of(
                Double.toString(m.error()),
                Boolean.toString(m.smallest()),
                m.best() ? "best" : "scene",
                n.method(),
                Double.toString(m.timesAsLong(n)),
                Integer.toString(n.configuration().lightSamples()),
                Double.toString(n.samples()),
                Double.toString(n.wall().median()),
                n.cpu().map(c -> Double.toString(c.median())).orElse(""),
                Double.toString(n.error()),
                n.flip().map(f -> Double.toString(f)).orElse(""),
                n.source().name().toLowerCase(Locale.ROOT) + (n.undercutsTarget() ? " less" : ""));
    }
}
