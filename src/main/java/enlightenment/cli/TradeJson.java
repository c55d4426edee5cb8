package enlightenment.cli;

import enlightenment.measure.Curve;
import enlightenment.measure.EqualTime;
import enlightenment.measure.Need;
import enlightenment.measure.PowerLaw;
import enlightenment.measure.Reference;
import enlightenment.measure.SweepResult;
import enlightenment.measure.TradeResult;
import enlightenment.measure.Verdict;
import enlightenment.scene.RenderSettings;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;

/** A trade as JSON; docs/trade.md lists the keys. The single runs are in {@code trade.csv}. */
final class TradeJson {
    private TradeJson() {}

    static String of(TradeResult result, Map<String, String> machine) {
        JsonText json = new JsonText().beginObject();
        json.key("enlightenment").value(Version.number());
        BenchJson.machine(json.key("machine"), machine);
        json.key("complete").value(result.complete());
        json.key("seconds").value(result.seconds());
        json.key("coldStartSeconds").value(result.coldSeconds());
        json.key("shareOfProcessors").value(result.shareOfProcessors());
        settings(json.key("settings"), result);
        reference(json.key("reference"), result.reference());
        json.key("verdicts").beginArray();
        for (Verdict v : Verdict.all(result)) {
            json.beginObject();
            json.key("error").value(v.target());
            json.key("sentence").value(v.sentence());
            v.best().ifPresent(b -> json.key("arguments").value(Verdict.arguments(b)));
            json.endObject();
        }
        json.endArray();
        json.key("needs").beginArray();
        result.needs().forEach(n -> need(json, n));
        json.endArray();
        json.key("curves").beginArray();
        result.curves().forEach(c -> curve(json, c));
        json.endArray();
        json.key("equalTime").beginArray();
        for (EqualTime e : result.equalTime()) {
            json.beginObject();
            json.key("method").value(e.run().method());
            json.key("samples").value(e.run().samples());
            json.key("wallSeconds").value(e.run().wallSeconds());
            json.key("error").value(e.run().error(result.reference().variance()));
            json.key("flip").value(e.run().flip());
            json.endObject();
        }
        json.endArray();
        json.key("sweeps").beginArray();
        result.sweeps().forEach(s -> sweep(json, s));
        return json.endArray().endObject().finish();
    }

    private static void settings(JsonText json, TradeResult result) {
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
            json.key("samples").value(part.samples());
            json.key("seed").value(part.seed());
            json.endObject();
        }
        json.endArray().endObject();
    }

    private static void need(JsonText json, Need n) {
        json.beginObject();
        json.key("error").value(n.target());
        json.key("method").value(n.method());
        json.key("samples").value(n.samples());
        json.key("errorItGives").value(n.error());
        BenchJson.spread(json.key("wallSeconds"), n.wall());
        n.cpu().ifPresent(c -> BenchJson.spread(json.key("cpuSeconds"), c));
        json.key("source").value(n.source().name().toLowerCase(Locale.ROOT));
        json.endObject();
    }

    private static void curve(JsonText json, Curve curve) {
        json.beginObject();
        json.key("method").value(curve.method());
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
            BenchJson.spread(json.key("wallSeconds"), p.wall());
            BenchJson.spread(json.key("cpuSeconds"), p.cpu());
            BenchJson.spread(json.key("error"), p.error());
            json.endObject();
        }
        json.endArray().endObject();
    }
}
