package enlightenment.cli;

import enlightenment.render.RenderReport;
import enlightenment.render.RenderResult;
import enlightenment.scene.Method;
import enlightenment.scene.RenderSettings;
import java.util.Map;

/** A render's report as JSON. */
final class ReportJson {
    private ReportJson() {}

    /** The whole text; docs/cli.md lists its keys. */
    static String of(RenderResult result) {
        RenderReport report = result.report();
        JsonText json = new JsonText().beginObject();
        json.key("enlightenment").value(Version.number());
        json.key("java").value(Runtime.version().toString());
        json.key("scene").value(report.sceneName());
        json.key("complete").value(result.complete());
        settings(json.key("settings"), report.settings());
        json.key("features").beginArray();
        for (String feature : report.features()) {
            json.value(feature);
        }
        json.endArray();
        counts(json.key("rays"), report.raysByKind());
        json.key("lightSamples").value(report.lightSamples());
        json.key("lightSamplesWithoutRay").value(report.lightSamplesWithoutRay());
        sampling(json.key("sampling"), report);
        counts(json.key("tests"), report.testsByPrimitive());
        counts(json.key("hits"), report.hitsByPrimitive());
        json.key("textureLookups").value(report.textureLookups());
        json.key("phases").beginArray();
        for (RenderReport.Phase phase : report.phases()) {
            json.beginObject();
            json.key("name").value(phase.name());
            json.key("wallSeconds").value(phase.wallSeconds());
            json.key("cpuSeconds").value(phase.cpuSeconds());
            json.endObject();
        }
        json.endArray();
        json.key("raysPerSecond").value(report.raysPerSecond());
        json.key("pixels").value(report.pixels());
        json.key("peakMemoryBytes").value(report.peakMemoryBytes());
        return json.endObject().finish();
    }

    private static void settings(JsonText json, RenderSettings s) {
        json.beginObject();
        json.key("method").value(s.method().word());
        json.key("width").value(s.width());
        json.key("height").value(s.height());
        if (s.crop().isPresent()) {
            RenderSettings.Crop c = s.crop().get();
            json.key("crop").beginArray();
            json.value(c.x()).value(c.y()).value(c.width()).value(c.height());
            json.endArray();
        }
        json.key("antialias").value(s.antialias());
        json.key("shadowSamples").value(s.shadowSamples());
        json.key("seed").value(s.seed());
        if (s.budget().samples().isPresent()) {
            json.key("samples").value(s.budget().samples().getAsDouble());
        }
        if (s.budget().error().isPresent()) {
            json.key("error").value(s.budget().error().getAsDouble());
        }
        if (s.budget().seconds().isPresent()) {
            json.key("time").value(s.budget().seconds().getAsDouble());
        }
        if (s.method().has(Method.Setting.PROPOSAL)) {
            json.key("proposal").value(s.proposal());
        }
        json.key("threads").value(s.threads());
        json.endObject();
    }

    private static void sampling(JsonText json, RenderReport report) {
        RenderReport.Sampling s = report.sampling();
        json.beginObject();
        json.key("method").value(s.method().word());
        json.key("decidedBy").value(s.decidedBy());
        json.key("plannedSamples").value(s.plannedSamples());
        json.key("samplesPerPixel").value(s.samplesPerPixel());
        json.key("estimatedError").value(s.estimatedError());
        json.key("errorInterval")
                .beginArray()
                .value(s.errorLow())
                .value(s.errorHigh())
                .endArray();
        if (report.settings().budget().error().isPresent()) {
            json.key("rounding").value(s.rounding());
            json.key("rounds").value(s.rounds());
            json.key("errorMet").value(report.isErrorMet());
        }
        json.key("clusters").value(s.clusters());
        json.key("proposals").value(s.proposals());
        json.key("accepted").value(s.accepted());
        json.endObject();
    }

    private static void counts(JsonText json, Map<String, Long> counts) {
        json.beginObject();
        for (Map.Entry<String, Long> e : counts.entrySet()) {
            json.key(e.getKey()).value(e.getValue());
        }
        json.endObject();
    }
}
