package enlightenment.transport.ray;

import enlightenment.primitive.Hit;
import enlightenment.primitive.Ray;
import enlightenment.world.CompiledScene;
import enlightenment.world.light.PhysicalLight;
import enlightenment.world.material.SurfaceMaterial;
import enlightenment.world.parts.RayCounters;
import java.util.Arrays;

/**
 * Follows a shadow ray through glass that does not turn it: panes, borders between media of equal index of refraction, and faces of solids
 * where another solid fills the place. Paths pass the same surfaces by the same rules, so both find the same light. One per thread, and
 * only for scenes with such glass.
 */
public final class ShadowWalk {
    private final CompiledScene scene;
    private final PathFollower follower;
    private final Hit end = new Hit();
    private final boolean absorbs;

    /** How far beyond the end of a ray to the eye something may be that is taken to lie there, and hides it. */
    private double slack;

    public ShadowWalk(CompiledScene scene, RayCounters counters) {
        this.scene = scene;
        follower = new PathFollower(scene, counters, Integer.MAX_VALUE);
        absorbs = scene.physical.hasAbsorption;
    }

    /**
     * Whether the ray comes to the place where a camera ray starts. What lies there is before the eye, since camera rays meet it; the border
     * of a solid is not: they begin on one side of it.
     *
     * @param ray is changed
     * @param distance to that place
     * @param error the distance's
     * @param path the path whose vertex it leaves, into the medium that the path is in
     * @param isBehind whether it leaves it into the medium behind a rough border instead
     * @param through receives what comes through of the light, by band
     */
    public boolean reachesEye(
            Ray ray, double distance, double error, PathFollower path, boolean isBehind, double[] through) {
        slack = error;
        boolean reaches = reaches(null, ray, distance, path, isBehind, through);
        slack = 0;
        return reaches;
    }

    /**
     * Whether the ray comes to the light.
     *
     * @param light what it goes to; null for a place where nothing is
     * @param ray is changed
     * @param distance to the point of the light
     * @param path the path whose vertex it leaves, into the medium that the path is in
     * @param isBehind whether it leaves it into the medium behind a rough border instead
     * @param through receives what comes through of the light, by band
     */
    public boolean reaches(
            PhysicalLight light, Ray ray, double distance, PathFollower path, boolean isBehind, double[] through) {
        follower.beginShadow(path, ray, isBehind);
        return reaches(light, ray, distance, through);
    }

    /** The same for a ray that leaves a point of the medium that a path is flying through, whatever that has come to. */
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
     * Whether the ray, which met something, has passed its end before. At a light nothing covers that then, and it did not meet what the
     * light lies on. It need not meet the light: that may be small beside the rounding of directions.
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
        boolean isBorder = event == PathFollower.Event.GLASS && scene.primitives[follower.at.id].isSolid();
        return event == PathFollower.Event.LIGHT || isBorder ? 0 : slack;
    }

    private boolean isOn(PhysicalLight light, Ray ray, double left) {
        return light.hidesNothingOfItself && light.id == follower.at.id && light.face == follower.at.hit.face
                || light.lyingOn().isEnd(ray, follower.at.id, follower.at.hit, left);
    }
}
