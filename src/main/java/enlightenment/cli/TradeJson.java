package enlightenment.cli;

import enlightenment.json.JsonText;
import enlightenment.measure.Circumstances;
import enlightenment.measure.Contender;
import enlightenment.measure.Curve;
import enlightenment.measure.EqualTime;
import enlightenment.measure.Meeting;
import enlightenment.measure.Need;
import enlightenment.measure.PowerLaw;
import enlightenment.measure.Reference;
import enlightenment.measure.SweepResult;
import enlightenment.measure.TradeResult;
import enlightenment.measure.Verdict;
import enlightenment.scene.RenderSettings;
import java.util.Locale;
import java.util.Optional;
import tools.jackson.core.JsonGenerator;

/** A trade as JSON; docs/trade.md lists the keys. The single runs are in {@code trade.csv}. */
final class TradeJson {
    private TradeJson() {}

    static String of(TradeResult result) {
        return JsonText.of(json -> trade(json, result));
    }

    private static void trade(JsonGenerator json, TradeResult result) {
        Circumstances c = result.circumstances();
        json.writeStartObject();
        json.writeStringProperty("enlightenment", Version.number());
        BenchJson.machine(json, c.machine());
        json.writeBooleanProperty("complete", c.complete());
        json.writeNumberProperty("seconds", c.seconds());
        json.writeNumberProperty("coldStartSeconds", c.coldSeconds());
        json.writeNumberProperty("shareOfProcessors", result.shareOfProcessors());
        settings(json, result);
        reference(json, result.reference());
        json.writeArrayPropertyStart("verdicts");
        Verdict.all(result).forEach(v -> verdict(json, v, result));
        json.writeEndArray();
        json.writeArrayPropertyStart("meetings");
        Meeting.all(result).forEach(m -> meeting(json, m));
        json.writeEndArray();
        json.writeArrayPropertyStart("needs");
        for (double target : TradeResult.TARGETS) {
            if (result.isKnown(target)) {
                result.reaches().forEach(r -> r.forError(target).ifPresent(n -> need(json, n)));
            }
        }
        json.writeEndArray();
        json.writeArrayPropertyStart("curves");
        result.curves().forEach(x -> curve(json, x));
        json.writeEndArray();
        equalTime(json, result);
        json.writeArrayPropertyStart("sweeps");
        result.sweeps().forEach(s -> sweep(json, s));
        json.writeEndArray();
        json.writeEndObject();
    }

    private static void verdict(JsonGenerator json, Verdict v, TradeResult result) {
        json.writeStartObject();
        json.writeNumberProperty("error", v.target());
        json.writeStringProperty("known", word(v.known()));
        json.writeStringProperty("sentence", v.sentence());
        v.best().ifPresent(b -> {
            json.writeStringProperty("arguments", Verdict.arguments(b, result.settings()));
            need(json, "need", b);
        });
        json.writeArrayPropertyStart("comparisons");
        for (Verdict.Comparison c : v.comparisons()) {
            json.writeStartObject();
            json.writeNumberProperty("timesAsLong", c.ratio());
            json.writeBooleanProperty("alike", c.alike());
            need(json, "need", c.need());
            json.writeEndObject();
        }
        json.writeEndArray();
        json.writeEndObject();
    }

    private static void meeting(JsonGenerator json, Meeting m) {
        json.writeStartObject();
        json.writeNumberProperty("error", m.error());
        json.writeBooleanProperty("smallest", m.smallest());
        json.writeStringProperty("lightPoints", m.best() ? "best" : "scene");
        json.writeNumberProperty("timesAsLong", m.ratio());
        need(json, "first", m.first());
        need(json, "second", m.second());
        json.writeEndObject();
    }

    private static void equalTime(JsonGenerator json, TradeResult result) {
        double variance = result.reference().variance();
        json.writeBooleanProperty("equal", EqualTime.areEqual(result.equalTime()));
        EqualTime.sentence(result.equalTime(), variance)
                .ifPresent(s -> json.writeStringProperty("equalTimeSentence", s));
        json.writeArrayPropertyStart("equalTime");
        for (EqualTime e : result.equalTime()) {
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

    private static void settings(JsonGenerator json, TradeResult result) {
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
        json.writeNumberProperty("shadowSamples", s.shadowSamples());
        json.writeNumberProperty("seed", s.seed());
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
            json.writeNumberProperty("lightPoints", part.lightPoints());
            json.writeNumberProperty("samples", part.samples());
            json.writeNumberProperty("seed", part.seed());
            json.writeEndObject();
        }
        json.writeEndArray();
        json.writeEndObject();
    }

    private static void need(JsonGenerator json, String key, Need n) {
        json.writeName(key);
        need(json, n);
    }

    private static void need(JsonGenerator json, Need n) {
        json.writeStartObject();
        json.writeNumberProperty("error", n.target());
        contender(json, n.contender());
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

    private static void contender(JsonGenerator json, Contender c) {
        json.writeStringProperty("method", c.method());
        json.writeNumberProperty("lightPoints", c.lightPoints());
        json.writeBooleanProperty("grid", c.grid());
    }

    private static void curve(JsonGenerator json, Curve curve) {
        json.writeStartObject();
        contender(json, curve.contender());
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
