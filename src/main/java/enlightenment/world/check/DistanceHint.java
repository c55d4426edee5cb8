package enlightenment.world.check;

import enlightenment.math.Vec3;
import enlightenment.numeric.Scale;
import enlightenment.primitive.Primitive;
import enlightenment.primitive.Ray;
import enlightenment.scene.Scene;
import enlightenment.world.CompiledScene;
import java.util.List;

/**
 * A hint for a view so narrow that doubles cannot distinguish the directions of neighbouring pixels: objects farther away than
 * about 1e14 times their size are then distorted or lost. Along a coordinate axis there is no such limit, because the small
 * components of a direction are exact there however small they are.
 */
final class DistanceHint {
    /** Rounding that displaces the picture by less than this part of a pixel's height gets no hint. */
    private static final double NEGLIGIBLE = 1.0 / 16;

    private DistanceHint() {}

    static List<String> of(Scene scene, CompiledScene compiled) {
        Ray middle = new Ray();
        Ray next = new Ray();
        compiled.camera.ray(0.5, 0.5, middle);
        compiled.camera.ray(0.5, 0.5 + 1.0 / scene.height(), next);
        Vec3 direction = new Vec3(middle.dx, middle.dy, middle.dz);
        Vec3 turn = new Vec3(next.dx, next.dy, next.dz).minus(direction);
        Vec3 shift = new Vec3(next.ox, next.oy, next.oz).minus(new Vec3(middle.ox, middle.oy, middle.oz));
        // Rays from one eye diverge in proportion to the distance, as rounding errors do; parallel rays do not.
        double step = turn.maxAbs() > 0 ? turn.length() / direction.length() : shift.length() / farthest(compiled);
        // A window that is tiny beside the scene may round to no direction at all.
        if (direction.maxAbs() > 0 && !(directionError(direction) > NEGLIGIBLE * step)) {
            return List.of();
        }
        return List.of(
                "/camera: the view is so narrow, for the distance of what it shows, that doubles cannot distinguish"
                        + " neighbouring pixels; objects farther away than 1e14 times their size are distorted or lost, unless the"
                        + " camera looks along a coordinate axis: move it closer");
    }

    private static double farthest(CompiledScene compiled) {
        double distance = 0;
        for (Primitive p : compiled.primitives) {
            distance = Math.max(distance, p.bounds().center().length());
        }
        return distance;
    }

    /** The largest angle by which rounding its components may turn a direction: errors along it do not turn it. */
    private static double directionError(Vec3 direction) {
        Vec3 d = direction.normalized();
        double largest = 0;
        for (int k = 0; k < 3; k++) {
            double p = d.component((k + 1) % 3);
            double q = d.component((k + 2) % 3);
            double across = Math.sqrt(p * p + q * q);
            largest = Math.max(largest, Math.abs(d.component(k)) * across);
        }
        return Scale.UNIT_ROUNDOFF * largest;
    }
}
