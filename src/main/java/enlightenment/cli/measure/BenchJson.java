package enlightenment.cli.measure;

import enlightenment.cli.picture.ReportJson;
import enlightenment.cli.terminal.Version;
import enlightenment.json.JsonText;
import enlightenment.measure.Bench;
import enlightenment.measure.trade.Spread;
import enlightenment.scene.RenderSettings;
import java.util.List;
import java.util.Map;
import tools.jackson.core.JsonGenerator;

/** The figures of {@code bench} as JSON; docs/notes/benchmarks.md lists the keys. */
final class BenchJson {
    private BenchJson() {}

    static String of(List<Bench> all, Map<String, String> machine, int repeats) {
        return JsonText.of(json -> {
            json.writeStartObject();
            json.writeStringProperty("enlightenment", Version.number());
            machine(json, machine);
            json.writeNumberProperty("repeats", repeats);
            json.writeArrayPropertyStart("scenes");
            all.forEach(b -> bench(json, b));
            json.writeEndArray();
            json.writeEndObject();
        });
    }

    private static void bench(JsonGenerator json, Bench b) {
        RenderSettings s = b.settings();
        json.writeStartObject();
        json.writeStringProperty("name", b.name());
        json.writeStringProperty("method", s.method().word());
        json.writeNumberProperty("width", s.width());
        json.writeNumberProperty("height", s.height());
        json.writeNumberProperty("antialias", s.antialias());
        ReportJson.numbers(json, s);
        ReportJson.words(json, s);
        json.writeNumberProperty("threads", s.threads());
        spread(json, "wallSeconds", b.wall());
        spread(json, "cpuSeconds", b.cpu());
        json.writeNumberProperty("rays", b.rays());
        json.writeNumberProperty("lightSamples", b.lightSamples());
        json.writeNumberProperty("raysPerSecond", b.raysPerSecond());
        json.writeNumberProperty("lightSamplesPerSecond", b.lightSamplesPerSecond());
        json.writeEndObject();
    }

    static void machine(JsonGenerator json, Map<String, String> machine) {
        json.writeObjectPropertyStart("machine");
        machine.forEach(json::writeStringProperty);
        json.writeEndObject();
    }

    static void spread(JsonGenerator json, String key, Spread s) {
        json.writeObjectPropertyStart(key);
        json.writeNumberProperty("low", s.low());
        json.writeNumberProperty("median", s.median());
        json.writeNumberProperty("high", s.high());
        json.writeNumberProperty("count", s.count());
        json.writeEndObject();
    }
}
