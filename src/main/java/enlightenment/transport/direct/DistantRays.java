package enlightenment.transport.direct;

import enlightenment.primitive.Ray;
import enlightenment.transport.ray.Departure;
import enlightenment.transport.ray.PathFollower;
import enlightenment.transport.ray.ShadowWalk;
import enlightenment.world.CompiledScene;
import enlightenment.world.material.SurfaceMaterial;
import enlightenment.world.parts.RayCounters;
import java.util.Arrays;

/**
 * Visibility of the surroundings, infinitely far away, from a vertex of a path, and the transmittance of glass that keeps directions. The
 * path itself passes the same surfaces by the same rules.
 */
final class DistantRays {
    /** A distance beyond all surfaces: a ray that hits nothing up to here leaves the scene. */
    private static final double ENDLESS = Double.MAX_VALUE;

    private final PathFollower path;
    private final boolean absorbs;
    private final Ray ray = new Ray();

    /** Follows rays through glass that keeps their direction; null if the scene has none. */
    private final ShadowWalk walk;

    /** The transmittance of the last ray that escaped, by band. */
    final double[] rgb = new double[3];

    /**
     * @param path the path from whose current vertex rays start
     */
    DistantRays(CompiledScene scene, RayCounters counters, PathFollower path) {
        this.path = path;
        absorbs = scene.physical.hasAbsorption;
        walk = scene.physical.hasStraightGlass ? new ShadowWalk(scene, counters) : null;
    }

    /**
     * Whether a ray from the path's current vertex leaves the scene.
     *
     * @param atInterface whether the vertex is on a rough interface of two media
     * @param through whether the ray leaves on the far side of the interface, as the path came
     */
    boolean escapes(double dx, double dy, double dz, boolean atInterface, boolean through) {
        path.poll.tick();
        Arrays.fill(rgb, 1);
        if (!start(dx, dy, dz, atInterface, through) && !path.tracer.occluded(ray, ENDLESS)) {
            // The transmittance of an unbounded medium is 0 in every band that it absorbs.
            SurfaceMaterial medium = absorbs ? path.medium(through) : null;
            if (medium != null && medium.absorbs) {
                medium.absorb(ENDLESS, rgb);
            }
            return true;
        }
        if (walk == null) {
            return false;
        }
        start(dx, dy, dz, atInterface, through);
        return walk.reaches(null, ray, ENDLESS, path, through, rgb);
    }

    /** Starts the ray; returns whether a surface that coincides with the vertex occludes it. */
    private boolean start(double dx, double dy, double dz, boolean atInterface, boolean through) {
        ray.set(path.at.hit.px, path.at.hit.py, path.at.hit.pz, dx, dy, dz, 0);
        return Departure.from(path, ray, atInterface, through);
    }
}
