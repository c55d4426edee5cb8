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

/** The size of a scene relative to its smallest object: physical shading has densities per area, whose squares must be representable. */
public final class SceneExtent {
    /**
     * Binary logarithm of the least relative size of an object. 2^-400 is promised (docs/notes/numerics.md); below this, MIS weights and
     * projections underflow.
     */
    private static final int LEAST = -440;

    private SceneExtent() {}

    /**
     * The largest absolute coordinate of a description, in the frame.
     *
     * @param anchors its points, exact
     * @param reach its extent beyond them, in scene units
     */
    public static double of(List<ExactPoint> anchors, double reach, SceneFrame frame) {
        double largest = 0;
        for (ExactPoint p : anchors) {
            largest = Math.max(largest, frame.toFrame(p).maxAbs());
        }
        return largest + frame.toFrame(reach);
    }

    /** The extent, in the frame, of the smallest object that rounding in the frame leaves larger than a point; at most 1. */
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
     * @throws SceneException at the place of the most distant object
     */
    public static void check(Scene scene, SceneFrame frame, Primitive[] primitives) {
        int exponent = Scale.exponent(least(primitives));
        if (exponent < LEAST) {
            throw SceneException.of(
                    farthest(scene, frame),
                    "is about 1e" + Math.round(-exponent * StrictMath.log10(2))
                            + " times as far from the eye as the smallest object near it is large; physical shading is computed up to 1e120");
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
