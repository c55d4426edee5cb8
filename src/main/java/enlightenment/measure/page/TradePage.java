package enlightenment.measure.page;

import enlightenment.measure.analysis.Configuration;
import enlightenment.measure.analysis.CostEstimate;
import enlightenment.measure.analysis.Curve;
import enlightenment.measure.analysis.Digits;
import enlightenment.measure.analysis.EqualErrorComparison;
import enlightenment.measure.analysis.EqualTimeComparison;
import enlightenment.measure.analysis.EqualTimePicture;
import enlightenment.measure.analysis.MeasuredCosts;
import enlightenment.measure.analysis.MethodChoice;
import enlightenment.measure.analysis.SweepResult;
import enlightenment.measure.analysis.TradeAnalysis;
import enlightenment.measure.analysis.Verdict;
import enlightenment.measure.chart.Chart;
import enlightenment.measure.trade.TradeResult;
import enlightenment.scene.BuiltInMethod;
import enlightenment.scene.RenderSettings;
import enlightenment.scene.Shading;
import java.io.IOException;
import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Locale;
import java.util.Set;

/** The page of a measurement: one self-contained HTML file. */
public final class TradePage {
    private static final double PERCENT = 100;
    private static final double QUIET_SHARE = 0.75;

    private final TradeAnalysis result;
    private final EqualTimeComparison equalTime;
    private final PageContext context;
    private final Html html = new Html();

    private TradePage(TradeAnalysis result, EqualTimeComparison equalTime, PageContext context) {
        this.result = result;
        this.equalTime = equalTime;
        this.context = context;
    }

    /**
     * The page, in HTML.
     *
     * @param charts charts in their order on the page; one whose name begins with "sweep-" is shown with its sweep
     */
    public static String of(
            TradeAnalysis result, EqualTimeComparison equalTime, PageContext context, List<Chart> charts)
            throws IOException {
        TradePage page = new TradePage(result, equalTime, context);
        page.begin();
        page.busy();
        page.verdict();
        page.charts(charts);
        page.costs();
        page.pictures();
        page.sweeps(charts);
        page.budgets();
        page.howMeasured();
        return page.html.raw("</main></body></html>\n").toString();
    }

    private void begin() {
        RenderSettings s = result.settings().base();
        html.raw("<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\">\n");
        html.raw("<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n");
        html.element("title", "Speed against accuracy: " + context.title());
        html.raw("<style>\n" + PageStyle.CSS + "</style></head><body><main>\n");
        html.element("h1", context.title() + ": speed against accuracy");
        boolean isPhysical = result.settings().shading() == Shading.Model.PHYSICAL;
        RenderSettings.Crop region = s.region();
        html.element(
                "p class=\"quiet\"",
                region.width() + " × " + region.height() + " pixels, "
                        + (isPhysical
                                ? ""
                                : BuiltInMethod.RayTraceSettings.of(s).shadowSamples() + " light samples per hit, ")
                        + s.threads() + (s.threads() == 1 ? " thread" : " threads")
                        + ". The figures hold for this size and these settings.");
        if (!result.result().conditions().complete()) {
            html.element(
                    "p class=\"warning\"", "The measurement was stopped before its end: these are the results so far.");
        }
    }

    /** Adds a warning if other load of the machine made times unreliable. */
    private void busy() {
        double share = result.shareOfProcessors();
        if (share < QUIET_SHARE) {
            html.element(
                    "p class=\"warning\"",
                    "The machine was busy with other work: the renders got "
                            + Math.round(PERCENT * share)
                            + " % of the processors they asked for. Seconds by the clock are too long "
                            + "and scatter; processor times are more reliable. Errors are not affected.");
        }
    }

    private void verdict() {
        MethodChoice choice = MethodChoice.of(result);
        Verdict headline = Verdict.headline(result);
        html.raw("<section class=\"verdict\">\n");
        if (choice.sentence().isPresent()) {
            html.element("p class=\"big\"", choice.sentence().get());
        }
        for (String spot : choice.leftOut()) {
            html.element("p", "Left out: " + spot + ".");
        }
        html.element(choice.sentence().isPresent() ? "p" : "p class=\"big\"", headline.sentence());
        headline.best().ifPresent(best -> {
            html.element("pre", context.render(best, result.settings()));
            if (best.source() == CostEstimate.Source.TRIED) {
                html.element(
                        "p",
                        "This was tried: the picture that this command makes has an error of "
                                + (best.error() > result.result().reference().error() ? "" : "at most ")
                                + Digits.of(best.error(), 3)
                                + ". Repeated, it makes the same picture, to the last bit. The time is by the clock on this machine after "
                                + "Java's warm-up; the first render of a process took "
                                + Digits.of(
                                        Math.max(result.result().conditions().coldSeconds(), 0.01), 2)
                                + " s longer. To check it:");
                html.element("pre", context.compareCommand());
                html.element(
                        "p",
                        "will say RMSE "
                                + Digits.of(
                                        Math.hypot(
                                                best.error(),
                                                result.result().reference().error()),
                                        3) + " but for the rounding of the file.");
            }
        });
        html.raw("</section>\n");
        html.raw("<ul>\n");
        for (Verdict verdict : Verdict.all(result)) {
            if (verdict.target() != headline.target()) {
                html.element("li", verdict.sentence());
            }
        }
        html.raw("</ul>\n");
        html.element(
                "p",
                "An error of 0.01 is a root mean square error, over all pixels and colours, of one percent of white. "
                        + "One step of an 8-bit picture is 0.0039.");
    }

