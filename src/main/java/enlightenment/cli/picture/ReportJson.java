package enlightenment.cli.picture;

import enlightenment.cli.terminal.Version;
import enlightenment.json.JsonText;
import enlightenment.net.RenderServer;
import enlightenment.render.RenderResult;
import enlightenment.report.RenderReport;
import enlightenment.scene.BuiltInMethod;
import enlightenment.scene.ChosenSettings;
import enlightenment.scene.Method;
import enlightenment.scene.RenderSettings;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import tools.jackson.core.JsonGenerator;

/** A render's report as JSON; docs/guide/cli.md lists the keys. */
public final class ReportJson {
    private ReportJson() {}

    /**
     * The report of a render.
     *
     * @param reason why the program chose its method; empty if the settings named it
     * @param audits those of a server; empty for others
     */
    static String of(RenderResult result, Optional<String> reason, Optional<RenderServer.AuditReport> audits) {
        return JsonText.of(json -> {
            json.writeStartObject();
            program(json);
            content(json, result.report(), result.complete());
            reason.ifPresent(why -> json.writeStringProperty("methodReason", why));
            audits.ifPresent(a -> audits(json, a));
            json.writeEndObject();
        });
    }

    /** The audits of what a server made, in an object that is begun. */
    public static void audits(JsonGenerator json, RenderServer.AuditReport audits) {
        json.writeObjectPropertyStart("audits");
        json.writeNumberProperty("due", audits.due());
        json.writeNumberProperty("missing", audits.missing());
        json.writeArrayPropertyStart(audits.isOfFilm() ? "frames" : "tiles");
        audits.where().forEach(json::writeNumber);
        json.writeEndArray();
        json.writeEndObject();
    }

    /** Writes the versions of program and Java. */
    public static void program(JsonGenerator json) {
        json.writeStringProperty("enlightenment", Version.number());
        json.writeStringProperty("java", Runtime.version().toString());
    }

    /** Writes a report into an object that is begun. */
    public static void content(JsonGenerator json, RenderReport report, boolean complete) {
        json.writeStringProperty("scene", report.sceneName());
        json.writeBooleanProperty("complete", complete);
        settings(json, report.settings());
        json.writeArrayPropertyStart("features");
        report.features().forEach(json::writeString);
        json.writeEndArray();
        counts(json, "rays", report.raysByKind());
        json.writeNumberProperty("lightSamples", report.lightSamples());
        json.writeNumberProperty("lightSamplesWithoutRay", report.lightSamplesWithoutRay());
        sampling(json, report);
        counts(json, "tests", report.testsByPrimitive());
        counts(json, "hits", report.hitsByPrimitive());
        json.writeNumberProperty("textureLookups", report.textureLookups());
        phases(json, report);
        json.writeNumberProperty("raysPerSecond", report.raysPerSecond());
        json.writeNumberProperty("pixels", report.pixels());
        json.writeNumberProperty("peakMemoryBytes", report.peakMemoryBytes());
    }

    private static void settings(JsonGenerator json, RenderSettings s) {
        json.writeObjectPropertyStart("settings");
        json.writeStringProperty("method", s.method().word());
        json.writeNumberProperty("width", s.width());
        json.writeNumberProperty("height", s.height());
        if (s.crop().isPresent()) {
            RenderSettings.Crop c = s.crop().get();
            json.writeName("crop");
            json.writeArray(new int[] {c.x(), c.y(), c.width(), c.height()}, 0, 4);
        }
        json.writeNumberProperty("antialias", s.antialias());
        numbers(json, s);
        common(json, s);
        s.budget().samples().ifPresent(n -> json.writeNumberProperty("samples", n));
        s.budget().error().ifPresent(e -> json.writeNumberProperty("error", e));
        s.budget().seconds().ifPresent(t -> json.writeNumberProperty("time", t));
        words(json, s);
        json.writeNumberProperty("threads", s.threads());
        json.writeEndObject();
    }

