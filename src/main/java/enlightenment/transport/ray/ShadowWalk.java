package enlightenment.transport.ray;

import enlightenment.primitive.Hit;
import enlightenment.primitive.Ray;
import enlightenment.world.CompiledScene;
import enlightenment.world.light.PhysicalLight;
import enlightenment.world.material.SurfaceMaterial;
import enlightenment.world.parts.RayCounters;
import java.util.Arrays;

/**
 * Follows a shadow ray through glass that keeps its direction: thin slabs, interfaces between media of equal index of refraction, and faces
 * of solids inside a solid of higher priority. Paths pass the same surfaces by the same rules, so that BSDF sampling and next-event
 * estimation find the same light. One per thread, and only for scenes with such glass.
 */
public final class ShadowWalk {
    private final CompiledScene scene;
    private final PathFollower follower;
    private final Hit end = new Hit();
    private final boolean absorbs;

    /** The distance beyond the end of a ray to the eye within which a surface counts as being at the eye, and occludes it. */
    private double slack;

    public ShadowWalk(CompiledScene scene, RayCounters counters) {
        this.scene = scene;
        follower = new PathFollower(scene, counters, Integer.MAX_VALUE);
        absorbs = scene.physical.hasAbsorption;
    }

    /**
     * Whether nothing occludes the place where a camera ray starts. A surface at that place does, since camera rays hit it; the interface
     * of a solid does not: camera rays begin on one side of it.
     *
     * @param ray is changed
     * @param distance to that place, in the frame
     * @param error bound of the distance's error
     * @param path the path whose vertex the ray leaves, into the path's medium
     * @param isBehind whether the ray leaves into the medium behind a rough interface instead
     * @param through receives the transmittance, by band
     */
    public boolean reachesEye(
            Ray ray, double distance, double error, PathFollower path, boolean isBehind, double[] through) {
        slack = error;
        boolean reaches = reaches(null, ray, distance, path, isBehind, through);
        slack = 0;
        return reaches;
    }

    /**
     * Whether nothing occludes a point of a light.
     *
     * @param light that the ray goes to; null for a point on no surface
     * @param ray is changed
     * @param distance to the point, in the frame
     * @param path the path whose vertex the ray leaves, into the path's medium
     * @param isBehind whether the ray leaves into the medium behind a rough interface instead
     * @param through receives the transmittance, by band
     */
    public boolean reaches(
            PhysicalLight light, Ray ray, double distance, PathFollower path, boolean isBehind, double[] through) {
        follower.beginShadow(path, ray, isBehind);
        return reaches(light, ray, distance, through);
    }

    /** As {@link #reaches}, for a ray from a point of the path's flight through its medium, before the surface that it has hit since. */
    public boolean reachesFromTheWay(
            PhysicalLight light, Ray ray, double distance, PathFollower path, double[] through) {
        follower.beginShadowOnTheWay(path);
        return reaches(light, ray, distance, through);
    }

    private boolean reaches(PhysicalLight light, Ray ray, double distance, double[] through) {
        Arrays.fill(through, 1);
        boolean isPoint = light == null || light.isPoint;
        double left = distance;
        while (true) {
            SurfaceMaterial medium = absorbs ? follower.medium() : null;
            PathFollower.Event event = follower.next(ray);
            boolean isBeyond = event == PathFollower.Event.NOTHING || isPast(light, ray, left, event);
            double length = isBeyond ? Math.max(left, 0) : follower.distance(ray);
            if (medium != null && medium.absorbs) {
                medium.absorb(length, through);
            }
            if (isBeyond) {
                return isPoint || light.hidesNothingOfItself;
            }
            left -= length;
            if (event == PathFollower.Event.SURFACE || isPoint) {
                if (light != null && isOn(light, ray, left)) {
                    return true;
                }
            }
            if (event == PathFollower.Event.SURFACE || !follower.passStraight(ray, through)) {
                return false;
            }
        }
    }

    /**
     * Whether the ray has passed its end before its last event. At a light that holds only if nothing covers it there and the event is not
     * on the surface that it lies on. The ray need not hit the light, which may be small beside the rounding of directions.
     */
    private boolean isPast(PhysicalLight light, Ray ray, double left, PathFollower.Event event) {
        double distance = follower.distance(ray);
        if (light == null || light.isPoint) {
            return distance >= left + slack(event);
        }
        return distance >= left
                && light.hidesNothingOfItself
                && !isOn(light, ray, Math.abs(left - distance))
                && !light.lyingOn().isHiddenAtEnd(ray, ray.tMin + left / Math.sqrt(ray.dd), end);
    }

    private double slack(PathFollower.Event event) {
        boolean isInterface = event == PathFollower.Event.GLASS && scene.primitives[follower.at.id].isSolid();
        return event == PathFollower.Event.LIGHT || isInterface ? 0 : slack;
    }

    private boolean isOn(PhysicalLight light, Ray ray, double left) {
        return light.hidesNothingOfItself && light.id == follower.at.id && light.face == follower.at.hit.face
                || light.lyingOn().isEnd(ray, follower.at.id, follower.at.hit, left);
    }
}
