package enlightenment.compiled;

import enlightenment.accel.Closest;
import enlightenment.geometry.Hit;
import enlightenment.geometry.Primitive;
import enlightenment.geometry.Ray;

/**
 * Asks a compiled scene what a ray meets. One per thread: it holds the scratch memory of the searches and their counts.
 */
public final class Tracer {
    private static final int NOTHING = -1;

    private final CompiledScene scene;
    private final RayCounters counters;
    private final Closest closest = new Closest();
    private int[] candidates;
    private int candidateCount;

    /** The light that the last {@link #trace} met, or null. */
    public CompiledLight light;

    /** The id of the primitive that the last {@link #trace} met, or -1. */
    public int id;

    public Tracer(CompiledScene scene, RayCounters counters) {
        this.scene = scene;
        this.counters = counters;
        candidates = new int[scene.occluders == null ? 64 : scene.occluders.size()];
    }

    /**
     * Finds the first thing that the ray meets.
     *
     * @return whether there is one; then either {@link #light} is set, or {@link #id} and the hit are
     */
    public boolean trace(Ray ray, Hit hit) {
        light = null;
        id = closestPrimitive(ray);
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
        counters.loopSearches++;
        closest.reset(Double.MAX_VALUE);
        Primitive[] primitives = scene.primitives;
        for (int i = 0; i < primitives.length; i++) {
            closest.offer(ray, primitives[i], i);
        }
        return closest.id();
    }

    /**
     * Prepares {@link #occluded} for shadow rays from one point to one light.
     *
     * @param self the primitive that the point lies on, if it cannot stand before the light; -1 otherwise
     * @return false if nothing can stand between them, so that no ray is needed
     */
    public boolean prepareShadows(double x, double y, double z, CompiledLight target, int self) {
        if (scene.occluders == null) {
            candidateCount = -1;
            return true;
        }
        candidateCount = scene.occluders.gather(x, y, z, target, self, candidates);
        return candidateCount > 0;
    }

    /** Whether anything stands in the ray's way before tMax. */
    public boolean occluded(Ray ray, double tMax) {
        counters.shadowRays++;
        if (candidateCount < 0) {
            return scene.bvh.occluded(ray, tMax);
        }
        for (int k = 0; k < candidateCount; k++) {
            int candidate = candidates[k];
            counters.tests[scene.kind[candidate]]++;
            if (scene.primitives[candidate].nearest(ray, tMax) <= tMax) {
                return true;
            }
        }
        return false;
    }
}