    private void charts(List<Chart> charts) throws IOException {
        html.element("h2", "Error against time");
        for (Chart chart : charts) {
            if (!chart.name().startsWith("sweep-")) {
                html.drawing(chart.svg(), chart.description());
            }
        }
        html.element(
                "p",
                "Both axes are logarithmic. Choose an error, go across to the first line, and read the time below it. A "
                        + "slope of −0.5 means that half the error costs four times the samples, −1 that it costs twice. "
                        + "Small crosses are single renders, lines go through the medians. The ± of a slope is its 95 % "
                        + "confidence interval.");
    }

    private void costs() {
        html.element("h2", "What an error costs");
        List<List<String>> rows = new ArrayList<>();
        for (double target : TradeResult.TARGETS) {
            for (MeasuredCosts reach : result.costs()) {
                if (result.isKnown(target)) {
                    reach.forError(target).ifPresent(n -> rows.add(row(n)));
                }
            }
        }
        html.table(
                List.of("error", "by", "options", "error it gives", "FLIP", "seconds", "CPU seconds", "how known"),
                rows);
        html.element(
                "p",
                "An error that is missing here was not measured, or is below the reference's own, "
                        + Digits.of(result.result().reference().error(), 2) + ": nothing is known there.");
        comparisons();
    }

    private List<String> row(CostEstimate n) {
        return List.of(
                Digits.samples(PERCENT * n.target()) + " %",
                n.configuration().name(),
                Verdict.arguments(n, result.settings()),
                Digits.of(n.error(), 3),
                n.flip().map(f -> Digits.of(f, 2)).orElse("–"),
                spread(n.wall().low(), n.wall().median(), n.wall().high()),
                n.cpu().map(c -> Digits.of(c.median(), 2)).orElse("–"),
                n.evidence()
                        + (n.source() == CostEstimate.Source.TRIED
                                ? ", " + runs(n.wall().count())
                                : ""));
    }

    private static String runs(int count) {
        return count + (count == 1 ? " run" : " runs");
    }

    /** Adds the ratios of times at errors that several methods were measured at. */
    private void comparisons() {
        Set<List<String>> rows = new LinkedHashSet<>();
        for (EqualErrorComparison m : EqualErrorComparison.all(result)) {
            for (CostEstimate n : m.costs()) {
                rows.add(List.of(
                        Digits.of(m.error(), 2) + (m.smallest() ? ", the smallest that these reached" : ""),
                        n.configuration().name(),
                        Digits.of(n.wall().median(), 2),
                        Digits.of(m.timesAsLong(n), 2),
                        n.flip().map(f -> Digits.of(f, 2)).orElse("–"),
                        n.evidence()));
            }
        }
        if (!rows.isEmpty()) {
            html.element("h2", "Times at equal error");
            html.table(
                    List.of("error", "by", "seconds", "times as long as the fastest", "FLIP", "how known"),
                    List.copyOf(rows));
        }
    }

    private static String spread(double low, double median, double high) {
        return low == high
                ? Digits.of(median, 2)
                : Digits.of(median, 2) + " (" + Digits.of(low, 2) + " to " + Digits.of(high, 2) + ")";
    }

    private void pictures() throws IOException {
        if (equalTime.pictures().isEmpty()) {
            return;
        }
        html.element("h2", equalTime.isEqual() ? "Pictures at equal time" : "Pictures, not at equal time");
        double variance = result.result().reference().variance();
        equalTime.sentence().ifPresent(s -> html.element("p", s));
        html.raw("<div class=\"side\">\n");
        for (EqualTimePicture e : equalTime.pictures()) {
            html.raw("<div>\n");
            String name = Configuration.of(e.run()).name();
            String what = name + ", " + Digits.samples(e.run().samples()) + " samples, "
                    + Digits.of(e.run().wallSeconds(), 2) + " s: error "
                    + Digits.of(e.run().error(variance), 3) + ", FLIP "
                    + Digits.of(e.run().flip(), 3);
            if (e.image().isPresent()) {
                html.picture(e.image().get(), context.title() + " by " + e.run().method(), what);
            } else {
                html.element("p", what);
            }
            if (e.difference().isPresent()) {
                html.picture(
                        e.difference().get(),
                        "difference from the reference",
                        "difference from the reference (black: none), times " + e.gain());
            }
            html.raw("</div>\n");
        }
        html.raw("</div>\n");
        if (result.result().reference().picture().isPresent()) {
            html.picture(result.result().reference().image(), context.title() + ", reference", "the reference");
        }
    }

