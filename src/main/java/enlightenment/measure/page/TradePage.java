package enlightenment.measure.page;

import enlightenment.measure.Curve;
import enlightenment.measure.Digits;
import enlightenment.measure.EqualTime;
import enlightenment.measure.Need;
import enlightenment.measure.Reference;
import enlightenment.measure.SweepResult;
import enlightenment.measure.TradeResult;
import enlightenment.measure.Verdict;
import enlightenment.measure.chart.Chart;
import enlightenment.scene.RenderSettings;
import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;

/** Everything that a trade found, as one page that needs nothing but itself. */
public final class TradePage {
    private static final double PERCENT = 100;
    private static final double QUIET_SHARE = 0.75;

    private final TradeResult result;
    private final PageContext context;
    private final Html html = new Html();

    private TradePage(TradeResult result, PageContext context) {
        this.result = result;
        this.context = context;
    }

    /**
     * The page, in HTML.
     *
     * @param charts shown in this order; those whose name begins with "sweep-" with the sweeps
     */
    public static String of(TradeResult result, PageContext context, List<Chart> charts) throws IOException {
        TradePage page = new TradePage(result, context);
        page.begin();
        page.busy();
        page.verdict();
        page.charts(charts);
        page.needs();
        page.pictures();
        page.sweeps(charts);
        page.ladder();
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
        RenderSettings.Crop region = s.region();
        html.element(
                "p class=\"quiet\"",
                region.width() + " × " + region.height() + " pixels, " + s.shadowSamples() + " light points per hit, "
                        + s.threads() + (s.threads() == 1 ? " thread" : " threads")
                        + ". All that is said here holds for this size and these settings.");
        if (!result.complete()) {
            html.element("p class=\"warning\"", "The measurement was stopped before its end: this is what is known.");
        }
    }

    /** Where neighbours took much of the machine, times are worth little, and that has to be said first. */
    private void busy() {
        double share = result.shareOfProcessors();
        if (share < QUIET_SHARE) {
            html.element(
                    "p class=\"warning\"",
                    "The machine was busy with other work: the renders got "
                            + Math.round(PERCENT * share)
                            + " % of the processors they asked for. Seconds by the clock are longer than they would be, "
                            + "and scatter; the processor times are worth more. Errors are not affected.");
        }
    }

