package enlightenment.cli.render;

import enlightenment.json.JsonText;
import enlightenment.render.RenderResult;
import java.util.List;
import tools.jackson.core.JsonGenerator;

/** Markov chains as JSON, one object each; docs/notes/metropolis.md lists the keys. */
final class ChainJson {
    private ChainJson() {}

    static String of(List<RenderResult.PathChain> chains) {
        return JsonText.of(json -> {
            json.writeStartArray();
            chains.forEach(c -> chain(json, c));
            json.writeEndArray();
        });
    }

    private static void chain(JsonGenerator json, RenderResult.PathChain c) {
        json.writeStartObject();
        pixel(json, "block", c.blockX(), c.blockY());
        json.writeNumberProperty("group", c.group());
        pixel(json, "start", c.startX(), c.startY());
        pixel(json, "end", c.endX(), c.endY());
        json.writeNumberProperty("startBrightness", c.startBrightness());
        json.writeNumberProperty("meanBrightness", c.meanBrightness());
        json.writeNumberProperty("steps", c.steps());
        json.writeNumberProperty("accepted", c.accepted());
        json.writeNumberProperty("largeSteps", c.largeSteps());
        json.writeNumberProperty("largeAccepted", c.largeAccepted());
        json.writeEndObject();
    }

    private static void pixel(JsonGenerator json, String name, int x, int y) {
        json.writeName(name);
        json.writeArray(new int[] {x, y}, 0, 2);
    }
}
