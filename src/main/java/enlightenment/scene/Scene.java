package enlightenment.scene;

import enlightenment.camera.Camera;
import enlightenment.check.Check;
import enlightenment.light.Light;
import enlightenment.material.Material;
import enlightenment.material.Texture;
import enlightenment.math.InvalidValueException;
import java.util.Collections;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.Set;

/**
 * A whole scene: plain, immutable data, independent of how it is stored or rendered.
 *
 * @param name what the scene is called, or ""
 * @param width the picture's width in pixels, at least 1
 * @param height the picture's height in pixels, at least 1
 * @param camera where it is seen from
 * @param shading how surfaces are shaded
 * @param textures named textures, in order
 * @param materials named materials, in order
 * @param lights the lights
 * @param objects the things
 * @param render the settings it asks for
 * @param animation how it changes over frames, if it does
 */
public record Scene(
        String name,
        int width,
        int height,
        Camera camera,
        ClassicShading shading,
        Map<String, Texture> textures,
        Map<String, Material> materials,
        List<Light> lights,
        List<SceneObject> objects,
        RenderDefaults render,
        Optional<Animation> animation) {

    /** The largest width or height that a picture may have. */
    public static final int MAX_SIDE = 65_536;

    public Scene {
        Objects.requireNonNull(name, "name");
        checkSize(width, height);
        Objects.requireNonNull(camera, "camera");
        Objects.requireNonNull(shading, "shading");
        textures = Collections.unmodifiableMap(new LinkedHashMap<>(textures));
        materials = Collections.unmodifiableMap(new LinkedHashMap<>(materials));
        lights = List.copyOf(lights);
        objects = List.copyOf(objects);
        Objects.requireNonNull(render, "render");
        Objects.requireNonNull(animation, "animation");
        Set<String> names = new HashSet<>();
        for (int i = 0; i < objects.size(); i++) {
            String n = objects.get(i).name();
            if (!n.isEmpty() && !names.add(n)) {
                throw new InvalidValueException("objects/" + i + "/name", "\"" + n + "\" is used twice");
            }
        }
    }

    /** Starts a scene in code; see {@link SceneBuilder}. */
    public static SceneBuilder builder() {
        return new SceneBuilder();
    }

    /** The scene as it stands, without what changes it over frames. */
    public Scene withoutAnimation() {
        return new Scene(
                name, width, height, camera, shading, textures, materials, lights, objects, render, Optional.empty());
    }

    /** Refuses a picture size that no picture can have. */
    public static void checkSize(int width, int height) {
        Check.that(
                width >= 1 && width <= MAX_SIDE,
                "image/width",
                "must be a whole number in 1.." + MAX_SIDE + ", not " + width);
        Check.that(
                height >= 1 && height <= MAX_SIDE,
                "image/height",
                "must be a whole number in 1.." + MAX_SIDE + ", not " + height);
    }
}
