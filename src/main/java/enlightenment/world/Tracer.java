package enlightenment.world;

import enlightenment.accel.Accelerator;
import enlightenment.accel.BvhQuery;
import enlightenment.accel.Closest;
import enlightenment.accel.ConeSearch;
import enlightenment.accel.PrimitiveList;
import enlightenment.accel.RaySearch;
import enlightenment.primitive.EndFaces;
import enlightenment.primitive.Hit;
import enlightenment.primitive.Primitive;
import enlightenment.primitive.Ray;
import enlightenment.world.camera.TileFrustum;
import enlightenment.world.contact.CoincidentFaces;
import enlightenment.world.contact.CoincidentHits;
import enlightenment.world.contact.CoincidentSurfaces;
import enlightenment.world.light.ClassicLight;
import enlightenment.world.light.LightBody;
import enlightenment.world.light.LightCone;
import enlightenment.world.light.OccluderSet;
import enlightenment.world.light.SegmentEnds;
import enlightenment.world.parts.RayCounters;

/** Traces rays through a compiled scene. One per thread: it holds the scratch memory of searches and their counts. */
public final class Tracer {
    private static final int NOTHING = -1;

    /** Visibility of a light from a point, as far as it is known before a ray is traced. */
    public enum Visibility {
        /** Nothing occludes any point of the light. */
        ALL,
        /** One primitive occludes the whole light. */
        NONE,
        /** Shadow rays must be traced. */
        UNKNOWN
    }

    private final CompiledScene scene;
    private final RayCounters counters;
    private final Closest closest;
    private final TileFrustum frustum = new TileFrustum();
    private final BvhQuery query;
    private final OccluderSet.Judge judge;

    /** Whether {@link #prepareShadows} may return {@link Visibility#UNKNOWN} to save time. */
    private boolean leavesOpen;

    /** Decides visibilities in a hierarchy; null until the first use. */
    private ConeSearch decides;

    /** Finds the occluders of segments; null until the first use. */
    private OccluderSet.SegmentJudge segments;

    /** Whether nothing occludes any of the segments. */
    private boolean isFree;

    /** The primitives that camera rays of the current tile may hit. */
    private final RaySearch tile;

    /** {@link #tile} if it is a list, else null. */
    private final PrimitiveList tileList;

    /** The indices of lights that camera rays of the current tile may hit. */
    private final int[] tileLights;

    private int tileLightCount;

    /** The indices of lights that all other rays may hit: every light. */
    private final int[] allLights;

    private final CoincidentHits coincident;
    private final Hit end = new Hit();

    /** The t beyond which {@link #trace} and {@link #traceCamera} find no hit, in lengths of the ray's direction. */
    public double limit = Double.MAX_VALUE;

    /** The classic light that the last {@link #trace} hit, or null. */
    public ClassicLight light;

    /** The id of the primitive that the last {@link #trace} hit, or -1. */
    public int id;

    /** A tracer for one thread. */
    public Tracer(CompiledScene scene, RayCounters counters) {
        this.scene = scene;
        this.counters = counters;
        coincident = scene.coincidentHits();
        closest = new Closest(scene.kind, counters.tests);
        query = new BvhQuery(scene.kind, counters.tests);
        judge = scene.occluders.new Judge();
        tileList = scene.accelerator instanceof PrimitiveList all ? all.empty() : null;
        tile = tileList == null ? scene.accelerator : tileList;
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
        if (tileList != null) {
            tileList.size(frustum.gather(scene.bounds, tileList.members()));
        }
        tileLightCount = frustum.gather(scene.lightBounds, tileLights);
    }

    /**
     * Whether it is known without tracing that camera rays of the current tile hit nothing. Always false with a hierarchy: the answer would
     * depend on the tree, and the survey of the cluster method depends on the answer.
     */
    public boolean seesNothing() {
        return tileList != null && tileList.size() == 0 && tileLightCount == 0;
    }

