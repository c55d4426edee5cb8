package enlightenment.transport.ray;

import enlightenment.primitive.Hit;
import enlightenment.primitive.Ray;
import enlightenment.world.CompiledScene;
import enlightenment.world.material.SurfaceMaterial;
import enlightenment.world.parts.RayCounters;
import java.util.Arrays;

/**
 * Visibility between the vertex of a path and a place on another surface, and the transmittance of media and of glass that keeps directions
 * on the way. The path itself passes the same surfaces by the same rules.
 */
public final class SegmentRays {
    private final PathFollower path;
    private final Hit hit;
    private final Ray ray = new Ray();
    private final boolean absorbs;

    /** Follows rays through glass that keeps their direction; null if the scene has none. */
    private final PathFollower walk;

    private boolean isInterface;
    private boolean isBeyond;
    private double dx;
    private double dy;
    private double dz;
    private double length;
    private int endId;
    private int endFace;

    /** The transmittance of the last segment, by band. */
    public final double[] rgb = new double[3];

    /**
     * @param path the path from whose current vertex segments start
     */
    public SegmentRays(CompiledScene scene, RayCounters counters, PathFollower path) {
        this.path = path;
        hit = path.at.hit;
        absorbs = scene.physical.hasAbsorption;
        walk = scene.physical.hasStraightGlass ? new PathFollower(scene, counters, Integer.MAX_VALUE) : null;
    }

    /**
     * Begins at the path's current vertex.
     *
     * @param atInterface whether the vertex is on a rough interface of two media
     * @param through whether the rays leave on the far side of the interface, as the path came
     */
    public void begin(boolean atInterface, boolean through) {
        isInterface = atInterface;
        isBeyond = through;
    }

    /**
     * Whether nothing occludes the place at this distance along a unit vector: on a face of a primitive, or on no surface if the id is
     * negative.
     */
    public boolean reaches(double x, double y, double z, double distance, int id, int face) {
        return reachesDirectly(x, y, z, distance, id, face) || walk != null && walks();
    }

    /** As {@link #reaches}, but panes and interfaces of equal index occlude, too. */
    public boolean reachesDirectly(double x, double y, double z, double distance, int id, int face) {
        dx = x;
        dy = y;
        dz = z;
        length = distance;
        endId = id;
        endFace = face;
        path.poll.tick();
        Arrays.fill(rgb, 1);
        if (!start() && path.tracer.joins(ray, length, id, face)) {
            absorb(absorbs ? path.medium(isBeyond) : null, length);
            return true;
        }
        return false;
    }

    /** Starts the ray; returns whether a surface that coincides with the vertex occludes it. */
    private boolean start() {
        ray.set(hit.px, hit.py, hit.pz, dx, dy, dz, 0);
        return Departure.from(path, ray, isInterface, isBeyond);
    }

    private boolean walks() {
        start();
        walk.beginShadow(path, ray, isBeyond);
        double left = length;
        while (true) {
            SurfaceMaterial medium = absorbs ? walk.medium() : null;
            PathFollower.Event event = walk.next(ray);
            boolean isPast = event == PathFollower.Event.NOTHING || walk.distance(ray) >= left;
            boolean isEnd = event != PathFollower.Event.NOTHING && isEnd(left - walk.distance(ray));
            if (isPast || isEnd) {
                absorb(medium, left);
                return true;
            }
            absorb(medium, walk.distance(ray));
            left -= walk.distance(ray);
            if (event == PathFollower.Event.SURFACE || !walk.passStraight(ray, rgb)) {
                return false;
            }
        }
    }

    private boolean isEnd(double left) {
        return endId >= 0 && path.tracer.isEnd(ray, left, walk.at.id, walk.at.hit, endId, endFace);
    }

    private void absorb(SurfaceMaterial medium, double distance) {
        if (medium != null && medium.absorbs) {
            medium.absorb(distance, rgb);
        }
    }
}