    private void sweeps(List<Chart> charts) throws IOException {
        for (SweepResult sweep : result.sweeps()) {
            html.element("h2", sweep.sweep().name() + ": what each value costs and gains");
            html.element("p", "All other settings are the scene's; method " + sweep.method() + ".");
            for (Chart chart : charts) {
                if (chart.name().equals("sweep-" + sweep.sweep().name())) {
                    html.drawing(chart.svg(), chart.description());
                }
            }
            List<List<String>> rows = new ArrayList<>();
            SweepResult.Point before = null;
            for (SweepResult.Point p : sweep.points()) {
                rows.add(List.of(
                        Integer.toString(p.value()),
                        spread(p.wall().low(), p.wall().median(), p.wall().high()),
                        Digits.of(p.cpu().median(), 2),
                        p.judged() ? Digits.of(p.error().median(), 3) : "below the reference's",
                        before == null
                                ? ""
                                : change(p.wall().median(), before.wall().median()),
                        before == null || !before.judged() || !p.judged()
                                ? ""
                                : change(p.error().median(), before.error().median())));
                before = p;
            }
            html.table(
                    List.of(sweep.sweep().name(), "seconds", "CPU seconds", "error", "time, change", "error, change"),
                    rows);
            int missing = sweep.sweep().values().size() - sweep.points().size();
            if (missing > 0) {
                html.element("p class=\"warning\"", "There was no time for the last " + missing + " values.");
            }
        }
    }

    private static String change(double now, double before) {
        return before == 0 ? "" : String.format(Locale.ROOT, "%+.0f %%", PERCENT * (now / before - 1));
    }

    private void budgets() {
        html.element("h2", "All budgets");
        List<List<String>> rows = new ArrayList<>();
        for (Curve curve : result.curves()) {
            for (Curve.Point p : curve.points()) {
                rows.add(List.of(
                        curve.configuration().name(),
                        Digits.samples(p.samples()),
                        Digits.of(p.samplesPerPixel(), 3),
                        Integer.toString(p.wall().count()),
                        spread(p.wall().low(), p.wall().median(), p.wall().high()),
                        Digits.of(p.cpu().median(), 2),
                        p.judged() ? Digits.of(p.error().median(), 3) : "below the reference's",
                        Digits.of(p.flip().median(), 3),
                        Digits.of(p.estimated().median(), 3)));
            }
        }
        for (String spot : result.result().blindSpots().values()) {
            html.element("p", spot + ": its errors include what is missing.");
        }
        html.table(
                List.of(
                        "by",
                        "--samples",
                        "rays per pixel",
                        "runs",
                        "seconds",
                        "CPU seconds",
                        "error",
                        "FLIP",
                        "its own estimate"),
                rows);
        for (Curve curve : result.curves()) {
            if (curve.judged() > 0) {
                html.element(
                        "p",
                        curve.configuration().name() + ": in " + curve.insideOwnInterval() + " of " + curve.judged()
                                + " runs the error lay in the render's own 95 % interval.");
            }
        }
    }

    private void howMeasured() {
        html.element("h2", "How this was measured");
        boolean isGiven = result.result().reference().parts().isEmpty();
        html.element(
                "p",
                result.referenceSentence()
                        + (isGiven ? "" : " What it was rendered by had the least error for its time in a trial.")
                        + " Its error has been taken off the errors above (as squares). "
                        + "Runs whose error is smaller are left out: it cannot be distinguished from the reference's.");
        html.element(
                "p",
                "Java was warmed up first. The methods took turns, render by render, so that a busy machine disturbs "
                        + "all alike; times are medians, with the smallest and the largest, from the scene in memory to the "
                        + "finished picture, without reading and writing files. Every render in the table of budgets has "
                        + "random numbers of its own.");
        List<List<String>> rows = new ArrayList<>();
        result.result().conditions().machine().forEach((k, v) -> rows.add(List.of(k, v)));
        rows.add(List.of("command", context.tradeCommand()));
        rows.add(List.of(
                "this took",
                Digits.of(result.result().conditions().seconds(), 3) + " s, "
                        + result.result().runs().size() + " runs"));
        html.table(List.of("what", "value"), rows);
    }
}
