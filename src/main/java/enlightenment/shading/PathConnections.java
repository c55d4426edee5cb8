package enlightenment.shading;

import enlightenment.compiled.Tracer;
import enlightenment.primitive.Hit;
import enlightenment.primitive.Ray;

/** Connects first vertices of paths to second vertices of others. One per thread. */
public final class PathConnections {
    private final Tracer tracer;
    private final Ray ray = new Ray();

    PathConnections(Tracer tracer) {
        this.tracer = tracer;
    }

    /**
     * How much of what the second vertex of a path gives goes to the first vertex of another, in proportion to others; 0 if that does not see
     * it. It is the density per area, but for a factor, with which paths from there would have found it.
     */
    public double share(PathCut from, PathCut to) {
        if (!from.takes || !to.gives) {
            return 0;
        }
        Hit a = from.first;
        Hit b = to.second;
        double dx = b.px - a.px;
        double dy = b.py - a.py;
        double dz = b.pz - a.pz;
        double dd = dx * dx + dy * dy + dz * dz;
        double leaving = (a.nx * dx + a.ny * dy + a.nz * dz) * a.side;
        double arriving = -(b.nx * dx + b.ny * dy + b.nz * dz) * b.side;
        if (!(leaving > 0 && arriving > 0)) {
            return 0;
        }
        if (from != to && isOccluded(a, b, dx, dy, dz)) {
            return 0;
        }
        return leaving / dd * (arriving / dd);
    }

    private boolean isOccluded(Hit a, Hit b, double dx, double dy, double dz) {
        ray.set(a.px, a.py, a.pz, dx, dy, dz, 0).from(a.primitive, a.side);
        ray.alsoFrom(b.primitive, b.side);
        return tracer.occluded(ray, 1);
    }
}
