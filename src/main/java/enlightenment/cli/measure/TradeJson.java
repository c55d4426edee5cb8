package enlightenment.cli.measure;

import enlightenment.cli.picture.ReportJson;
import enlightenment.cli.terminal.Version;
import enlightenment.json.JsonText;
import enlightenment.measure.analysis.Configuration;
import enlightenment.measure.analysis.CostEstimate;
import enlightenment.measure.analysis.Curve;
import enlightenment.measure.analysis.EqualErrorComparison;
import enlightenment.measure.analysis.EqualTimeComparison;
import enlightenment.measure.analysis.EqualTimePicture;
import enlightenment.measure.analysis.MethodChoice;
import enlightenment.measure.analysis.PowerLaw;
import enlightenment.measure.analysis.SweepResult;
import enlightenment.measure.analysis.TradeAnalysis;
import enlightenment.measure.analysis.Verdict;
import enlightenment.measure.trade.Reference;
import enlightenment.measure.trade.TradeResult;
import enlightenment.scene.BuiltInMethod;
import enlightenment.scene.RenderSettings;
import java.util.Locale;
import java.util.Optional;
import tools.jackson.core.JsonGenerator;

/** A trade as JSON; docs/notes/trade.md lists the keys. The single runs are in {@code trade.csv}. */
final class TradeJson {
    private TradeJson() {}

    static String of(TradeAnalysis result, EqualTimeComparison equalTime) {
        return JsonText.of(json -> trade(json, result, equalTime));
    }

    private static void trade(JsonGenerator json, TradeAnalysis result, EqualTimeComparison equalTime) {
        TradeResult.Conditions c = result.result().conditions();
        json.writeStartObject();
        json.writeStringProperty("enlightenment", Version.number());
        BenchJson.machine(json, c.machine());
        json.writeBooleanProperty("complete", c.complete());
        json.writeNumberProperty("seconds", c.seconds());
        json.writeNumberProperty("coldStartSeconds", c.coldSeconds());
        json.writeNumberProperty("shareOfProcessors", result.shareOfProcessors());
        settings(json, result);
        reference(json, result.result().reference());
        choice(json, MethodChoice.of(result));
        json.writeArrayPropertyStart("verdicts");
        Verdict.all(result).forEach(v -> verdict(json, v, result));
        json.writeEndArray();
        json.writeArrayPropertyStart("meetings");
        EqualErrorComparison.all(result).forEach(m -> meeting(json, m));
        json.writeEndArray();
        json.writeArrayPropertyStart("needs");
        for (double target : TradeResult.TARGETS) {
            if (result.isKnown(target)) {
                result.costs().forEach(r -> r.forError(target).ifPresent(n -> cost(json, n)));
            }
        }
        json.writeEndArray();
        json.writeArrayPropertyStart("curves");
        result.curves().forEach(x -> curve(json, x));
        json.writeEndArray();
        equalTime(json, equalTime);
        json.writeArrayPropertyStart("sweeps");
        result.sweeps().forEach(s -> sweep(json, s));
        json.writeEndArray();
        json.writeEndObject();
    }

    private static void verdict(JsonGenerator json, Verdict v, TradeAnalysis result) {
        json.writeStartObject();
        json.writeNumberProperty("error", v.target());
        json.writeStringProperty("known", word(v.known()));
        json.writeStringProperty("sentence", v.sentence());
        v.best().ifPresent(b -> {
            json.writeStringProperty("arguments", Verdict.arguments(b, result.settings()));
            cost(json, "need", b);
        });
        json.writeArrayPropertyStart("comparisons");
        for (Verdict.Comparison c : v.comparisons()) {
            json.writeStartObject();
            json.writeNumberProperty("timesAsLong", c.ratio());
            json.writeBooleanProperty("alike", c.alike());
            cost(json, "need", c.cost());
            json.writeEndObject();
        }
        json.writeEndArray();
        json.writeEndObject();
    }

    private static void meeting(JsonGenerator json, EqualErrorComparison m) {
        json.writeStartObject();
        json.writeNumberProperty("error", m.error());
        json.writeBooleanProperty("smallest", m.smallest());
        json.writeStringProperty("lightPoints", m.best() ? "best" : "scene");
        json.writeArrayPropertyStart("methods");
        for (CostEstimate n : m.costs()) {
            json.writeStartObject();
            json.writeNumberProperty("timesAsLong", m.timesAsLong(n));
            cost(json, "need", n);
            json.writeEndObject();
        }
        json.writeEndArray();
        json.writeEndObject();
    }

    private static void choice(JsonGenerator json, MethodChoice choice) {
        json.writeObjectPropertyStart("choice");
        choice.sentence().ifPresent(s -> json.writeStringProperty("sentence", s));
        json.writeArrayPropertyStart("leftOut");
        choice.leftOut().forEach(json::writeString);
        json.writeEndArray();
        json.writeArrayPropertyStart("ranges");
        for (MethodChoice.Range range : choice.ranges()) {
            json.writeStartObject();
            json.writeNumberProperty("largest", range.largest());
            json.writeNumberProperty("smallest", range.smallest());
            json.writeArrayPropertyStart("methods");
            range.methods().forEach(json::writeString);
            json.writeEndArray();
            range.alone().ifPresent(e -> json.writeNumberProperty("alone", e));
            json.writeArrayPropertyStart("rivals");
            for (MethodChoice.Rival rival : range.rivals()) {
                json.writeStartObject();
                json.writeNumberProperty("timesAsLong", rival.ratio());
                cost(json, "need", rival.cost());
                json.writeEndObject();
            }
            json.writeEndArray();
            json.writeEndObject();
        }
        json.writeEndArray();
        json.writeEndObject();
    }

