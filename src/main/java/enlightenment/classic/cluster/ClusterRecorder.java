package enlightenment.classic.cluster;

import enlightenment.classic.shading.LightSamples;
import enlightenment.classic.shading.PathReport;
import enlightenment.method.Block;
import enlightenment.primitive.Ray;
import java.util.ArrayList;
import java.util.List;
import java.util.function.Consumer;

/** Keeps the nine distributions of each cluster of a block, if somebody wants to see them. */
final class ClusterRecorder {
    private final Consumer<List<ClusterStatistics>> sink;
    private final double[] points = new double[ClusterStatistics.COORDINATES];
    private List<ClusterStatistics> records = new ArrayList<>();
    private Block block;

    ClusterRecorder(Consumer<List<ClusterStatistics>> sink) {
        this.sink = sink;
    }

    void begin(Block next) {
        block = next;
        records = new ArrayList<>();
    }

    /** Hands over what was recorded of the block. */
    void end(ClusterGuide guide) {
        for (ClusterStatistics r : records) {
            r.gain(guide == null ? 1 : guide.gain(r.surface, r.light, r.bounces));
        }
        sink.accept(records);
    }

    /** Notes the film point of the camera ray that is followed next: where it passes the window, one direction's length on. */
    void camera(Ray ray) {
        points[0] = ray.ox + ray.dx;
        points[1] = ray.oy + ray.dy;
        points[2] = ray.oz + ray.dz;
    }

    /** Records the light samples of the path that was followed. */
    void read(PathReport report) {
        LightSamples rays = report.rays;
        for (int k = 0; k < rays.size(); k++) {
            ClusterStatistics record = find(rays.surface(k), rays.light(k), rays.bounce(k));
            if (rays.isBlocked(k)) {
                record.reject();
            } else {
                for (int c = 0; c < 3; c++) {
                    points[3 + c] = rays.number(k, PathReport.SURFACE_POINT + c);
                    points[6 + c] = rays.number(k, PathReport.LIGHT_POINT + c);
                }
                record.accept(points);
            }
        }
    }

    private ClusterStatistics find(int surface, int light, int bounce) {
        for (ClusterStatistics r : records) {
            if (r.is(surface, light, bounce)) {
                return r;
            }
        }
        ClusterStatistics r = new ClusterStatistics(block, surface, light, bounce);
        records.add(r);
        return r;
    }
}
