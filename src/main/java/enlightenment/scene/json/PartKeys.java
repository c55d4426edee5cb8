package enlightenment.scene.json;

/** Keys of parts with a single kind; those of shapes, materials and others are beside their readers. */
final class PartKeys {
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
    static final Keys LENS = Keys.of("lens", "a lens", "radius focusDistance", "blades rotation");
    static final Keys DISPLAY = Keys.of("display", "the display part", "", "exposure tone");
    static final Keys LINEAR_COLOR = Keys.of("linearColor", "a linear colour", "linear", "");
    static final Keys ANIMATION =
            Keys.of("animation", "an animation", "frames framesPerSecond tracks", "shutter instants");
    static final Keys TRACK = Keys.of("track", "a track", "target keys", "easing");
    static final Keys TEXTURE_REFERENCE = Keys.of("textureReference", "a reference to a texture", "texture", "");
    static final Keys AMOUNT_REFERENCE =
            Keys.of("amountReference", "a reference to the numbers of a texture", "texture", "channel factor");

    private PartKeys() {}
}
