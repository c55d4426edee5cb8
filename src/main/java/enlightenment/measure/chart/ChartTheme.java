package enlightenment.measure.chart;

import enlightenment.measure.analysis.Digits;
import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.Font;
import java.util.List;
import org.knowm.xchart.XYChart;
import org.knowm.xchart.XYChartBuilder;
import org.knowm.xchart.style.Styler;
import org.knowm.xchart.style.XYStyler;
import org.knowm.xchart.style.markers.Marker;
import org.knowm.xchart.style.markers.SeriesMarkers;

/** The style of all charts: large type, few lines, colours distinguishable by the colour-blind, a marker for each series. */
final class ChartTheme {
    static final int WIDTH = 900;
    static final int HEIGHT = 560;

    /** Colours of Okabe and Ito's palette: blue, vermilion, bluish green, reddish purple, orange, sky blue, black. */
    private static final List<Color> COLORS = List.of(
            new Color(0x0072B2),
            new Color(0xD55E00),
            new Color(0x009E73),
            new Color(0xCC79A7),
            new Color(0xE69F00),
            new Color(0x56B4E9),
            new Color(0x000000));

    private static final List<Marker> MARKERS = List.of(
            SeriesMarkers.CIRCLE,
            SeriesMarkers.DIAMOND,
            SeriesMarkers.SQUARE,
            SeriesMarkers.TRIANGLE_UP,
            SeriesMarkers.TRIANGLE_DOWN);

    private static final Color INK = new Color(0x222222);
    private static final Color GRID = new Color(0xE4E4E4);
    static final Color QUIET = new Color(0x666666);
    private static final String FAMILY = Font.SANS_SERIF;
    private static final int SMALL = 15;
    private static final int MEDIUM = 17;
    private static final int MARKER = 9;
    private static final int TICK_SPACING = 60;
    private static final int PADDING = 12;

    /** The margin of a logarithmic axis on either side, as a factor. */
    private static final double MARGIN = 1.25;

    /** Largest ratio of an axis with room for more than one label per power of ten. */
    private static final double MANY_DECADES = 5000;

    private static final double MIN_RATIO = 4;
    private static final double DECADE = 10;
    private static final double NEARLY = 1e-6;

    private ChartTheme() {}

    static Color color(int series) {
        return COLORS.get(series % COLORS.size());
    }

    static Marker marker(int series) {
        return MARKERS.get(series % MARKERS.size());
    }

    static BasicStroke dashes() {
        return new BasicStroke(1.5f, BasicStroke.CAP_BUTT, BasicStroke.JOIN_ROUND, 1, new float[] {6, 5}, 0);
    }

    /** An empty chart. */
    static XYChart chart(String title, String x, String y) {
        XYChart chart = new XYChartBuilder()
                .width(WIDTH)
                .height(HEIGHT)
                .title(title)
                .xAxisTitle(x)
                .yAxisTitle(y)
                .build();
        XYStyler s = chart.getStyler();
        s.setChartTitleFont(new Font(FAMILY, Font.BOLD, MEDIUM + 1)).setChartFontColor(INK);
        s.setChartBackgroundColor(Color.WHITE).setPlotBackgroundColor(Color.WHITE);
        s.setPlotBorderVisible(false).setChartTitleBoxVisible(false).setChartPadding(PADDING);
        s.setLegendFont(new Font(FAMILY, Font.PLAIN, SMALL)).setLegendBorderColor(GRID);
        s.setLegendPosition(Styler.LegendPosition.InsideNE);
        s.setMarkerSize(MARKER);
        s.setAnnotationTextFont(new Font(FAMILY, Font.PLAIN, SMALL)).setAnnotationTextFontColor(QUIET);
        s.setAxisTitleFont(new Font(FAMILY, Font.PLAIN, MEDIUM));
        s.setAxisTickLabelsFont(new Font(FAMILY, Font.PLAIN, SMALL));
        // Solid lines: XChart draws dashes as shapes, thousands of them in an SVG file.
        s.setPlotGridLinesStroke(new BasicStroke(1)).setPlotGridLinesColor(GRID).setAxisTickLabelsColor(INK);
        s.setXAxisTickMarkSpacingHint(TICK_SPACING).setPlotMargin(0);
        return chart;
    }

    /** Makes both axes logarithmic, with plain numbers and a margin around the values. */
    static void logarithmic(XYChart chart, double[] x, double[] y) {
        XYStyler s = chart.getStyler();
        s.setXAxisLogarithmic(true).setYAxisLogarithmic(true);
        double xRoom = room(x);
        double yRoom = room(y);
        s.setXAxisMin(lowest(x) / xRoom).setXAxisMax(highest(x) * xRoom);
        s.setYAxisMin(lowest(y) / yRoom).setYAxisMax(highest(y) * yRoom);
        s.setXAxisLogarithmicDecadeOnly(false).setYAxisLogarithmicDecadeOnly(false);
        double wide = s.getXAxisMax() / s.getXAxisMin();
        double high = s.getYAxisMax() / s.getYAxisMin();
        s.setXAxisTickLabelsFormattingFunction(v -> decade(v, wide));
        s.setYAxisTickLabelsFormattingFunction(v -> decade(v, high));
    }

    /** The margin on either side, as a factor: nearly equal values are not stretched over the whole axis. */
    private static double room(double[] values) {
        return Math.max(MARGIN, Math.sqrt(MIN_RATIO * lowest(values) / highest(values)));
    }

    /** The label of a tick, or a blank. A short axis labels all ticks, longer ones those with leading digit 1, 2 or 5, or 1 only. */
    private static String decade(double value, double range) {
        double leading = value / Math.pow(10, Math.floor(Math.log10(value) + NEARLY));
        boolean shown = range < DECADE
                || isNear(leading, 1)
                || range < MANY_DECADES && (isNear(leading, 2) || isNear(leading, 5));
        return shown ? number(value) : " ";
    }

    static boolean isNear(double a, double b) {
        return Math.abs(a - b) < NEARLY;
    }

    static String number(double value) {
        String text = Digits.of(value, 2);
        return text.contains(".") ? text.replaceAll("0+$", "").replaceAll("\\.$", "") : text;
    }

    static double lowest(double[] values) {
        double lowest = Double.POSITIVE_INFINITY;
        for (double v : values) {
            lowest = Math.min(lowest, v);
        }
        return lowest;
    }

    static double highest(double[] values) {
        double highest = 0;
        for (double v : values) {
            highest = Math.max(highest, v);
        }
        return highest;
    }
}
