package enlightenment.shading;

import enlightenment.compiled.CompiledScene;
import enlightenment.compiled.PhysicalLight;
import enlightenment.compiled.RayCounters;
import enlightenment.compiled.SurfaceMaterial;
import enlightenment.primitive.Hit;
import enlightenment.primitive.Ray;
import java.util.Arrays;

/**
 * Follows a shadow ray through glass that does not turn it: panes, and borders between media of equal index of refraction. Paths pass the
 * same surfaces by the same rules, so both find the same light. One per thread, and only for scenes with such glass.
 */
final class ShadowWalk {
    private final PathFollower follower;
    private final Hit end = new Hit();
    private final boolean absorbs;

    ShadowWalk(CompiledScene scene, RayCounters counters) {
        follower = new PathFollower(scene, counters, Integer.MAX_VALUE);
        absorbs = scene.physical.hasAbsorption;
    }

    /**
     * Whether the ray comes to the light.
     *
     * @param light what it goes to; null for the eye
     * @param ray is changed
     * @param distance to the point of the light
     * @param path the path whose vertex it leaves, into the medium that the path is in
     * @param isBehind whether it leaves it into the medium behind a rough border instead
     * @param through receives what comes through of the light, by band
     */
    boolean reaches(
            PhysicalLight light, Ray ray, double distance, PathFollower path, boolean isBehind, double[] through) {
        follower.beginShadow(path, ray, isBehind);
        return reaches(light, ray, distance, through);
    }

    /** The same for a ray that leaves a point of the medium that a path is flying through, whatever that has come to. */
    boolean reachesFromTheWay(PhysicalLight light, Ray ray, double distance, PathFollower path, double[] through) {
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
            boolean isBeyond = event == PathFollower.Event.NOTHING
                    || follower.distance(ray) >= left && (isPoint || isPast(light, ray, left));
            double length = isBeyond ? left : follower.distance(ray);
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
     * Whether the ray, which met something no nearer than the point of a light, has passed that: nothing covers the light there, and it did
     * not meet what the light lies on. It need not meet the light: that may be small beside the rounding of directions.
     */
    private boolean isPast(PhysicalLight light, Ray ray, double left) {
        return light.hidesNothingOfItself
                && !isOn(light, ray, Math.abs(left - follower.distance(ray)))
                && !light.lyingOn().isHiddenAtEnd(ray, ray.tMin + left / Math.sqrt(ray.dd), end);
    }

    private boolean isOn(PhysicalLight light, Ray ray, double left) {
        return light.hidesNothingOfItself && light.id == follower.id && light.face == follower.hit.face
                || light.lyingOn().isEnd(ray, follower.id, follower.hit, left);
    }
}
