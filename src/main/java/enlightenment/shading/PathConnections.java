package enlightenment.shading;

import enlightenment.compiled.SegmentEnds;
import enlightenment.compiled.Tracer;
import enlightenment.primitive.Hit;
import enlightenment.primitive.Ray;

/** Connects first vertices of paths to second vertices of others. One per thread. */
public final class PathConnections {
    private final Tracer tracer;
    private final Ray ray = new Ray();
    private final SegmentEnds ends = new SegmentEnds();
    private int takers;
    private PathCut giver;

    PathConnections(Tracer tracer) {
        this.tracer = tracer;
    }

    /**
     * Prepares for paths that share what their second vertices give.
     *
     * @param count how many of the paths there are
     */
    public void begin(PathCut[] paths, int count) {
        ends.clear();
        takers = 0;
        for (int p = 0; p < count; p++) {
            if (paths[p].takes) {
                Hit at = paths[p].first;
                ends.add(at.px, at.py, at.pz);
                takers++;
            }
        }
        if (takers > 0) {
            ends.finish();
        }
    }

    /** Turns to a path that gives. */
    public void from(PathCut to) {
        giver = to;
        Hit at = to.second;
        tracer.prepareSegments(at.px, at.py, at.pz, ends, takers);
    }

    /**
     * How much of what the second vertex of the giving path gives goes to the first vertex of another, in proportion to others; 0 if that does
     * not see it. It is the density per area, but for a factor, with which paths from there would have found it.
     */
    public double share(PathCut from) {
        if (!from.takes) {
            return 0;
        }
        Hit a = from.first;
        Hit b = giver.second;
        double dx = a.px - b.px;
        double dy = a.py - b.py;
        double dz = a.pz - b.pz;
        double dd = dx * dx + dy * dy + dz * dz;
        double leaving = -(a.nx * dx + a.ny * dy + a.nz * dz) * a.side;
        double arriving = (b.nx * dx + b.ny * dy + b.nz * dz) * b.side;
        if (!(leaving > 0 && arriving > 0)) {
            return 0;
        }
        if (from != giver && isOccluded(a, b, dx, dy, dz)) {
            return 0;
        }
        return leaving / dd * (arriving / dd);
    }

    private boolean isOccluded(Hit a, Hit b, double dx, double dy, double dz) {
        ray.set(b.px, b.py, b.pz, dx, dy, dz, 0).from(b.primitive, b.side);
        ray.alsoFrom(a.primitive, a.side);
        return tracer.occludedSegment(ray);
    }
}
