package enlightenment.scene.json;

import enlightenment.scene.BuiltInMethod;
import java.util.ArrayList;
import java.util.List;

/**
 * The words of the scene format, but for the kinds of shapes, materials, textures, lights and cameras, which stand where
 * these are read and written. The schema says the same; a test holds the two together.
 */
final class Vocabulary {
    static final Keys SCENE = Keys.of(
            "scene",
            "a scene",
            "image camera objects",
            "$schema name shading display meshes textures materials groups lights render animation");
    static final Keys IMAGE = Keys.of("image", "an image", "width height", "");
    static final Keys CLASSIC_SHADING =
            Keys.of("classicShading", "the shading", "", "model ambient shadow background maxBounces");
    static final Keys PHYSICAL_SHADING =
            Keys.of("physicalShading", "physical shading", "model", "background medium maxBounces");
    static final Keys MEDIUM = Keys.of(
            "medium", "a medium", "", "color meanFreePath scatteringCoefficient absorptionCoefficient anisotropy");
    static final Keys DISPLAY = Keys.of("display", "the display part", "", "exposure tone");
    static final Keys LINEAR_COLOR = Keys.of("linearColor", "a linear colour", "linear", "");
    static final Keys ANIMATION =
            Keys.of("animation", "an animation", "frames framesPerSecond tracks", "shutter instants");
    static final Keys TRACK = Keys.of("track", "a track", "target keys", "easing");
    static final Keys TEXTURE_REFERENCE = Keys.of("textureReference", "a reference to a texture", "texture", "");

    private Vocabulary() {}

    /** All parts that come in several kinds. */
    static List<Family<?>> families() {
        return List.of(
                Cameras.FAMILY, Shapes.FAMILY, Materials.FAMILY, Lights.FAMILY, Textures.FAMILY, Backgrounds.FAMILY);
    }

    /** Every part of the format, without what methods from outside add to it. */
    static List<Keys> all() {
        Keys render = RenderPart.keys(BuiltInMethod.ALL);
        List<Keys> all = new ArrayList<>(List.of(
                SCENE,
                IMAGE,
                CLASSIC_SHADING,
                PHYSICAL_SHADING,
                MEDIUM,
                DISPLAY,
                LINEAR_COLOR,
                render,
                ANIMATION,
                TRACK,
                TEXTURE_REFERENCE,
                Meshes.NAMED,
                Groups.OBJECT));
        all.addAll(Transforms.ALL);
        families().forEach(family -> all.addAll(family.keys()));
        return all;
    }
}
