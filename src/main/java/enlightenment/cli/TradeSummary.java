package enlightenment.cli;

import enlightenment.measure.analysis.CostEstimate;
import enlightenment.measure.analysis.EqualErrorComparison;
import enlightenment.measure.analysis.TradeAnalysis;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;

/**
 * The errors at which two methods were both measured, and the time that each took, as comma-separated values. docs/trade.md lists
 * the columns.
 */
final class TradeSummary {
    private static final String HEADER =
            "error,smallestBothReached,lightPoints,timesAsLong," + columns("first") + "," + columns("second");

    private TradeSummary() {}

    private static String columns(String who) {
        return String.join(
                ",",
                List.of("Method", "LightPoints", "Samples", "Seconds", "CpuSeconds", "ErrorItGives", "Flip", "Known")
                        .stream()
                        .map(c -> who + c)
                        .toList());
    }

    static String of(TradeAnalysis result) {
        StringBuilder text = new StringBuilder(HEADER).append('\n');
        for (EqualErrorComparison m : EqualErrorComparison.all(result)) {
            List<String> cells = new ArrayList<>();
            cells.add(Double.toString(m.error()));
            cells.add(Boolean.toString(m.smallest()));
            cells.add(m.best() ? "best" : "scene");
            cells.add(Double.toString(m.ratio()));
            cost(cells, m.first());
            cost(cells, m.second());
            text.append(String.join(",", cells)).append('\n');
        }
        return text.toString();
    }

    private static void cost(List<String> cells, CostEstimate n) {
        cells.add(n.method());
        cells.add(Integer.toString(n.configuration().lightSamples()));
        cells.add(Double.toString(n.samples()));
        cells.add(Double.toString(n.wall().median()));
        cells.add(n.cpu().map(c -> Double.toString(c.median())).orElse(""));
        cells.add(Double.toString(n.error()));
        cells.add(n.flip().map(f -> Double.toString(f)).orElse(""));
        cells.add(n.source().name().toLowerCase(Locale.ROOT) + (n.undercutsTarget() ? " less" : ""));
    }
}