    private static void equalTime(JsonGenerator json, EqualTimeComparison comparison) {
        double variance = comparison.referenceVariance();
        json.writeBooleanProperty("equal", comparison.isEqual());
        comparison.sentence().ifPresent(s -> json.writeStringProperty("equalTimeSentence", s));
        json.writeArrayPropertyStart("equalTime");
        for (EqualTimePicture e : comparison.pictures()) {
            json.writeStartObject();
            json.writeStringProperty("method", e.run().method());
            json.writeNumberProperty("lightPoints", e.run().shadowSamples());
            json.writeNumberProperty("samples", e.run().samples());
            json.writeNumberProperty("wallSeconds", e.run().wallSeconds());
            json.writeNumberProperty("error", e.run().error(variance));
            json.writeNumberProperty("flip", e.run().flip());
            json.writeEndObject();
        }
        json.writeEndArray();
    }

    private static String word(Enum<?> value) {
        return value.name().toLowerCase(Locale.ROOT);
    }

    private static void settings(JsonGenerator json, TradeAnalysis result) {
        RenderSettings s = result.settings().base();
        json.writeObjectPropertyStart("settings");
        json.writeArrayPropertyStart("methods");
        result.settings().methods().forEach(json::writeString);
        json.writeEndArray();
        json.writeNumberProperty("budgetSeconds", result.settings().budgetSeconds());
        json.writeNumberProperty("seeds", result.settings().seeds());
        json.writeNumberProperty("width", s.region().width());
        json.writeNumberProperty("height", s.region().height());
        json.writeNumberProperty("antialias", s.antialias());
        json.writeNumberProperty(
                "shadowSamples", BuiltInMethod.RayTraceSettings.of(s).shadowSamples());
        ReportJson.common(json, s);
        json.writeNumberProperty("threads", s.threads());
        json.writeEndObject();
    }

    private static void reference(JsonGenerator json, Reference reference) {
        json.writeObjectPropertyStart("reference");
        json.writeNumberProperty("error", reference.error());
        json.writeArrayPropertyStart("parts");
        for (Reference.Part part : reference.parts()) {
            json.writeStartObject();
            json.writeStringProperty("method", part.method());
            json.writeNumberProperty("lightPoints", part.lightSamples());
            json.writeNumberProperty("samples", part.samples());
            json.writeNumberProperty("seed", part.seed());
            json.writeEndObject();
        }
        json.writeEndArray();
        json.writeEndObject();
    }

    private static void cost(JsonGenerator json, String key, CostEstimate n) {
        json.writeName(key);
        cost(json, n);
    }

    private static void cost(JsonGenerator json, CostEstimate n) {
        json.writeStartObject();
        json.writeNumberProperty("error", n.target());
        configuration(json, n.configuration());
        json.writeNumberProperty("samples", n.samples());
        json.writeNumberProperty("errorItGives", n.error());
        n.flip().ifPresent(f -> json.writeNumberProperty("flip", f));
        BenchJson.spread(json, "wallSeconds", n.wall());
        n.cpu().ifPresent(c -> BenchJson.spread(json, "cpuSeconds", c));
        json.writeStringProperty("source", word(n.source()));
        json.writeArrayPropertyStart("from");
        n.from().forEach(json::writeNumber);
        json.writeEndArray();
        json.writeEndObject();
    }

    private static void configuration(JsonGenerator json, Configuration c) {
        json.writeStringProperty("method", c.method());
        json.writeNumberProperty("lightPoints", c.lightSamples());
        json.writeBooleanProperty("grid", c.grid());
    }

    private static void curve(JsonGenerator json, Curve curve) {
        json.writeStartObject();
        configuration(json, curve.configuration());
        fit(json, "overSamples", curve.overSamples());
        fit(json, "overTime", curve.overTime());
        json.writeNumberProperty("insideOwnInterval", curve.insideOwnInterval());
        json.writeNumberProperty("judgedRuns", curve.judged());
        json.writeArrayPropertyStart("points");
        for (Curve.Point p : curve.points()) {
            json.writeStartObject();
            json.writeNumberProperty("samples", p.samples());
            json.writeNumberProperty("samplesPerPixel", p.samplesPerPixel());
            json.writeBooleanProperty("judged", p.judged());
            BenchJson.spread(json, "wallSeconds", p.wall());
            BenchJson.spread(json, "cpuSeconds", p.cpu());
            BenchJson.spread(json, "error", p.error());
            BenchJson.spread(json, "flip", p.flip());
            BenchJson.spread(json, "estimatedError", p.estimated());
            json.writeEndObject();
        }
        json.writeEndArray();
        json.writeEndObject();
    }

    private static void fit(JsonGenerator json, String key, Optional<PowerLaw> fit) {
        fit.ifPresent(f -> {
            json.writeObjectPropertyStart(key);
            json.writeNumberProperty("slope", f.slope());
            json.writeNumberProperty("slopeLow", f.slopeLow());
            json.writeNumberProperty("slopeHigh", f.slopeHigh());
            json.writeNumberProperty("factor", f.factor());
            json.writeEndObject();
        });
    }

    private static void sweep(JsonGenerator json, SweepResult sweep) {
        json.writeStartObject();
        json.writeStringProperty("name", sweep.sweep().name());
        json.writeStringProperty("method", sweep.method());
        json.writeArrayPropertyStart("points");
        for (SweepResult.Point p : sweep.points()) {
            json.writeStartObject();
            json.writeNumberProperty("value", p.value());
            json.writeBooleanProperty("judged", p.judged());
            BenchJson.spread(json, "wallSeconds", p.wall());
            BenchJson.spread(json, "cpuSeconds", p.cpu());
            BenchJson.spread(json, "error", p.error());
            json.writeEndObject();
        }
        json.writeEndArray();
        json.writeEndObject();
    }
}
