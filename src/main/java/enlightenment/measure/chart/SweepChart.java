package enlightenment.measure.chart;

import enlightenment.measure.analysis.SweepResult;
import enlightenment.measure.trade.Sweep;
import java.util.List;
import java.util.Optional;
import org.knowm.xchart.AnnotationText;
import org.knowm.xchart.XYChart;
import org.knowm.xchart.XYSeries;
import org.knowm.xchart.style.Styler;
import org.knowm.xchart.style.markers.SeriesMarkers;

/** The charts of sweeps: error against time with the values beside the points, and time against threads. */
final class SweepChart {
    private static final float LINE = 2.2f;

    /** Height of a label above its point, as a share of the chart's height on the logarithmic axis. */
    private static final double LIFT = 0.045;

    private SweepChart() {}

    /** The name of the chart of a sweep. */
    static String name(Sweep sweep) {
        return "sweep-" + sweep.name();
    }

    static Optional<Chart> of(SweepResult result, int usualThreads) {
        if (result.points().size() < 2) {
            return Optional.empty();
        }
        boolean threads = result.sweep().name().equals("threads");
        if (!threads && result.points().stream().noneMatch(SweepResult.Point::judged)) {
            return Optional.empty();
        }
        return Optional.of(threads ? threads(result) : errors(result, usualThreads));
    }

    private static Chart errors(SweepResult result, int threads) {
        String name = result.sweep().name();
        String title = name + " with " + result.method() + ": what each value costs and gains";
        XYChart chart = ChartTheme.chart(
                title,
                "time for the picture in seconds by the clock, " + threads + (threads == 1 ? " thread" : " threads"),
                "error (RMSE, 1 = black against white)");
        List<SweepResult.Point> points =
                result.points().stream().filter(SweepResult.Point::judged).toList();
        double[] x = points.stream().mapToDouble(p -> p.wall().median()).toArray();
        double[] y = points.stream().mapToDouble(p -> p.error().median()).toArray();
        series(chart, name, x, y, 0);
        ChartTheme.logarithmic(chart, x, y);
        chart.getStyler().setLegendVisible(false);
        double lift =
                Math.pow(chart.getStyler().getYAxisMax() / chart.getStyler().getYAxisMin(), LIFT);
        for (int i = 0; i < points.size(); i++) {
            chart.addAnnotation(
                    new AnnotationText(Integer.toString(points.get(i).value()), x[i], y[i] * lift, false));
        }
        return new Chart(name(result.sweep()), title + ". The numbers are in the table below.", chart);
    }

    private static Chart threads(SweepResult result) {
        String title = "threads with " + result.method() + ": time against threads";
        XYChart chart = ChartTheme.chart(title, "threads", "time for the picture in seconds by the clock");
        double[] x =
                result.points().stream().mapToDouble(SweepResult.Point::value).toArray();
        double[] y =
                result.points().stream().mapToDouble(p -> p.wall().median()).toArray();
        double[] ideal = new double[x.length];
        for (int i = 0; i < x.length; i++) {
            ideal[i] = y[0] * x[0] / x[i];
        }
        series(chart, "measured", x, y, 0);
        XYSeries line = chart.addSeries("perfect scaling", x, ideal);
        line.setMarker(SeriesMarkers.NONE).setLineColor(ChartTheme.QUIET).setLineStyle(ChartTheme.dashes());
        chart.getStyler().setYAxisMin(0.0).setYAxisMax(1.15 * ChartTheme.highest(y));
        chart.getStyler().setXAxisMin(x[0] - 0.5).setXAxisMax(x[x.length - 1] + 0.5);
        chart.getStyler()
                .setXAxisTickLabelsFormattingFunction(
                        v -> ChartTheme.isNear(v, Math.rint(v)) ? ChartTheme.number(Math.rint(v)) : " ");
        chart.getStyler().setYAxisTickLabelsFormattingFunction(ChartTheme::number);
        chart.getStyler().setLegendPosition(Styler.LegendPosition.InsideNE);
        return new Chart(name(result.sweep()), title + ". The numbers are in the table below.", chart);
    }

    private static void series(XYChart chart, String name, double[] x, double[] y, int i) {
        XYSeries series = chart.addSeries(name, x, y);
        series.setMarker(ChartTheme.marker(i)).setMarkerColor(ChartTheme.color(i));
        series.setLineColor(ChartTheme.color(i)).setLineWidth(LINE);
    }
}
