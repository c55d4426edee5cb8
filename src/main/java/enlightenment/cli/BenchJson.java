package enlightenment.cli;

import enlightenment.measure.Bench;
import enlightenment.measure.trade.Spread;
import enlightenment.scene.RenderSettings;
import java.util.List;
import java.util.Map;

/** The figures of {@code bench} as JSON; docs/benchmarks.md lists the keys. */
final class BenchJson {
    private BenchJson() {}

    static String of(List<Bench> all, Map<String, String> machine, int repeats) {
        JsonText json = new JsonText().beginObject();
        json.key("enlightenment").value(Version.number());
        machine(json.key("machine"), machine);
        json.key("repeats").value(repeats);
        json.key("scenes").beginArray();
        for (Bench b : all) {
            RenderSettings s = b.settings();
            json.beginObject();
            json.key("name").value(b.name());
            json.key("method").value(s.method().word());
            json.key("width").value(s.width());
            json.key("height").value(s.height());
            json.key("antialias").value(s.antialias());
            json.key("shadowSamples").value(s.shadowSamples());
            json.key("threads").value(s.threads());
            spread(json.key("wallSeconds"), b.wall());
            spread(json.key("cpuSeconds"), b.cpu());
            json.key("rays").value(b.rays());
            json.key("lightSamples").value(b.lightSamples());
            json.key("raysPerSecond").value(b.raysPerSecond());
            json.key("lightSamplesPerSecond").value(b.lightSamplesPerSecond());
            json.endObject();
        }
        return json.endArray().endObject().finish();
    }

    static void machine(JsonText json, Map<String, String> machine) {
        json.beginObject();
        machine.forEach((k, v) -> json.key(k).value(v));
        json.endObject();
    }

    static void spread(JsonText json, Spread s) {
        json.beginObject();
        json.key("low").value(s.low());
        json.key("median").value(s.median());
        json.key("high").value(s.high());
        json.key("count").value(s.count());
        json.endObject();
    }
}