    /** As {@link #trace}, for a camera ray of the current tile. */
    public boolean traceCamera(Ray ray, Hit hit) {
        return search(ray, hit, tile, tileLights, tileLightCount);
    }

    /** Whether the first surface that a ray hits is this light of physical shading, on an emitting side. */
    public boolean meetsLight(Ray ray, Hit out, int index) {
        return trace(ray, out)
                && scene.physical.lightOf(id, out.face) == index
                && scene.material(id, out.face).glowsTo(out.side);
    }

    /**
     * Finds the first primitive or light that the ray hits.
     *
     * @return whether there is one; if so, either {@link #light} is set, or {@link #id} and the hit are
     */
    public boolean trace(Ray ray, Hit hit) {
        return search(ray, hit, scene.accelerator, allLights, allLights.length);
    }

    /** A single method for all rays, so that the JIT compiler compiles only one. */
    private boolean search(Ray ray, Hit hit, RaySearch among, int[] lights, int lightCount) {
        closest.reset(limit);
        among.search(ray, closest);
        id = closest.id();
        double t = closest.t();
        light = null;
        for (int k = 0; k < lightCount; k++) {
            ClassicLight l = scene.visibleLights[lights[k]];
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
        closest.complete(ray, hit);
        if (scene.coincident.concerns(id)) {
            id = coincident.choose(ray, id, hit);
        }
        if (scene.lightsLieOnSurfaces) {
            findLightOn(ray, hit, lights, lightCount);
        }
        return true;
    }

    /** If a light lies on the surface that was hit, the ray hits the light. */
    private void findLightOn(Ray ray, Hit hit, int[] lights, int lightCount) {
        for (int k = 0; k < lightCount && light == null; k++) {
            ClassicLight l = scene.visibleLights[lights[k]];
            if (l.lyingOn().has(id, hit.face) && l.surface.nearest(ray, Double.MAX_VALUE) != Primitive.MISS) {
                light = l;
                id = NOTHING;
            }
        }
    }

    /**
     * Lets {@link #prepareShadows} return {@link Visibility#UNKNOWN} wherever a shadow ray costs less than the decision. By default its
     * result is a function of the cone and the scene alone.
     */
    public void leaveVisibilityOpen() {
        leavesOpen = tileList == null;
    }

    /**
     * Prepares {@link #occluded} for shadow rays from the cone's apex to its light.
     *
     * @param cone of directions to the light
     * @param starts begins with the ids of primitives that the apex lies on and that cannot occlude the light
     * @param count the number of these
     * @param lightSamples the number of shadow rays to come, unless the visibility is known
     * @return the visibility of the whole light
     */
    public Visibility prepareShadows(LightCone cone, int[] starts, int count, int lightSamples) {
        judge.of(cone, starts, count);
        int left;
        if (leavesOpen || tileList != null) {
            Accelerator occluders = cone.light().occluders;
            left = (occluders == null ? scene.accelerator : occluders).narrow(cone, judge, lightSamples, query);
        } else {
            if (decides == null) {
                decides = scene.coneSearch();
            }
            left = decides.narrow(cone, judge, query);
        }
        return left == 0 ? Visibility.ALL : left == Accelerator.BLOCKED ? Visibility.NONE : Visibility.UNKNOWN;
    }

    /**
     * Traces a shadow ray that ends in free space, as at the eye.
     *
     * @param ray carries the surfaces that it starts on
     * @param tMax the t at which it ends
     */
    public boolean occluded(Ray ray, double tMax) {
        counters.shadowRays++;
        return scene.accelerator.occluded(ray, tMax, query);
    }

    /**
     * Prepares {@link #occludedSegment} for rays from a point.
     *
     * @param on the id of the primitive that they begin on and cannot hit again; -1 if there is none
     * @param ends the end points
     * @param rays the number of rays to come
     * @return whether anything may occlude any of them
     */
    public boolean prepareSegments(double x, double y, double z, int on, SegmentEnds ends, int rays) {
        if (segments == null) {
            segments = scene.occluders.new SegmentJudge();
        }
        segments.begin(ends, on);
        ends.seenFrom(x, y, z);
        isFree = scene.accelerator.narrow(ends.cone, segments, rays, query) == 0;
        return !isFree;
    }

    /**
     * Traces a shadow ray from the point to one of the ends of {@link #prepareSegments}, if anything may occlude it. No other query may
     * come in between.
     *
     * @param ray carries the surfaces that it starts and ends on
     */
    public boolean occludedSegment(Ray ray) {
        if (isFree) {
            return false;
        }
        counters.shadowRays++;
        return scene.accelerator.occludedWithin(ray, 1, query);
    }

    /**
     * Traces a ray between two points, on surfaces or not: whether nothing lies between them. The end's own surface never occludes it, on
     * whichever side of the end rounding puts it.
     *
     * @param ray carries the surfaces that it starts on
     * @param length the t at which it ends
     * @param endId the id of the primitive that it ends on; -1 if it ends on none
     * @param endFace the face of that primitive
     */
    public boolean joins(Ray ray, double length, int endId, int endFace) {
        counters.shadowRays++;
        closest.reset(length);
        scene.accelerator.search(ray, closest);
        int met = closest.id();
        if (endId != NOTHING && leavesGlassAtEnd(ray, length, endId, endFace)) {
            return false;
        }
        if (met == NOTHING) {
            return true;
        }
        if (met != endId && (endId == NOTHING || !scene.coincident.concerns(endId))) {
            return false;
        }
        closest.complete(ray, end);
        return isEnd(ray, length - closest.t(), met, end, endId, endFace);
    }

    /** Whether a ray ends on an opaque surface and leaves a solid of glass that lies on it: then there is an interface before its end. */
    private boolean leavesGlassAtEnd(Ray ray, double length, int endId, int endFace) {
        if (scene.glassSolids.length == 0 || !scene.coincident.concerns(endId)) {
            return false;
        }
        CoincidentFaces pairs = scene.coincident.of(endId);
        for (int k : pairs.glass()) {
            int other = pairs.other(k);
            int face = pairs.otherFace(k);
            Primitive p = scene.primitives[other];
            if (pairs.face(k) == endFace
                    && EndFaces.crossesAtEnd(
                            ray,
                            length,
                            p,
                            face,
                            EndFaces.bit(Ray.INSIDE),
                            p.support(face).isFlat(),
                            tolerance(p),
                            end)) {
                return true;
            }
        }
        return false;
    }

    /**
     * Whether a hit is the end of a ray. The interface of a solid of glass that the ray leaves there is not: it comes before the end.
     *
     * @param left the distance of the end behind the hit, in lengths of the ray's direction
     */
    public boolean isEnd(Ray ray, double left, int met, Hit at, int endId, int endFace) {
        if (met == endId ? at.face != endFace : !scene.coincident.coincide(endId, endFace, met, at.face)) {
            return false;
        }
        Primitive p = scene.primitives[met];
        boolean leavesGlass = at.side == Ray.INSIDE && p.isSolid() && scene.isGlass(met, at.face);
        return !(leavesGlass && met != endId)
                && EndFaces.isAtEnd(ray, at, left, p.support(at.face).isFlat(), tolerance(p));
    }

    private static double tolerance(Primitive p) {
        return CoincidentSurfaces.tolerance(p.bounds(), p.bounds());
    }

    /**
     * Traces a shadow ray: whether anything occludes a point of a light.
     *
     * @param ray carries the surfaces that it starts on
     * @param tMax the t at which the ray ends on the light
     * @param target the light
     */
    public boolean occluded(Ray ray, double tMax, LightBody target) {
        counters.shadowRays++;
        EndFaces on = target.lyingOn();
        if (on.isHiddenAtEnd(ray, tMax, end)) {
            return true;
        }
        ray.endsOn(on, tMax);
        return scene.accelerator.occludedWithin(ray, tMax, query);
    }
}
