package enlightenment.measure.page;

import enlightenment.measure.Contender;
import enlightenment.measure.Curve;
import enlightenment.measure.Digits;
import enlightenment.measure.EqualTime;
import enlightenment.measure.Meeting;
import enlightenment.measure.Need;
import enlightenment.measure.Reach;
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
        if (!result.circumstances().complete()) {
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
            html.element("pre", context.render(best, result.settings()));
            if (best.source() == Need.Source.TRIED) {
                html.element(
                        "p",
                        "This was tried: the picture that this command makes has an error of "
                                + (best.error() > result.reference().error() ? "" : "at most ")
                                + Digits.of(best.error(), 3)
                                + ". It makes the same picture for you, to the last bit. The time is by the clock on this machine once Java has warmed up; as the first "
                                + "render of a process it took "
                                + Digits.of(Math.max(result.circumstances().coldSeconds(), 0.01), 2)
                                + " s longer. To check it:");
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
        for (double target : TradeResult.TARGETS) {
            for (Reach reach : result.reaches()) {
                if (result.isKnown(target)) {
                    reach.forError(target).ifPresent(n -> rows.add(row(n)));
                }
            }
        }
        html.table(
                List.of("error", "by", "options", "error it gives", "FLIP", "seconds", "CPU seconds", "known because"),
                rows);
        html.element(
                "p",
                "An error that is missing here was not measured, or is smaller than the reference's own, "
                        + Digits.of(result.reference().error(), 2) + ": below that, nothing is said.");
        meetings();
    }

    private List<String> row(Need n) {
        return List.of(
                Digits.samples(PERCENT * n.target()) + " %",
                n.contender().name(),
                Verdict.arguments(n, result.settings()),
                Digits.of(n.error(), 3),
                n.flip().map(f -> Digits.of(f, 2)).orElse("–"),
                spread(n.wall().low(), n.wall().median(), n.wall().high()),
                n.cpu().map(c -> Digits.of(c.median(), 2)).orElse("–"),
                n.evidence()
                        + (n.source() == Need.Source.TRIED
                                ? ", " + runs(n.wall().count())
                                : ""));
    }

    private static String runs(int count) {
        return count + (count == 1 ? " run" : " runs");
    }

    /** How many times faster: only where both were measured. */
    private void meetings() {
        List<List<String>> rows = new ArrayList<>();
        for (Meeting m : Meeting.all(result)) {
            rows.add(List.of(
                    Digits.of(m.error(), 2) + (m.smallest() ? ", the smallest that both reached" : ""),
                    side(m.first()),
                    side(m.second()),
                    Digits.of(m.ratio(), 2)));
        }
        if (!rows.isEmpty()) {
            html.element("h2", "Where both methods were measured");
            html.table(List.of("error", "first", "second", "times as long (first by second)"), rows);
        }
    }

    private static String side(Need n) {
        return n.contender().name() + ": " + Digits.of(n.wall().median(), 2) + " s"
                + n.flip().map(f -> ", FLIP " + Digits.of(f, 2)).orElse("") + " (" + n.evidence() + ")";
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
        html.element(
                "h2",
                EqualTime.areEqual(result.equalTime())
                        ? "The same time, side by side"
                        : "Side by side, in different times");
        double variance = result.reference().variance();
        EqualTime.sentence(result.equalTime(), variance).ifPresent(s -> html.element("p", s));
        html.raw("<div class=\"side\">\n");
        for (EqualTime e : result.equalTime()) {
            html.raw("<div>\n");
            String name = Contender.of(e.run()).name();
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
                        "where it differs from the reference",
                        "where it differs from the reference: black not at all; all differences times " + e.gain());
            }
            html.raw("</div>\n");
        }
        html.raw("</div>\n");
        if (result.reference().picture().isPresent()) {
            html.picture(result.reference().image(), context.title() + ", reference", "the reference");
        }
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
                        curve.contender().name(),
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
                        "error it expected"),
                rows);
        for (Curve curve : result.curves()) {
            if (curve.judged() > 0) {
                html.element(
                        "p",
                        curve.contender().name() + ": in " + curve.insideOwnInterval() + " of " + curve.judged()
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
            parts.append(parts.isEmpty() ? "" : " and ");
            parts.append(new Contender(part.method(), part.lightPoints(), false).name())
                    .append(", ");
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
                        + "Runs whose error is smaller than that are left out: what it is cannot be told.");
        html.element(
                "p",
                "Java was warmed up first. The methods took turns, render by render, so that a busy machine disturbs "
                        + "both alike; times are medians, with the smallest and the largest. They count from the scene in "
                        + "memory to the finished picture, without reading and writing files. Every render of the ladder has "
                        + "random numbers of its own.");
        List<List<String>> rows = new ArrayList<>();
        result.circumstances().machine().forEach((k, v) -> rows.add(List.of(k, v)));
        rows.add(List.of("command", context.tradeCommand()));
        rows.add(List.of(
                "this took",
                Digits.of(result.circumstances().seconds(), 3) + " s, "
                        + result.runs().size() + " runs"));
        html.table(List.of("what", "value"), rows);
    }
}
