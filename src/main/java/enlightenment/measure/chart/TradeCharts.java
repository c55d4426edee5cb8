package enlightenment.measure.chart;

import enlightenment.measure.analysis.Curve;
import enlightenment.measure.analysis.Digits;
import enlightenment.measure.analysis.PowerLaw;
import enlightenment.measure.analysis.SweepResult;
import enlightenment.measure.analysis.TradeAnalysis;
import enlightenment.measure.trade.TradeResult;
import enlightenment.measure.trade.TradeRun;
import enlightenment.measure.trade.TradeSettings;
import java.awt.Font;
import java.awt.Graphics2D;
import java.awt.image.BufferedImage;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.function.Function;
import java.util.function.ToDoubleFunction;
import java.util.stream.IntStream;
import org.knowm.xchart.AnnotationText;
import org.knowm.xchart.XYChart;
import org.knowm.xchart.XYSeries;
import org.knowm.xchart.style.Styler;
import org.knowm.xchart.style.markers.SeriesMarkers;

/** The charts of a measurement of speed against accuracy. */
public final class TradeCharts {
    private static final float LINE = 2.2f;
    private static final String OVER_TIME = "error-over-time";
    private static final String OVER_SAMPLES = "error-over-samples";
    private static final String OVER_PROCESSOR_TIME = "error-over-processor-time";
    private static final double PERCENT = 100;

    private TradeCharts() {}

    /** The reason why this machine cannot draw charts; empty if it can. Some small containers have no fonts. */
    public static Optional<String> whyNot() {
        try {
            BufferedImage canvas = new BufferedImage(1, 1, BufferedImage.TYPE_INT_RGB);
            Graphics2D g = canvas.createGraphics();
            g.getFontMetrics(new Font(Font.SANS_SERIF, Font.PLAIN, 1)).stringWidth("0");
            g.dispose();
            return Optional.empty();
        } catch (RuntimeException | LinkageError | InternalError e) {
            // The kind that AWT throws without fonts depends on its version.
            return Optional.of("this Java finds no fonts (" + e + ")");
        }
    }

    /** The names of all charts that {@link #of} may return. */
    public static List<String> names(TradeSettings settings) {
        List<String> names = new ArrayList<>(List.of(OVER_TIME, OVER_SAMPLES, OVER_PROCESSOR_TIME));
        settings.sweeps().forEach(sweep -> names.add(SweepChart.name(sweep)));
        return names;
    }

    /** The horizontal axis of a chart of errors. */
    private record Budgets(
            String name,
            String title,
            String axis,
            ToDoubleFunction<TradeRun> ofRun,
            ToDoubleFunction<Curve.Point> ofPoint,
            Function<Curve, Optional<PowerLaw>> fit) {}

    /** All charts that the result has points for. */
    public static List<Chart> of(TradeAnalysis result) {
        int number = result.settings().base().threads();
        String threads = number == 1 ? "1 thread" : number + " threads";
        List<Budgets> all = List.of(
                new Budgets(
                        OVER_TIME,
                        "Error against time: lower left is better",
                        "time for the picture in seconds by the clock, " + threads,
                        TradeRun::wallSeconds,
                        p -> p.wall().median(),
                        Curve::overTime),
                new Budgets(
                        OVER_SAMPLES,
                        "Error against samples",
                        "camera rays per pixel",
                        TradeRun::samplesPerPixel,
                        Curve.Point::samplesPerPixel,
                        Curve::overSamples),
                new Budgets(
                        OVER_PROCESSOR_TIME,
                        "Error against processor time: less disturbed by other work",
                        "time of all processors together in seconds",
                        TradeRun::cpuSeconds,
                        p -> p.cpu().median(),
                        c -> Optional.empty()));
        List<Chart> charts = new ArrayList<>();
        all.forEach(budgets -> errors(result, budgets).ifPresent(charts::add));
        for (SweepResult sweep : result.sweeps()) {
            SweepChart.of(sweep, number).ifPresent(charts::add);
        }
        return charts;
    }

    private static Optional<Chart> errors(TradeAnalysis result, Budgets budgets) {
        XYChart chart = ChartTheme.chart(budgets.title, budgets.axis, "error (RMSE, 1 = black against white)");
        List<Double> allX = new ArrayList<>();
        List<Double> allY = new ArrayList<>();
        List<Curve> curves = shown(result);
        for (int i = 0; i < curves.size(); i++) {
            for (double[] run : draw(chart, result, budgets, curves, i)) {
                allX.add(run[0]);
                allY.add(run[1]);
            }
        }
        if (allX.isEmpty()) {
            return Optional.empty();
        }
        double[] x = numbers(allX, Double::doubleValue);
        double[] y = numbers(allY, Double::doubleValue);
        ChartTheme.logarithmic(chart, x, y);
        targets(chart);
        // The lower left is empty: no error is small at once. The upper right is empty as well if all errors fall.
        boolean allFall = curves.stream().noneMatch(c -> result.isBlind(c.method()));
        chart.getStyler().setLegendPosition(allFall ? Styler.LegendPosition.InsideNE : Styler.LegendPosition.InsideSW);
        return Optional.of(new Chart(budgets.name, budgets.title + ". The numbers are in the tables below.", chart));
    }

