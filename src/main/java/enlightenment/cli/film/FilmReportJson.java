package enlightenment.cli.film;

import enlightenment.cli.picture.ReportJson;
import enlightenment.json.JsonText;
import enlightenment.net.RenderServer;
import enlightenment.report.RenderReport;
import java.util.Map;
import java.util.Optional;

/** The report of a film as JSON; docs/guide/cli.md lists the keys. */
final class FilmReportJson {
    private FilmReportJson() {}

    /**
     * The text.
     *
     * @param asked how many frames were wanted
     * @param kept how many of them were there already
     * @param frames the reports of those that were rendered, by their numbers
     * @param audits those of a server; empty for others
     * @param seconds by the clock
     * @param processors seconds of processors that this process has taken
     */
    static String of(
            int asked,
            int kept,
            Map<Integer, RenderReport> frames,
            Optional<RenderServer.AuditReport> audits,
            double seconds,
            double processors) {
        return JsonText.of(json -> {
            json.writeStartObject();
            ReportJson.program(json);
            json.writeNumberProperty("framesAsked", asked);
            json.writeNumberProperty("framesKept", kept);
            json.writeNumberProperty("framesRendered", frames.size());
            json.writeBooleanProperty("complete", kept + frames.size() == asked);
            json.writeNumberProperty("wallSeconds", seconds);
            json.writeNumberProperty("cpuSeconds", processors);
            json.writeNumberProperty("rays", FilmReport.rays(frames));
            json.writeNumberProperty("pixels", FilmReport.pixels(frames));
            audits.ifPresent(a -> ReportJson.audits(json, a));
            json.writeArrayPropertyStart("frames");
            frames.forEach((frame, report) -> {
                json.writeStartObject();
                json.writeNumberProperty("frame", frame);
                ReportJson.content(json, report, true);
                json.writeEndObject();
            });
            json.writeEndArray();
            json.writeEndObject();
        });
    }
}
