package enlightenment.cli.render;

import enlightenment.render.RenderResult;
import java.util.List;

/** Ray clusters as comma-separated values: a header and one line for each cluster. */
final class ClusterCsv {
    private ClusterCsv() {}

    static String of(List<RenderResult.RayCluster> clusters) {
        StringBuilder text = new StringBuilder("x,y,surface,light,bounces,tried,valid,gain");
        RenderResult.RayCluster.COORDINATES.forEach(name ->
                text.append(',').append(name).append(" mean,").append(name).append(" deviation"));
        text.append('\n');
        clusters.forEach(c -> append(text, c));
        return text.toString();
    }

    /** The cells of the distributions of clusters without valid rays are empty. */
    private static void append(StringBuilder text, RenderResult.RayCluster c) {
        text.append(c.x()).append(',').append(c.y()).append(',').append(c.surface());
        text.append(',').append(c.light()).append(',').append(c.bounces());
        text.append(',').append(c.tried()).append(',').append(c.valid());
        text.append(',').append(c.gain());
        for (int k = 0; k < RenderResult.RayCluster.COORDINATES.size(); k++) {
            if (k < c.distributions().size()) {
                RenderResult.RayCluster.Coordinate d = c.distributions().get(k);
                text.append(',').append(d.mean()).append(',').append(d.deviation());
            } else {
                text.append(",,");
            }
        }
        text.append('\n');
    }
}
