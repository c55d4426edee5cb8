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
 * Whether nothing hides what is infinitely far from a vertex of a path, and what of its light glass that does not turn rays lets pass.
 * Paths pass the same surfaces by the same rules.
 */
final class DistantRays {
    /** Farther than anything; what is missed is infinitely far. */
    private static final double ENDLESS = Double.MAX_VALUE;

    private final PathFollower path;
    private final boolean absorbs;
    private final Ray ray = new Ray();

    /** Follows rays through glass that does not turn them; null if there is none. */
    private final ShadowWalk walk;

    /** What comes through, by band. */
    final double[] rgb = new double[3];

    /** From the vertex that a path is at. */
    DistantRays(CompiledScene scene, RayCounters counters, PathFollower path) {
        this.path = path;
        absorbs = scene.physical.hasAbsorption;
        walk = scene.physical.hasStraightGlass ? new ShadowWalk(scene, counters) : null;
    }

    /**
     * Whether a ray from the vertex that the path is at leaves the scene.
     *
     * @param atBorder whether that is a rough border of two media
     * @param through whether the ray leaves it on the side that the path did not come from
     */
    boolean escapes(double dx, double dy, double dz, boolean atBorder, boolean through) {
        path.poll.tick();
        Arrays.fill(rgb, 1);
        if (!start(dx, dy, dz, atBorder, through) && !path.tracer.occluded(ray, ENDLESS)) {
            // In a medium without end nothing comes through but where nothing is lost.
            SurfaceMaterial medium = absorbs ? path.medium(through) : null;
            if (medium != null && medium.absorbs) {
                medium.absorb(ENDLESS, rgb);
            }
            return true;
        }
        if (walk == null) {
            return false;
        }
        start(dx, dy, dz, atBorder, through);
        return walk.reaches(null, ray, ENDLESS, path, through, rgb);
    }

    /** Returns whether something is in the ray's way at once. */
    private boolean start(double dx, double dy, double dz, boolean atBorder, boolean through) {
        ray.set(path.at.hit.px, path.at.hit.py, path.at.hit.pz, dx, dy, dz, 0);
        return Departure.from(path, ray, atBorder, through);
    }
}
