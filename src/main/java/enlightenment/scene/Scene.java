package enlightenment.scene;

import enlightenment.camera.Camera;
import enlightenment.check.Check;
import enlightenment.color.DisplayCurve;
import enlightenment.geometry.Mesh;
import enlightenment.geometry.Shape;
import enlightenment.light.Light;
import enlightenment.material.Material;
import enlightenment.material.Texture;
import enlightenment.math.InvalidValueException;
import enlightenment.mesh.TriangleMesh;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collections;
import java.util.HashSet;
import java.util.IdentityHashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.Set;

/**
 * A whole scene: camera, lights, and objects with their materials, as plain, immutable data. It does not depend on how it is stored or rendered.
 *
 * <p>Lengths and positions are in scene units, angles in degrees. Lists and maps are copied and cannot be changed.
 *
 * @param name what the scene is called, or ""
 * @param width the picture's width in pixels, 1..{@link #MAX_SIDE}
 * @param height the picture's height in pixels, 1..{@link #MAX_SIDE}
 * @param camera where it is seen from
 * @param shading how surfaces are shaded
 * @param display how light becomes a picture for a screen; for physical shading
 * @param textures named textures, in order; those that materials hold need no name
 * @param materials named materials, in order; those that objects hold need no name
 * @param lights the lights, in order; the picture does not depend on it
 * @param objects the objects, in order; the picture does not depend on it. Names differ. A scene may have millions, so the list
 *     makes its elements when they are asked for: they are equal each time, not the same
 * @param render the settings it asks to be rendered with
 * @param animation how it changes over frames, if it does
 * @param instants the scene at the moments while the shutter is open, evenly spaced, of which its picture is the mean; empty if nothing
 *     moves meanwhile: then it is the scene itself. They have no instants themselves, and what is chosen for the picture (size, display,
 *     settings) is the scene's own
 */
