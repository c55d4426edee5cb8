package enlightenment.compiled;

import enlightenment.math.Vec3;
import enlightenment.numeric.Scale;
import enlightenment.primitive.Primitive;
import enlightenment.primitive.Ray;
import enlightenment.scene.Scene;
import java.util.List;

/**
 * Tells where a view is so narrow that doubles cannot tell the directions of neighbouring pixels apart: what is more than about
 * 1e14 times its size away is then seen askew, or lost. Along a coordinate axis there is no limit of the kind, because there
 * the small components of a direction are exact however small they are.
 */
final class DistanceHint {
    /** Rounding may displace what is seen by this part of a pixel's height before it is worth a word. */
    private static final double PART_OF_A_PIXEL = 1.0 / 16;

    private DistanceHint() {}

    static List<String> of(Scene scene, CompiledScene compiled) {
        Ray middle = new Ray();
        Ray next = new Ray();
        compiled.camera.ray(0.5, 0.5, middle);
        compiled.camera.ray(0.5, 0.5 + 1.0 / scene.height(), next);
        Vec3 direction = new Vec3(middle.dx, middle.dy, middle.dz);
        Vec3 turn = new Vec3(next.dx, next.dy, next.dz).minus(direction);
        Vec3 shift = new Vec3(next.ox, next.oy, next.oz).minus(new Vec3(middle.ox, middle.oy, middle.oz));
        // Rays that meet in the eye part in proportion to the distance, as rounding does; parallel ones do not.
        double step = turn.maxAbs() > 0 ? turn.length() / direction.length() : shift.length() / farthest(compiled);
        // No direction at all is left of a window that is nothing beside the scene.
        if (direction.maxAbs() > 0 && !(askew(direction) > PART_OF_A_PIXEL * step)) {
            return List.of();
        }
        return List.of("/camera: beside the distance of what is seen, the view is so narrow that numbers cannot tell"
                + " neighbouring pixels apart; what is farther than 1e14 times its size is seen askew or lost, unless the camera"
                + " looks along a coordinate axis: move it closer");
    }

    private static double farthest(CompiledScene compiled) {
        double distance = 0;
        for (Primitive p : compiled.primitives) {
            distance = Math.max(distance, p.bounds().center().length());
        }
        return distance;
    }

    /** By how much rounding to a double may turn a direction: what is rounded along it does not. */
    private static double askew(Vec3 direction) {
        Vec3 d = direction.normalized();
        double most = 0;
        for (int k = 0; k < 3; k++) {
            double p = d.component((k + 1) % 3);
            double q = d.component((k + 2) % 3);
            double across = Math.sqrt(p * p + q * q);
            most = Math.max(most, Math.abs(d.component(k)) * across);
        }
        return Scale.UNIT_ROUNDOFF * most;
    }
}
