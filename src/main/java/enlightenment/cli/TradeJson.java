package enlightenment.cli;

import enlightenment.measure.analysis.Configuration;
import enlightenment.measure.analysis.CostEstimate;
import enlightenment.measure.analysis.Curve;
import enlightenment.measure.analysis.EqualErrorComparison;
import enlightenment.measure.analysis.EqualTimeComparison;
import enlightenment.measure.analysis.EqualTimePicture;
import enlightenment.measure.analysis.PowerLaw;
import enlightenment.measure.analysis.SweepResult;
import enlightenment.measure.analysis.TradeAnalysis;
import enlightenment.measure.analysis.Verdict;
import enlightenment.measure.trade.Reference;
import enlightenment.measure.trade.TradeResult;
import enlightenment.scene.RenderSettings;
import java.util.Locale;
import java.util.Optional;

/** A trade as JSON; docs/trade.md lists the keys. The single runs are in {@code trade.csv}. */
final class TradeJson {
    private TradeJson() {}

    static String of(TradeAnalysis result, EqualTimeComparison equalTime) {
        TradeResult.Conditions c = result.result().conditions();
        JsonText json = new JsonText().beginObject();
        json.key("enlightenment").value(Version.number());
        BenchJson.machine(json.key("machine"), c.machine());
        json.key("complete").value(c.complete());
        json.key("seconds").value(c.seconds());
        json.key("coldStartSeconds").value(c.coldSeconds());
        json.key("shareOfProcessors").value(result.shareOfProcessors());
        settings(json.key("settings"), result);
        reference(json.key("reference"), result.result().reference());
        json.key("verdicts").beginArray();
        Verdict.all(result).forEach(v -> verdict(json, v, result));
        json.endArray();
        json.key("meetings").beginArray();
        EqualErrorComparison.all(result).forEach(m -> meeting(json, m));
        json.endArray();
        json.key("needs").beginArray();
        for (double target : TradeResult.TARGETS) {
            if (result.isKnown(target)) {
                result.costs().forEach(r -> r.forError(target).ifPresent(n -> cost(json, n)));
            }
        }
        json.endArray();
        json.key("curves").beginArray();
        result.curves().forEach(x -> curve(json, x));
        json.endArray();
        equalTime(json, equalTime);
        json.key("sweeps").beginArray();
        result.sweeps().forEach(s -> sweep(json, s));
        return json.endArray().endObject().finish();
    }

    private static void verdict(JsonText json, Verdict v, TradeAnalysis result) {
        json.beginObject();
        json.key("error").value(v.target());
        json.key("known").value(word(v.known()));
        json.key("sentence").value(v.sentence());
        v.best().ifPresent(b -> {
            json.key("arguments").value(Verdict.arguments(b, result.settings()));
            cost(json.key("need"), b);
        });
        json.key("comparisons").beginArray();
        for (Verdict.Comparison c : v.comparisons()) {
            json.beginObject();
            json.key("timesAsLong").value(c.ratio());
            json.key("alike").value(c.alike());
            cost(json.key("need"), c.cost());
            json.endObject();
        }
        json.endArray().endObject();
    }

    private static void meeting(JsonText json, EqualErrorComparison m) {
        json.beginObject();
        json.key("error").value(m.error());
        json.key("smallest").value(m.smallest());
        json.key("lightPoints").value(m.best() ? "best" : "scene");
        json.key("timesAsLong").value(m.ratio());
        cost(json.key("first"), m.first());
        cost(json.key("second"), m.second());
        json.endObject();
    }

    private static void equalTime(JsonText json, EqualTimeComparison comparison) {
        json.key("equal").value(comparison.isEqual());
        comparison.sentence().ifPresent(s -> json.key("equalTimeSentence").value(s));
        json.key("equalTime").beginArray();
        double variance = comparison.referenceVariance();
        for (EqualTimePicture e : comparison.pictures()) {
            json.beginObject();
            json.key("method").value(e.run().method());
            json.key("lightPoints").value(e.run().shadowSamples());
            json.key("samples").value(e.run().samples());
            json.key("wallSeconds").value(e.run().wallSeconds());
            json.key("error").value(e.run().error(variance));
            json.key("flip").value(e.run().flip());
            json.endObject();
        }
        json.endArray();
    }