    /** Draws the line of one of the curves, and its runs, which are returned as x and y. */
    private static List<double[]> draw(
            XYChart chart, TradeAnalysis result, Budgets budgets, List<Curve> curves, int i) {
        Curve curve = curves.get(i);
        boolean isBlind = result.isBlind(curve.method());
        double variance = result.result().reference().variance();
        List<Curve.Point> points = curve.judgedPoints().stream()
                .filter(p -> budgets.ofPoint.applyAsDouble(p) > 0)
                .toList();
        if (points.isEmpty()) {
            return List.of();
        }
        String label = name(curve, curves) + (isBlind ? " (does not see all)" : "");
        // Error by light that is not sampled does not fall with a power of the samples.
        Optional<PowerLaw> law = isBlind ? Optional.empty() : budgets.fit.apply(curve);
        line(
                chart,
                legend(label, law),
                numbers(points, budgets.ofPoint),
                numbers(points, p -> p.error().median()),
                i);
        List<TradeRun> runs = result.result().runs().stream()
                .filter(r -> r.kind().equals(TradeRun.BUDGET_SERIES)
                        && curve.configuration().made(r)
                        && r.isJudged(variance)
                        && budgets.ofRun.applyAsDouble(r) > 0)
                .toList();
        double[] x = numbers(runs, budgets.ofRun);
        double[] y = numbers(runs, r -> r.error(variance));
        dots(chart, label + ", each run", x, y, i);
        return IntStream.range(0, x.length)
                .mapToObj(k -> new double[] {x[k], y[k]})
                .toList();
    }

    private static <T> double[] numbers(List<T> items, ToDoubleFunction<T> value) {
        return items.stream().mapToDouble(value).toArray();
    }

    /** The methods with the scene's number of light samples, and with another one that is best for some target error. */
    private static List<Curve> shown(TradeAnalysis result) {
        return result.curves().stream()
                .filter(c -> c.configuration().equals(result.own(c.method()))
                        || TradeResult.TARGETS.stream().anyMatch(t -> result.best(c.method(), t)
                                .filter(n -> n.configuration().equals(c.configuration()))
                                .isPresent()))
                .toList();
    }

    /** The label of a curve: the method's name alone if it has a single curve. */
    private static String name(Curve curve, List<Curve> shown) {
        boolean only =
                shown.stream().filter(c -> c.method().equals(curve.method())).count() == 1;
        return only ? curve.method() : curve.configuration().name();
    }

    private static String legend(String method, Optional<PowerLaw> fit) {
        if (fit.isEmpty()) {
            return method;
        }
        PowerLaw law = fit.get();
        String slope = String.format(Locale.ROOT, "%s: slope %.2f", method, law.slope());
        double half = (law.slopeHigh() - law.slopeLow()) / 2;
        return Double.isFinite(half) ? slope + String.format(Locale.ROOT, " ± %.2f", half) : slope;
    }

    private static void line(XYChart chart, String name, double[] x, double[] y, int i) {
        XYSeries series = chart.addSeries(name, x, y);
        series.setMarker(ChartTheme.marker(i)).setMarkerColor(ChartTheme.color(i));
        series.setLineColor(ChartTheme.color(i)).setLineWidth(LINE);
    }

    /** Adds all single runs, whose scatter is due to chance and other load of the machine. */
    private static void dots(XYChart chart, String name, double[] x, double[] y, int i) {
        XYSeries series = chart.addSeries(name, x, y);
        series.setXYSeriesRenderStyle(XYSeries.XYSeriesRenderStyle.Scatter);
        series.setMarker(i % 2 == 0 ? SeriesMarkers.PLUS : SeriesMarkers.CROSS).setMarkerColor(ChartTheme.color(i));
        series.setShowInLegend(false);
    }

    /** Adds a horizontal line for each target error within the chart. */
    private static void targets(XYChart chart) {
        double left = chart.getStyler().getXAxisMin();
        double right = chart.getStyler().getXAxisMax();
        for (double target : TradeResult.TARGETS) {
            if (target > chart.getStyler().getYAxisMin()
                    && target < chart.getStyler().getYAxisMax()) {
                String name = Digits.samples(PERCENT * target) + " %";
                XYSeries series = chart.addSeries(name, new double[] {left, right}, new double[] {target, target});
                series.setMarker(SeriesMarkers.NONE)
                        .setLineColor(ChartTheme.QUIET)
                        .setLineStyle(ChartTheme.dashes());
                series.setShowInLegend(false);
                // A little above the line at its left end, on logarithmic axes.
                double place = left * Math.pow(right / left, 0.04);
                double bottom = chart.getStyler().getYAxisMin();
                double lift = Math.pow(chart.getStyler().getYAxisMax() / bottom, 0.028);
                chart.addAnnotation(new AnnotationText(name, place, target * lift, false));
            }
        }
    }
}