public record Scene(
        String name,
        int width,
        int height,
        Camera camera,
        Shading shading,
        Display display,
        Map<String, Texture> textures,
        Map<String, Material> materials,
        List<Light> lights,
        List<SceneObject> objects,
        RenderSettings.Defaults render,
        Optional<Animation> animation,
        List<Scene> instants) {

    /** The largest width or height that a picture may have. */
    public static final int MAX_SIDE = 65_536;

    /**
     * Checks what can be checked without rendering.
     *
     * @throws InvalidValueException if the size is out of range, two objects have the same name, or an object's material has no
     *     meaning in the scene's shading; its key is the place
     * @throws NullPointerException if something is missing, be it one entry of a list or the name of a texture or a material; the
     *     message says what
     */
    public Scene {
        Objects.requireNonNull(name, "name");
        checkSize(width, height);
        Objects.requireNonNull(camera, "camera");
        Objects.requireNonNull(shading, "shading");
        Objects.requireNonNull(display, "display");
        textures = named("textures", "texture", textures);
        materials = named("materials", "material", materials);
        lights = Present.list("lights", "light", lights);
        objects = ObjectList.copyOf(objects);
        Objects.requireNonNull(render, "render");
        Objects.requireNonNull(animation, "animation");
        instants = Present.list("instants", "instant", instants);
        for (Scene instant : instants) {
            Check.that(
                    instant.instants.isEmpty() && instant.shading.model() == shading.model(),
                    "instants",
                    "must have the shading of the scene, and no instants themselves");
        }
        ShadingFit fit = new ShadingFit(shading, materials);
        Set<String> names = new HashSet<>();
        for (int i = 0; i < objects.size(); i++) {
            SceneObject object = objects.get(i);
            fit.look(object, i);
            String n = object.name();
            if (!n.isEmpty() && !names.add(n)) {
                throw new InvalidValueException("objects/" + i + "/name", "\"" + n + "\" is used twice");
            }
        }
        fit.throwIfAny();
        fit.requireTogether();
        fit.require(camera);
        for (int i = 0; i < lights.size(); i++) {
            fit.require(lights.get(i), i);
        }
    }

    private static <T> Map<String, T> named(String key, String what, Map<String, T> values) {
        Objects.requireNonNull(values, key);
        values.forEach((name, value) -> {
            Objects.requireNonNull(name, () -> "the name of a " + what);
            Objects.requireNonNull(value, () -> "the " + what + " \"" + name + "\"");
        });
        return Collections.unmodifiableMap(new LinkedHashMap<>(values));
    }

    /** A scene in which nothing moves while the shutter is open. */
    public Scene(
            String name,
            int width,
            int height,
            Camera camera,
            Shading shading,
            Display display,
            Map<String, Texture> textures,
            Map<String, Material> materials,
            List<Light> lights,
            List<SceneObject> objects,
            RenderSettings.Defaults render,
            Optional<Animation> animation) {
        this(
                name, width, height, camera, shading, display, textures, materials, lights, objects, render, animation,
                List.of());
    }

    /** Starts a scene in code; see {@link Builder}. */
    public static Builder builder() {
        return new Builder();
    }

    /** The scene as it stands, without what changes it over frames. */
    public Scene withoutAnimation() {
        return new Scene(
                name,
                width,
                height,
                camera,
                shading,
                display,
                textures,
                materials,
                lights,
                objects,
                render,
                Optional.empty(),
                instants);
    }

    /** The meshes that objects place, each once, in the order of the objects. */
    public List<TriangleMesh> meshes() {
        Set<TriangleMesh> known = Collections.newSetFromMap(new IdentityHashMap<>());
        List<TriangleMesh> meshes = new ArrayList<>();
        for (SceneObject object : objects) {
            if (object.shape() instanceof Mesh mesh && known.add(mesh.triangles())) {
                meshes.add(mesh.triangles());
            }
        }
        return meshes;
    }

    /** The index of the first light whose intensities a file holds; −1 if there is none. */
    public int lightOf(Path file) {
        for (int i = 0; i < lights.size(); i++) {
            if (lights.get(i) instanceof Light.Ies light && light.file().equals(file)) {
                return i;
            }
        }
        return -1;
    }

    /** This scene, with pictures that are the mean over these moments. */
    public Scene withInstants(List<Scene> moments) {
        return new Scene(
                name, width, height, camera, shading, display, textures, materials, lights, objects, render, animation,
                moments);
    }

    /**
     * Checks a picture's size in pixels.
     *
     * @throws InvalidValueException if width or height are not in 1..{@link #MAX_SIDE}
     */
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

    /**
     * Makes a {@link Scene} in code. Everything but the camera has a default: no objects, no lights, classic shading. Values
     * are checked by {@link #build}, not before; null is refused there. Not safe for use by several threads.
     */
    public static final class Builder {
        private String name = "";
        private int width = 800;
        private int height = 400;
        private Camera camera;
        private Shading shading = Shading.Classic.DEFAULT;
        private Display display = Display.DEFAULT;
        private final Map<String, Texture> textures = new LinkedHashMap<>();
        private final Map<String, Material> materials = new LinkedHashMap<>();
        private final List<Light> lights = new ArrayList<>();
        private final List<SceneObject> objects = new ArrayList<>();
        private RenderSettings.Defaults render = RenderSettings.Defaults.DEFAULT;
        private Animation animation;

        Builder() {}

        /** The name of the scene; "" unless set. */
        public Builder name(String value) {
            name = value;
            return this;
        }

        /** The picture's size in pixels, 1..{@link Scene#MAX_SIDE} each; 800 × 400 unless set. */
        public Builder size(int w, int h) {
            width = w;
            height = h;
            return this;
        }

        /** The camera; must be set. */
        public Builder camera(Camera value) {
            camera = value;
            return this;
        }

        /** The shading; {@link Shading.Classic#DEFAULT} unless set. */
        public Builder shading(Shading value) {
            shading = value;
            return this;
        }

        /** The display of physical shading's light on a screen; {@link Display#DEFAULT} unless set. */
        public Builder display(Display value) {
            display = value;
            return this;
        }

        /**
         * Gives a texture a name, by which a scene file calls it; a texture with the same name is replaced. Materials hold
         * their textures themselves.
         */
        public Builder texture(String key, Texture value) {
            textures.put(key, value);
            return this;
        }

        /**
         * Gives a material a name, by which a scene file calls it; a material with the same name is replaced. Objects hold
         * their materials themselves.
         */
        public Builder material(String key, Material value) {
            materials.put(key, value);
            return this;
        }

        /** Adds a light. */
        public Builder light(Light value) {
            lights.add(value);
            return this;
        }

        /** Adds an object without a name. */
        public Builder object(Shape shape, Material material) {
            return object(SceneObject.of(shape, material));
        }

        /** Adds an object; objects with names need different ones. */
        public Builder object(SceneObject value) {
            objects.add(value);
            return this;
        }

        /** The settings that the scene asks to be rendered with; {@link RenderSettings.Defaults#DEFAULT} unless set. */
        public Builder render(RenderSettings.Defaults value) {
            render = value;
            return this;
        }

        /** The animation, or null (unless set) for none. */
        public Builder animation(Animation value) {
            animation = value;
            return this;
        }

        /**
         * The scene.
         *
         * @throws enlightenment.math.InvalidValueException if the camera is missing, the size is out of range or two objects
         *     have the same name; its key is the place
         * @throws NullPointerException if something else was set to null or added as null, or named null; the message says what
         */
        public Scene build() {
            Check.that(camera != null, "camera", "is missing; a scene needs it");
            return new Scene(
                    name,
                    width,
                    height,
                    camera,
                    shading,
                    display,
                    textures,
                    materials,
                    lights,
                    objects,
                    render,
                    Optional.ofNullable(animation));
        }
    }

    /**
     * How the linear light of physical shading becomes a picture for a screen: light times 2^exposure goes through the tone curve, then
     * through sRGB's transfer curve. Files of linear light do not ask for it, and classic shading, whose colours are those of a
     * screen, has no use for it.
     *
     * @param exposure in stops, -{@link #MAX_EXPOSURE}..{@link #MAX_EXPOSURE}: one more doubles the light
     * @param tone how light becomes 0..1
     */
    public record Display(double exposure, DisplayCurve.Tone tone) {
        /** The largest exposure, and with a minus the smallest one. */
        public static final double MAX_EXPOSURE = 1000;

        /** No change of exposure, light cut at 1. */
        public static final Display DEFAULT = new Display(0, DisplayCurve.Tone.CLIP);

        /**
         * Checks the range.
         *
         * @throws enlightenment.math.InvalidValueException (key {@code exposure}) if the exposure is out of it
         */
        public Display {
            Check.range("exposure", exposure, -MAX_EXPOSURE, MAX_EXPOSURE);
            Objects.requireNonNull(tone, "tone");
        }
    }
}
