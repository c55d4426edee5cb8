package enlightenment.scene.json;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/** The words of the scene format: which keys each part has. The schema says the same; a test holds the two together. */
final class Vocabulary {
    private Vocabulary() {}

    /**
     * The keys of one part.
     *
     * @param schemaName the part's name in the schema's {@code $defs}
     * @param noun what messages call it
     * @param required keys that must be there
     * @param optional keys that may be there
     */
    record Keys(String schemaName, String noun, List<String> required, List<String> optional) {
        List<String> all() {
            List<String> all = new ArrayList<>(required);
            all.addAll(optional);
            return all;
        }

        boolean has(String key) {
            return required.contains(key) || optional.contains(key);
        }
    }

    static final Keys SCENE = keys(
            "scene",
            "a scene",
            "image camera objects",
            "$schema name shading textures materials lights render animation");
    static final Keys IMAGE = keys("image", "an image", "width height", "");
    static final Keys SHADING = keys("shading", "the shading", "", "model ambient shadow background maxBounces");
    static final Keys RENDER = keys("render", "the render part", "", "method antialias shadowSamples seed");
    static final Keys ANIMATION = keys("animation", "an animation", "frames framesPerSecond tracks", "");
    static final Keys TRACK = keys("track", "a track", "target keys", "");
    static final Keys TEXTURE_REFERENCE = keys("textureReference", "a reference to a texture", "texture", "");

    static final Map<String, Keys> CAMERAS = types(
            "Camera",
            " camera",
            "window: eye lowerLeft upperLeft upperRight lowerRight | pupilRadius",
            "perspective: eye lookAt fieldOfView | up",
            "orthographic: eye lookAt height | up",
            "isometric: lookAt height |");

    static final Map<String, Keys> OBJECTS = types(
            "Object",
            "",
            "sphere: center radius material | rotation name",
            "rectangle: corners material | name",
            "disk: center normal radius material | name",
            "cylinder: base top radius material | capped name",
            "cone: base apex radius material | topRadius capped name",
            // A cube's material may be missing where it has faces.
            "cube: center radius | rotation faces material name",
            "box: min max material | name",
            "torus: center axis majorRadius minorRadius material | name",
            "triangle: vertices material | name");

    static final Map<String, Keys> MATERIALS = types(
            "Material",
            " material",
            "matte: color | receivesShadows",
            "mirror: color | receivesShadows",
            "glass: color indexOfRefraction | transparency priority receivesShadows");

    static final Map<String, Keys> LIGHTS = types(
            "Light",
            " light",
            "sphere: center radius color |",
            "rectangle: corners color |",
            "point: position color |");

    /** The type may be missing from a texture that is a file. */
    static final Map<String, Keys> TEXTURES =
            types("Texture", " texture", "file: file | filter encoding", "checker: colors scale |", "color: color |");

    /** Types of objects that the format will have. */
    static final List<String> PLANNED_OBJECTS = List.of("mesh");

    /** Types of materials that the format will have. */
    static final List<String> PLANNED_MATERIALS = List.of("glossy", "scattering", "fluorescent");

    /** Keys of lights that only physical shading will look at. */
    static final List<String> PLANNED_LIGHT_KEYS = List.of("radiance", "power", "intensity");

    /** Keys of the shading that only physical shading will look at. */
    static final List<String> PLANNED_SHADING_KEYS = List.of("maxBounces");

    static final List<String> SHADING_MODELS = List.of("classic");
    static final List<String> PLANNED_SHADING_MODELS = List.of("physical");
    static final List<String> FILTERS = List.of("nearest", "bilinear");
    static final List<String> ENCODINGS = List.of("srgb", "linear");

    /** Every part of the format. */
    static List<Keys> all() {
        List<Keys> all = new ArrayList<>(List.of(SCENE, IMAGE, SHADING, RENDER, ANIMATION, TRACK, TEXTURE_REFERENCE));
        for (Map<String, Keys> family : List.of(CAMERAS, OBJECTS, MATERIALS, LIGHTS, TEXTURES)) {
            all.addAll(family.values());
        }
        return all;
    }

    private static Keys keys(String schemaName, String noun, String required, String optional) {
        return new Keys(schemaName, noun, words(required), words(optional));
    }

    /** Each line: the type's name, the keys that must be there, a bar, the keys that may be there. */
    private static Map<String, Keys> types(String suffix, String nounSuffix, String... lines) {
        Map<String, Keys> types = new LinkedHashMap<>();
        for (String line : lines) {
            String type = line.substring(0, line.indexOf(':'));
            String required = line.substring(line.indexOf(':') + 1, line.indexOf('|'));
            String optional = line.substring(line.indexOf('|') + 1);
            boolean typeRequired = !type.equals("file");
            String article = type.startsWith("i") || type.startsWith("o") ? "an " : "a ";
            types.put(
                    type,
                    keys(
                            type + suffix,
                            article + type + nounSuffix,
                            (typeRequired ? "type " : "") + required,
                            (typeRequired ? "" : "type ") + optional));
        }
        return Collections.unmodifiableMap(types);
    }

    private static List<String> words(String text) {
        return text.isBlank() ? List.of() : Arrays.asList(text.trim().split("\\s+"));
    }
}
