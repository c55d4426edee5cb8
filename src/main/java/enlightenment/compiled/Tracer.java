package enlightenment.compiled;

import enlightenment.accel.BvhQuery;
import enlightenment.accel.Closest;
import enlightenment.geometry.Hit;
import enlightenment.geometry.Primitive;
import enlightenment.geometry.Ray;

/**
 * Asks a compiled scene what a ray meets. One per thread: it holds the scratch memory of the searches and their counts.
 */
public final class Tracer {
    private static final int NOTHING = -1;

    /** With more candidates than this, a shadow ray asks the hierarchy instead of testing them all. */
    private static final int MOST_CANDIDATES = 12;

    /** How much of a light is seen from a point. */
    public enum Visibility {
        /** Nothing can stand in the way. */
        ALL,
        /** One thing hides all of it. */
        NONE,
        /** Rays must tell. */
        UNKNOWN
    }

    private final CompiledScene scene;
    private final RayCounters counters;
    private final Closest closest;
    private final TileFrustum frustum = new TileFrustum();
    private final BvhQuery candidates;
    private int candidateCount;

    /** What camera rays of the current tile may meet. */
    private final int[] tileIds;

    private int tileCount;

    /** The light that the last {@link #trace} met, or null. */
    public CompiledLight light;

    /** The id of the primitive that the last {@link #trace} met, or -1. */
    public int id;

    public Tracer(CompiledScene scene, RayCounters counters) {
        this.scene = scene;
        this.counters = counters;
        closest = new Closest(scene.kind, counters.tests);
        candidates = new BvhQuery(scene.kind, counters.tests);
        tileIds = new int[scene.bvh == null ? scene.primitives.length : 0];
    }

    /** Prepares {@link #traceCamera} for the rays at (x0..x1, y0..y1), 0..1 from the picture's upper left corner. */
    public void beginTile(double x0, double y0, double x1, double y1) {
        if (scene.bvh == null) {
            frustum.set(scene.camera, x0, y0, x1, y1);
            tileCount = frustum.gather(scene.bounds, tileIds);
        }
    }

    /** As {@link #trace}, for a camera ray of the current tile. */
    public boolean traceCamera(Ray ray, Hit hit) {
        if (scene.bvh != null) {
            return trace(ray, hit);
        }
        closest.reset(Double.MAX_VALUE);
        for (int k = 0; k < tileCount; k++) {
            int i = tileIds[k];
            closest.offer(ray, scene.primitives[i], i);
        }
        id = closest.id();
        return finish(ray, hit);
    }

    /**
     * Finds the first thing that the ray meets.
     *
     * @return whether there is one; then either {@link #light} is set, or {@link #id} and the hit are
     */
    public boolean trace(Ray ray, Hit hit) {
        id = closestPrimitive(ray);
        return finish(ray, hit);
    }

    private boolean finish(Ray ray, Hit hit) {
        light = null;
        double t = id == NOTHING ? Double.MAX_VALUE : closest.t();
        for (CompiledLight l : scene.lights) {
            if (l.surface != null) {
                double s = l.surface.nearest(ray, t);
                // At equal distance a thing hides the light.
                if (s < t) {
                    t = s;
                    light = l;
                }
            }
        }
        if (light != null) {
            id = NOTHING;
            return true;
        }
        if (id == NOTHING) {
            return false;
        }
        counters.hits[scene.kind[id]]++;
        scene.primitives[id].complete(ray, t, hit);
        return true;
    }

    private int closestPrimitive(Ray ray) {
        if (scene.bvh != null) {
            return scene.bvh.closest(ray, closest);
        }
        closest.reset(Double.MAX_VALUE);
        Primitive[] primitives = scene.primitives;
        for (int i = 0; i < primitives.length; i++) {
            closest.offer(ray, primitives[i], i);
        }
        return closest.id();
    }

    /**
     * Prepares {@link #occluded} for shadow rays from the cone's apex to its light.
     *
     * @param self the primitive that the point lies on, if it cannot stand before the light; -1 otherwise
     * @return what is known without a ray
     */
    public Visibility prepareShadows(LightCone cone, int self) {
        candidateCount = scene.occluders.gather(cone, self, candidates);
        return candidateCount == 0
                ? Visibility.ALL
                : candidateCount == OccluderSet.ALL_BLOCKED ? Visibility.NONE : Visibility.UNKNOWN;
    }

    /** Whether anything stands in the ray's way before tMax. */
    public boolean occluded(Ray ray, double tMax) {
        counters.shadowRays++;
        if (candidateCount > MOST_CANDIDATES && scene.bvh != null) {
            return scene.bvh.occluded(ray, tMax, candidates);
        }
        for (int k = 0; k < candidateCount; k++) {
            int candidate = candidates.get(k);
            if (candidates.blocks(scene.primitives[candidate], candidate, ray, tMax)) {
                return true;
            }
        }
        return false;
    }
}
