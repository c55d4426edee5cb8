package enlightenment.cli;

import enlightenment.render.RayCluster;
import java.util.List;
import java.util.Locale;

/** Ray clusters as text: for people who want to see what the sampler learned. */
final class ClusterDump {
    private ClusterDump() {}

    /** One array of objects. */
    static String json(List<RayCluster> clusters) {
        JsonText json = new JsonText().beginArray();
        for (RayCluster c : clusters) {
            json.beginObject();
            json.key("block").beginArray().value(c.x()).value(c.y()).endArray();
            json.key("surface").value(c.surface());
            json.key("light").value(c.light());
            json.key("bounces").value(c.bounces());
            json.key("tried").value(c.tried());
            json.key("valid").value(c.valid());
            json.key("gain").value(c.gain());
            for (int k = 0; k < c.distributions().size(); k++) {
                json.key(RayCluster.COORDINATES.get(k)).beginObject();
                json.key("mean").value(c.distributions().get(k).mean());
                json.key("deviation").value(c.distributions().get(k).deviation());
                json.endObject();
            }
            json.endObject();
        }
        return json.endArray().finish();
    }

    /** A header and one line for each cluster; the distributions of clusters without valid rays are empty. */
    static String csv(List<RayCluster> clusters) {
        StringBuilder text = new StringBuilder("x,y,surface,light,bounces,tried,valid,gain");
        for (String name : RayCluster.COORDINATES) {
            text.append(String.format(Locale.ROOT, ",%s mean,%s deviation", name, name));
        }
        text.append('\n');
        for (RayCluster c : clusters) {
            text.append(c.x()).append(',').append(c.y()).append(',').append(c.surface());
            text.append(',').append(c.light()).append(',').append(c.bounces());
            text.append(',')
                    .append(c.tried())
                    .append(',')
                    .append(c.valid())
                    .append(',')
                    .append(c.gain());
            for (int k = 0; k < RayCluster.COORDINATES.size(); k++) {
                if (k < c.distributions().size()) {
                    RayCluster.Coordinate d = c.distributions().get(k);
                    text.append(',').append(d.mean()).append(',').append(d.deviation());
                } else {
                    text.append(",,");
                }
            }
            text.append('\n');
        }
        return text.toString();
    }
}
