package enlightenment.scene.json;

import enlightenment.scene.BuiltInMethod;
import java.util.ArrayList;
import java.util.List;

/**
 * Keys of all parts of the scene format. Kinds of shapes, materials, textures, lights and cameras are defined beside their readers. A test compares
 * these keys with the schema.
 */
final class Vocabulary {
    private Vocabulary() {}

    /** The parts of a scene with several kinds. */
    static List<Family<?>> families() {
        return List.of(
                Cameras.FAMILY, Shapes.FAMILY, Materials.FAMILY, Lights.FAMILY, Textures.FAMILY, Backgrounds.FAMILY);
    }

    /** All parts of the format, without the settings of method extensions. */
    static List<Keys> all() {
        Keys render = RenderPart.keys(BuiltInMethod.ALL);
        List<Keys> all = new ArrayList<>(List.of(
                PartKeys.SCENE,
                PartKeys.IMAGE,
                PartKeys.CLASSIC_SHADING,
                PartKeys.PHYSICAL_SHADING,
                PartKeys.MEDIUM,
                PartKeys.LENS,
                PartKeys.DISPLAY,
                PartKeys.LINEAR_COLOR,
                render,
                PartKeys.ANIMATION,
                PartKeys.TRACK,
                PartKeys.TEXTURE_REFERENCE,
                PartKeys.AMOUNT_REFERENCE,
                Meshes.NAMED,
                Groups.OBJECT));
        all.addAll(Transforms.ALL);
        families().forEach(family -> all.addAll(family.keys()));
        return all;
    }
}