    /** The settings that all methods have. */
    public static void common(JsonGenerator json, RenderSettings s) {
        numbers(json, s, ChosenSettings.Common.ALL);
        words(json, s, ChosenSettings.Common.ALL);
    }

    /** The whole numbers among the settings that have an influence with the method in use. */
    public static void numbers(JsonGenerator json, RenderSettings s) {
        numbers(json, s, Method.influences(s.method()));
    }

    private static void numbers(JsonGenerator json, RenderSettings s, List<Method.Setting> settings) {
        for (Method.Setting setting : settings) {
            if (setting instanceof Method.Setting.Whole whole) {
                json.writeNumberProperty(whole.key(), whole.checked(s.chosen().value(whole)));
            }
        }
    }

    /** The words among them. */
    public static void words(JsonGenerator json, RenderSettings s) {
        words(json, s, Method.influences(s.method()));
    }

    private static void words(JsonGenerator json, RenderSettings s, List<Method.Setting> settings) {
        for (Method.Setting setting : settings) {
            if (setting instanceof Method.Setting.Word word) {
                json.writeStringProperty(word.key(), s.chosen().word(word));
            }
        }
    }

    private static void sampling(JsonGenerator json, RenderReport report) {
        RenderReport.Sampling s = report.sampling();
        json.writeObjectPropertyStart("sampling");
        json.writeStringProperty("method", s.method().word());
        json.writeStringProperty("decidedBy", report.decidedBy());
        json.writeNumberProperty("plannedSamples", s.plannedSamples());
        json.writeNumberProperty("samplesPerPixel", s.samplesPerPixel());
        json.writeNumberProperty("estimatedError", s.estimatedError());
        json.writeArrayPropertyStart("errorInterval");
        json.writeNumber(s.errorLow());
        json.writeNumber(s.errorHigh());
        json.writeEndArray();
        s.light().ifPresent(light -> light(json, light));
        if (report.settings().budget().error().isPresent()) {
            json.writeNumberProperty("rounding", s.rounding());
            json.writeNumberProperty("rounds", s.rounds());
            json.writeBooleanProperty("errorMet", report.isErrorMet());
        }
        boolean areChains = s.method() == Method.METROPOLIS;
        if (areChains) {
            json.writeNumberProperty("blocks", BuiltInMethod.MetropolisSettings.blocks(report.settings()));
        }
        json.writeNumberProperty(areChains ? "chains" : "clusters", s.clusters());
        json.writeNumberProperty("proposals", s.proposals());
        json.writeNumberProperty("accepted", s.accepted());
        json.writeEndObject();
    }

    private static void light(JsonGenerator json, RenderReport.Light light) {
        // JSON has no NaN: what is not known is left out.
        if (Double.isFinite(light.relativeError())) {
            json.writeNumberProperty("relativeError", light.relativeError());
        }
        if (Double.isFinite(light.kurtosis())) {
            json.writeNumberProperty("kurtosis", light.kurtosis());
        }
        json.writeBooleanProperty("heavyTail", light.heavyTail());
        json.writeNumberProperty("lostSamples", light.lostSamples());
        json.writeArrayPropertyStart("undersampled");
        for (String transport : light.undersampled()) {
            json.writeString(transport);
        }
        json.writeEndArray();
    }

    private static void phases(JsonGenerator json, RenderReport report) {
        json.writeArrayPropertyStart("phases");
        for (RenderReport.Phase phase : report.phases()) {
            json.writeStartObject();
            json.writeStringProperty("name", phase.name());
            json.writeNumberProperty("wallSeconds", phase.wallSeconds());
            json.writeNumberProperty("cpuSeconds", phase.cpuSeconds());
            json.writeEndObject();
        }
        json.writeEndArray();
    }

    private static void counts(JsonGenerator json, String key, Map<String, Long> counts) {
        json.writeObjectPropertyStart(key);
        counts.forEach(json::writeNumberProperty);
        json.writeEndObject();
    }
}
