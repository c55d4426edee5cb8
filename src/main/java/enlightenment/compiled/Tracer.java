package enlightenment.compiled;

import enlightenment.accel.BvhQuery;
import enlightenment.accel.Closest;
import enlightenment.primitive.Hit;
import enlightenment.primitive.Primitive;
import enlightenment.primitive.Ray;

/** Traces rays through a compiled scene. One per thread: it holds the scratch memory of searches and their counts. */
public final class Tracer {
    private static final int NOTHING = -1;

    /** With more candidates than this, a shadow ray traverses the hierarchy instead of testing them all. */
    private static final int MAX_CANDIDATES = 12;

    /** What is known of the visibility of a light from a point before a ray is traced. */
    public enum Visibility {
        /** Nothing can occlude it. */
        ALL,
        /** One primitive occludes all of it. */
        NONE,
        /** Shadow rays must be traced. */
        UNKNOWN
    }

    private final CompiledScene scene;
    private final RayCounters counters;
    private final Closest closest;
    private final TileFrustum frustum = new TileFrustum();
    private final BvhQuery candidates;
    private int candidateCount;

    /** The ids of primitives and indices of lights that camera rays of the current tile may meet. */
    private final int[] tileIds;

    private int tileCount;
    private final int[] tileLights;
    private int tileLightCount;

    /** The same for all other rays: every primitive and light. */
    private final int[] allIds;

    private final int[] allLights;

    private final CoincidentHits coincident;

    /** The light that the last {@link #trace} met, or null. */
    public CompiledLight light;

    /** The id of the primitive that the last {@link #trace} met, or -1. */
    public int id;

    /** A tracer for one thread. */
    public Tracer(CompiledScene scene, RayCounters counters) {
        this.scene = scene;
        this.counters = counters;
        coincident = new CoincidentHits(scene);
        closest = new Closest(scene.kind, counters.tests);
        candidates = new BvhQuery(scene.kind, counters.tests);
        allIds = scene.bvh == null ? count(scene.primitives.length) : new int[0];
        tileIds = new int[allIds.length];
        allLights = count(scene.visibleLights.length);
        tileLights = new int[allLights.length];
    }

    private static int[] count(int n) {
        int[] all = new int[n];
        for (int i = 0; i < n; i++) {
            all[i] = i;
        }
        return all;
    }

    /** Prepares {@link #traceCamera} for the rays at (x0..x1, y0..y1), 0..1 from the picture's upper left corner. */
    public void beginTile(double x0, double y0, double x1, double y1) {
        frustum.set(scene.camera, x0, y0, x1, y1);
        tileCount = frustum.gather(scene.bounds, tileIds);
        tileLightCount = frustum.gather(scene.lightBounds, tileLights);
    }

    /** Whether it is known without tracing that no camera ray of the current tile meets anything. */
    public boolean seesNothing() {
        return scene.bvh == null && tileCount == 0 && tileLightCount == 0;
    }

    /** As {@link #trace}, for a camera ray of the current tile. */
    public boolean traceCamera(Ray ray, Hit hit) {
        return search(ray, hit, tileIds, tileCount, tileLights, tileLightCount);
    }

    /**
     * Finds the first primitive or light that the ray meets.
     *
     * @return whether there is one; if so, either {@link #light} is set, or {@link #id} and the hit are
     */
    public boolean trace(Ray ray, Hit hit) {
        return search(ray, hit, allIds, allIds.length, allLights, allLights.length);
    }

    /** One method for all rays, so that the just-in-time compiler has only one to compile. */
    private boolean search(Ray ray, Hit hit, int[] ids, int idCount, int[] lights, int lightCount) {
        if (scene.bvh != null) {
            scene.bvh.closest(ray, closest);
        } else {
            closest.reset(Double.MAX_VALUE);
            for (int k = 0; k < idCount; k++) {
                closest.offer(ray, scene.primitives[ids[k]], ids[k]);
            }
        }
        id = closest.id();
        double t = closest.t();
        light = null;
        for (int k = 0; k < lightCount; k++) {
            CompiledLight l = scene.visibleLights[lights[k]];
            double s = l.surface.nearest(ray, t);
            // At equal distance a primitive hides the light, unless the light lies on it.
            if (s < t) {
                t = s;
                light = l;
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
        if (scene.coincident.concerns(id)) {
            id = coincident.choose(ray, id, hit);
        }
        if (scene.lightsLieOnSurfaces) {
            findLightOn(ray, hit, lights, lightCount);
        }
        return true;
    }

    /** If a light lies on the surface that was hit, the ray meets the light. */
    private void findLightOn(Ray ray, Hit hit, int[] lights, int lightCount) {
        for (int k = 0; k < lightCount && light == null; k++) {
            CompiledLight l = scene.visibleLights[lights[k]];
            if (l.lyingOn().has(id, hit.face) && l.surface.nearest(ray, Double.MAX_VALUE) != Primitive.MISS) {
                light = l;
                id = NOTHING;
            }
        }
    }

    /**
     * Prepares {@link #occluded} for shadow rays from the cone's apex to its light.
     *
     * @param starts begins with the ids of primitives that the apex lies on and that cannot occlude the light
     * @param count the number of these
     * @return what is known without a ray
     */
    public Visibility prepareShadows(LightCone cone, int[] starts, int count) {
        candidateCount = scene.occluders.gather(cone, starts, count, candidates);
        return candidateCount == 0
                ? Visibility.ALL
                : candidateCount == OccluderSet.ALL_BLOCKED ? Visibility.NONE : Visibility.UNKNOWN;
    }

    /**
     * Traces a shadow ray: whether anything occludes a point of a light.
     *
     * @param ray the shadow ray; it knows the surfaces that it starts on
     * @param tMax the t at which the ray ends on the light
     * @param target the light
     */
    public boolean occluded(Ray ray, double tMax, CompiledLight target) {
        counters.shadowRays++;
        ray.endsOn(target.lyingOn(), tMax);
        if (candidateCount > MAX_CANDIDATES && scene.bvh != null) {
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