    private void verdict() {
        Verdict headline = Verdict.headline(result);
        html.raw("<section class=\"verdict\">\n").element("p class=\"big\"", headline.sentence());
        headline.best().ifPresent(best -> {
            html.element("pre", context.renderCommand() + " " + Verdict.arguments(best));
            if (best.source() == Need.Source.TRIED) {
                html.element(
                        "p",
                        "This was tried: the picture that this command makes has an error of "
                                + Digits.of(best.error(), 3)
                                + ". It makes the same picture for you, to the last bit. The time is by the clock on this machine once Java has warmed up; as the first "
                                + "render of a process it took "
                                + Digits.of(Math.max(result.coldSeconds(), 0.01), 2) + " s longer. To check it:");
                html.element("pre", context.compareCommand());
                html.element(
                        "p",
                        "will say RMSE "
                                + Digits.of(
                                        Math.hypot(
                                                best.error(), result.reference().error()),
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
                "An error of 0.01 means: the numbers of the picture (0 is black, 1 is white) are off by one percent of "
                        + "white, as a root mean square over all pixels and colours. One step of an 8-bit picture is 0.0039.");
    }

    private void charts(List<Chart> charts) throws IOException {
        html.element("h2", "The trade");
        for (Chart chart : charts) {
            if (!chart.name().startsWith("sweep-")) {
                html.drawing(chart.svg(), chart.description());
            }
        }
        html.element(
                "p",
                "Both axes are logarithmic: each step along an axis multiplies. Choose the error you can live with, go "
                        + "across to the first line you meet, and read the time below it. A slope of −0.5 means that half the "
                        + "error costs four times the samples, −1 that it costs twice. Small crosses are single renders, "
                        + "lines go through the medians. The ± of a slope is an interval of 95 %.");
    }

    private void needs() {
        html.element("h2", "What an error costs");
        List<List<String>> rows = new ArrayList<>();
        for (Need n : result.needs()) {
            rows.add(List.of(
                    Digits.samples(PERCENT * n.target()) + " %",
                    n.method(),
                    Digits.samples(n.samples()),
                    Digits.of(n.error(), 3),
                    spread(n.wall().low(), n.wall().median(), n.wall().high()),
                    n.cpu().map(c -> Digits.of(c.median(), 2)).orElse("–"),
                    switch (n.source()) {
                        case TRIED -> "tried, " + n.wall().count() + (n.wall().count() == 1 ? " run" : " runs");
                        case BETWEEN -> "between two that were";
                        case BEYOND -> "not tried: beyond what there was time for";
                    }));
        }
        html.table(
                List.of("error", "method", "--samples", "error it gives", "seconds", "CPU seconds", "known because"),
                rows);
    }

    private static String spread(double low, double median, double high) {
        return low == high
                ? Digits.of(median, 2)
                : Digits.of(median, 2) + " (" + Digits.of(low, 2) + " to " + Digits.of(high, 2) + ")";
    }

    private void pictures() throws IOException {
        if (result.equalTime().isEmpty()) {
            return;
        }
        html.element("h2", "The same time, side by side");
        html.raw("<div class=\"side\">\n");
        for (EqualTime e : result.equalTime()) {
            html.raw("<div>\n");
            String what = e.run().method() + ", " + Digits.samples(e.run().samples()) + " samples, "
                    + Digits.of(e.run().wallSeconds(), 2) + " s: error "
                    + Digits.of(e.run().error(result.reference().variance()), 3) + ", FLIP "
                    + Digits.of(e.run().flip(), 3);
            html.picture(e.image(), context.title() + " by " + e.run().method(), what);
            html.picture(
                    e.difference(),
                    "where it differs from the reference",
                    "where it differs from the reference: black not at all; all differences times " + e.gain());
            html.raw("</div>\n");
        }
        html.raw("</div>\n");
        html.picture(result.reference().image(), context.title() + ", reference", "the reference");
    }

    private void sweeps(List<Chart> charts) throws IOException {
        for (SweepResult sweep : result.sweeps()) {
            html.element("h2", sweep.sweep().name() + ": what one notch costs and buys");
            html.element("p", "All else as the scene has it, method " + sweep.method() + ".");
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
                        Digits.of(p.error().median(), 3),
                        before == null
                                ? ""
                                : change(p.wall().median(), before.wall().median()),
                        before == null
                                ? ""
                                : change(p.error().median(), before.error().median())));
                before = p;
            }
            html.table(
                    List.of(sweep.sweep().name(), "seconds", "CPU seconds", "error", "time changed", "error changed"),
                    rows);
            int missing = sweep.sweep().values().size() - sweep.points().size();
            if (missing > 0) {
                html.element("p class=\"warning\"", "There was no time for the last " + missing + " notches.");
            }
        }
    }

    private static String change(double now, double before) {
        return before == 0 ? "" : String.format(Locale.ROOT, "%+.0f %%", PERCENT * (now / before - 1));
    }

    private void ladder() {
        html.element("h2", "All budgets");
        List<List<String>> rows = new ArrayList<>();
        for (Curve curve : result.curves()) {
            for (Curve.Point p : curve.points()) {
                rows.add(List.of(
                        curve.method(),
                        Digits.samples(p.samples()),
                        Digits.of(p.samplesPerPixel(), 3),
                        Integer.toString(p.wall().count()),
                        spread(p.wall().low(), p.wall().median(), p.wall().high()),
                        Digits.of(p.cpu().median(), 2),
                        p.judged() ? Digits.of(p.error().median(), 3) : "too near the reference",
                        Digits.of(p.flip().median(), 3),
                        Digits.of(p.estimated().median(), 3)));
            }
        }
        html.table(
                List.of(
                        "method",
                        "--samples",
                        "rays per pixel",
                        "runs",
                        "seconds",
                        "CPU seconds",
                        "error",
                        "FLIP",
                        "error it expected"),
                rows);
        for (Curve curve : result.curves()) {
            if (curve.judged() > 0) {
                html.element(
                        "p",
                        curve.method() + ": in " + curve.insideOwnInterval() + " of " + curve.judged()
                                + " runs the error lay inside the interval that the render gave for it (95 of 100 "
                                + "would be right).");
            }
        }
    }

    private void howMeasured() {
        html.element("h2", "How this was measured");
        Reference r = result.reference();
        StringBuilder parts = new StringBuilder();
        for (Reference.Part part : r.parts()) {
            parts.append(parts.isEmpty() ? "" : " and ").append(part.method()).append(" with ");
            parts.append(Digits.samples(part.samples())).append(" samples per pixel");
        }
        html.element(
                "p",
                (r.parts().isEmpty()
                                ? "The reference was given. Its own error, seen by two independent renders, is "
                                : "The reference is the mean of two independent renders: " + parts
                                        + ". Its own error, from the difference of the two, is ")
                        + Digits.of(r.error(), 2)
                        + ". It has been taken off the errors above (as squares). "
                        + "Runs that differ from it by little more than that are left out.");
        html.element(
                "p",
                "Java was warmed up first. The methods took turns, render by render, so that a busy machine disturbs "
                        + "both alike; times are medians, with the smallest and the largest. They count from the scene in "
                        + "memory to the finished picture, without reading and writing files. Every render of the ladder has "
                        + "random numbers of its own.");
        List<List<String>> rows = new ArrayList<>();
        context.machine().forEach((k, v) -> rows.add(List.of(k, v)));
        rows.add(List.of("command", context.tradeCommand()));
        rows.add(List.of(
                "this took",
                Digits.of(result.seconds(), 3) + " s, " + result.runs().size() + " runs"));
        html.table(List.of("what", "value"), rows);
    }
}
