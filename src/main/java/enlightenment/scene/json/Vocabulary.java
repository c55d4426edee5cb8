package enlightenment.scene.json;

import enlightenment.scene.BuiltInMethod;
import java.util.ArrayList;
import java.util.List;

/**
 * The words of the scene format, but for the kinds of shapes, materials, textures, lights and cameras, which stand where
 * these are read and written. The schema says the same; a test holds the two together.
 */
final class Vocabulary {
    private Vocabulary() {}

    /** All parts of a scene that come in several kinds. */
    static List<Family<?>> families() {
        return List.of(
                Cameras.FAMILY, Shapes.FAMILY, Materials.FAMILY, Lights.FAMILY, Textures.FAMILY, Backgrounds.FAMILY);
    }

    /** Every part of the format, without what methods from outside add to it. */
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
