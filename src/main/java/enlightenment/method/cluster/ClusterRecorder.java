package enlightenment.method.cluster;

import enlightenment.primitive.Hit;
import enlightenment.primitive.Ray;
import enlightenment.shading.LightObserver;
import java.util.ArrayList;
import java.util.List;
import java.util.function.Consumer;

/** Keeps the nine distributions of each cluster of a block, if somebody wants to see them. */
final class ClusterRecorder implements LightObserver {
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

    @Override
    public void ray(
            int surface,
            int light,
            int bounce,
            Hit from,
            double dx,
            double dy,
            double dz,
            double distance,
            boolean blocked) {
        ClusterStatistics record = find(surface, light, bounce);
        if (blocked) {
            record.reject();
            return;
        }
        points[3] = from.px;
        points[4] = from.py;
        points[5] = from.pz;
        points[6] = Math.fma(dx, distance, from.px);
        points[7] = Math.fma(dy, distance, from.py);
        points[8] = Math.fma(dz, distance, from.pz);
        record.accept(points);
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
