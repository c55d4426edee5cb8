package enlightenment.cli.render;

import enlightenment.json.JsonText;
import enlightenment.render.RenderResult;
import java.util.List;
import tools.jackson.core.JsonGenerator;

/** Ray clusters as JSON, one object each; docs/notes/cluster-sampler.md lists the keys. */
final class ClusterJson {
    private ClusterJson() {}

    static String of(List<RenderResult.RayCluster> clusters) {
        return JsonText.of(json -> {
            json.writeStartArray();
            clusters.forEach(c -> cluster(json, c));
            json.writeEndArray();
        });
    }

    private static void cluster(JsonGenerator json, RenderResult.RayCluster c) {
        json.writeStartObject();
        json.writeName("block");
        json.writeArray(new int[] {c.x(), c.y()}, 0, 2);
        json.writeNumberProperty("surface", c.surface());
        json.writeNumberProperty("light", c.light());
        json.writeNumberProperty("bounces", c.bounces());
        json.writeNumberProperty("tried", c.tried());
        json.writeNumberProperty("valid", c.valid());
        json.writeNumberProperty("gain", c.gain());
        for (int k = 0; k < c.distributions().size(); k++) {
            json.writeObjectPropertyStart(RenderResult.RayCluster.COORDINATES.get(k));
            json.writeNumberProperty("mean", c.distributions().get(k).mean());
            json.writeNumberProperty("deviation", c.distributions().get(k).deviation());
            json.writeEndObject();
        }
        json.writeEndObject();
    }
}
