package enlightenment.world.parts;

import enlightenment.frame.SceneFrame;
import enlightenment.light.Light;
import enlightenment.math.ExactPoint;
import enlightenment.numeric.Scale;
import enlightenment.primitive.Primitive;
import enlightenment.scene.Scene;
import enlightenment.scene.SceneException;
import enlightenment.scene.SceneObject;
import java.util.List;

/** How large a scene is beside the smallest of its things: physical light has densities per area, and they have squares. */
public final class SceneExtent {
    /** Promised is 2^400 (docs/notes/numerics.md); what is smaller than this beside the scene, weights and projections cannot hold. */
    private static final int LEAST = -440;

    private SceneExtent() {}

    /**
     * The largest absolute coordinate of a description.
     *
     * @param anchors its points, exact
     * @param reach how far it extends beyond them, in scene units
     * @return in the units of the frame
     */
    public static double of(List<ExactPoint> anchors, double reach, SceneFrame frame) {
        double largest = 0;
        for (ExactPoint p : anchors) {
            largest = Math.max(largest, frame.toFrame(p).maxAbs());
        }
        return largest + frame.toFrame(reach);
    }

    /** The extent, in the frame, of the smallest thing that is more than a point beside its distance from the eye; at most 1. */
    public static double least(Primitive[] primitives) {
        double least = 1;
        for (Primitive p : primitives) {
            double extent = p.bounds().extent().maxAbs();
            least = extent > 0 ? Math.min(least, extent) : least;
        }
        return least;
    }

    /**
     * Refuses scenes whose light would be lost or infinite by underflow.
     *
     * @throws SceneException at the place of what is farthest away
     */
    public static void check(Scene scene, SceneFrame frame, Primitive[] primitives) {
        int exponent = Scale.exponent(least(primitives));
        if (exponent < LEAST) {
            throw SceneException.of(
                    farthest(scene, frame),
                    "is about 1e" + Math.round(-exponent * StrictMath.log10(2))
                            + " times as far from the eye as the smallest thing near it is large; physical shading is computed up to 1e120");
        }
    }

    private static String farthest(Scene scene, SceneFrame frame) {
        String place = "/camera";
        double largest = of(scene.camera().anchors(), 0, frame);
        for (int i = 0; i < scene.lights().size(); i++) {
            Light light = scene.lights().get(i);
            double extent = of(light.anchors(), light.reach(), frame);
            if (extent > largest) {
                largest = extent;
                place = "/lights/" + i;
            }
        }
        for (int i = 0; i < scene.objects().size(); i++) {
            SceneObject object = scene.objects().get(i);
            double extent = of(object.shape().anchors(), object.shape().reach(), frame);
            if (extent > largest) {
                largest = extent;
                place = "/objects/" + i;
            }
        }
        return place;
    }
}
