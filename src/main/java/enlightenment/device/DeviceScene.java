package enlightenment.device;

import enlightenment.scene.RenderSettings;
import enlightenment.world.CompiledScene;
import java.util.Optional;

/**
 * A compiled scene in three flat arrays, as devices take it. Each array begins with numbers at fixed places: where the rest
 * is, and what belongs to the scene as a whole.
 *
 * @param program what shades it
 * @param doubles begins with the {@link Number}s
 * @param ints begins with the {@link Int}s
 * @param floats boxes of hierarchies, vertices and texels
 */
public record DeviceScene(Program program, double[] doubles, int[] ints, float[] floats) {
    /** The code that follows the paths of a scene. */
    public enum Program {
        CLASSIC,
        PHYSICAL
    }

    /** What stands first among the integers: where records begin, how many there are, and limits. */
    enum Int {
        PRIMITIVES,
        MATERIALS,
        IMAGES,
        LIGHTS,
        LIGHT_COUNT,
        BOXES,
        SINGLE_BOXES,
        CHILDREN,
        SINGLE_CHILDREN,
        ORDER,
        SINGLE_ORDER,
        MESHES,
        UNION,
        MAX_BOUNCES,
        MAX_STRAIGHT,
        LIGHT_POINTS,
        GLASS_BOXES,
        GLASS_BOX_COUNT,
        HAS_CAUSTIC_PASS,
        HAS_MIRROR_BALLS,
        PICKER,
        PICKER_WEIGHTS,
        PICKER_TREE,
        LENS,
        LENS_CORNERS
    }

    /** What stands first among the numbers, one behind the other. */
    enum Number {
        AMBIENT(1),
        SHADOW(1),
        REACH(2),
        WIDTH(1),
        HEIGHT(1),
        BACKGROUND(3),
        CAMERA(19);

        private final int size;

        Number(int size) {
            this.size = size;
        }

        /** Where it begins. */
        int place() {
            int place = 0;
            for (int k = 0; k < ordinal(); k++) {
                place += values()[k].size;
            }
            return place;
        }
    }

    /** What its colour is. */
    enum Lookup {
        SOLID,
        CHECKER,
        NEAREST,
        BILINEAR
    }

    /** What a light is. */
    enum Form {
        BALL_LIGHT,
        RECTANGLE_LIGHT,
        POINT_LIGHT
    }

    /** Why no device can shade a scene, as the end of a sentence that begins with "it has"; empty if devices can. */
    public static Optional<String> refusal(CompiledScene scene) {
        return SceneRefusal.of(scene);
    }

    /** A scene that is not {@linkplain #refusal refused}. */
    public static DeviceScene of(CompiledScene scene, RenderSettings settings) {
        return new DeviceSceneWriter(scene, settings).write();
    }

    /** The bytes that it takes. */
    public long bytes() {
        return (long) Double.BYTES * doubles.length
                + (long) Integer.BYTES * ints.length
                + (long) Float.BYTES * floats.length;
    }
}