    private static String word(Enum<?> value) {
        return value.name().toLowerCase(Locale.ROOT);
    }

    private static void settings(JsonText json, TradeAnalysis result) {
        RenderSettings s = result.settings().base();
        json.beginObject();
        json.key("methods").beginArray();
        result.settings().methods().forEach(json::value);
        json.endArray();
        json.key("budgetSeconds").value(result.settings().budgetSeconds());
        json.key("seeds").value(result.settings().seeds());
        json.key("width").value(s.region().width());
        json.key("height").value(s.region().height());
        json.key("antialias").value(s.antialias());
        json.key("shadowSamples").value(s.shadowSamples());
        json.key("seed").value(s.seed());
        json.key("threads").value(s.threads());
        json.endObject();
    }

    private static void reference(JsonText json, Reference reference) {
        json.beginObject();
        json.key("error").value(reference.error());
        json.key("parts").beginArray();
        for (Reference.Part part : reference.parts()) {
            json.beginObject();
            json.key("method").value(part.method());
            json.key("lightPoints").value(part.lightSamples());
            json.key("samples").value(part.samples());
            json.key("seed").value(part.seed());
            json.endObject();
        }
        json.endArray().endObject();
    }

    private static void cost(JsonText json, CostEstimate n) {
        json.beginObject();
        json.key("error").value(n.target());
        configuration(json, n.configuration());
        json.key("samples").value(n.samples());
        json.key("errorItGives").value(n.error());
        n.flip().ifPresent(f -> json.key("flip").value(f));
        BenchJson.spread(json.key("wallSeconds"), n.wall());
        n.cpu().ifPresent(c -> BenchJson.spread(json.key("cpuSeconds"), c));
        json.key("source").value(word(n.source()));
        json.key("from").beginArray();
        n.from().forEach(json::value);
        json.endArray();
        json.endObject();
    }

    private static void configuration(JsonText json, Configuration c) {
        json.key("method").value(c.method());
        json.key("lightPoints").value(c.lightSamples());
        json.key("grid").value(c.grid());
    }

    private static void curve(JsonText json, Curve curve) {
        json.beginObject();
        configuration(json, curve.configuration());
        fit(json, "overSamples", curve.overSamples());
        fit(json, "overTime", curve.overTime());
        json.key("insideOwnInterval").value(curve.insideOwnInterval());
        json.key("judgedRuns").value(curve.judged());
        json.key("points").beginArray();
        for (Curve.Point p : curve.points()) {
            json.beginObject();
            json.key("samples").value(p.samples());
            json.key("samplesPerPixel").value(p.samplesPerPixel());
            json.key("judged").value(p.judged());
            BenchJson.spread(json.key("wallSeconds"), p.wall());
            BenchJson.spread(json.key("cpuSeconds"), p.cpu());
            BenchJson.spread(json.key("error"), p.error());
            BenchJson.spread(json.key("flip"), p.flip());
            BenchJson.spread(json.key("estimatedError"), p.estimated());
            json.endObject();
        }
        json.endArray().endObject();
    }

    private static void fit(JsonText json, String key, Optional<PowerLaw> fit) {
        fit.ifPresent(f -> {
            json.key(key).beginObject();
            json.key("slope").value(f.slope());
            json.key("slopeLow").value(f.slopeLow());
            json.key("slopeHigh").value(f.slopeHigh());
            json.key("factor").value(f.factor());
            json.endObject();
        });
    }

    private static void sweep(JsonText json, SweepResult sweep) {
        json.beginObject();
        json.key("name").value(sweep.sweep().name());
        json.key("method").value(sweep.method());
        json.key("points").beginArray();
        for (SweepResult.Point p : sweep.points()) {
            json.beginObject();
            json.key("value").value(p.value());
            json.key("judged").value(p.judged());
            BenchJson.spread(json.key("wallSeconds"), p.wall());
            BenchJson.spread(json.key("cpuSeconds"), p.cpu());
            BenchJson.spread(json.key("error"), p.error());
            json.endObject();
        }
        json.endArray().endObject();
    }
}
