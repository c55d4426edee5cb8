package enlightenment.scene;

import enlightenment.camera.Camera;
import enlightenment.check.Check;
import enlightenment.geometry.Shape;
import enlightenment.light.Light;
import enlightenment.material.Material;
import enlightenment.material.Texture;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;

/**
 * Makes a {@link Scene} in code. Everything but the camera has a default: no objects, no lights, classic shading. Values
 * are checked by {@link #build}, not before; null is refused there. Not safe for use by several threads.
 */
public final class SceneBuilder {
    private String name = "";
    private int width = 800;
    private int height = 400;
    private Camera camera;
    private Shading shading = ClassicShading.DEFAULT;
    private Display display = Display.DEFAULT;
    private final Map<String, Texture> textures = new LinkedHashMap<>();
    private final Map<String, Material> materials = new LinkedHashMap<>();
    private final List<Light> lights = new ArrayList<>();
    private final List<SceneObject> objects = new ArrayList<>();
    private RenderDefaults render = RenderDefaults.DEFAULT;
    private Animation animation;

    SceneBuilder() {}

    /** What the scene is called; "" unless set. */
    public SceneBuilder name(String value) {
        name = value;
        return this;
    }

    /** The picture's size in pixels, 1..{@link Scene#MAX_SIDE} each; 800 × 400 unless set. */
    public SceneBuilder size(int w, int h) {
        width = w;
        height = h;
        return this;
    }

    /** Where the scene is seen from; must be set. */
    public SceneBuilder camera(Camera value) {
        camera = value;
        return this;
    }

    /** How surfaces are shaded; {@link ClassicShading#DEFAULT} unless set. */
    public SceneBuilder shading(Shading value) {
        shading = value;
        return this;
    }

    /** How the light of physical shading becomes a picture for a screen; {@link Display#DEFAULT} unless set. */
    public SceneBuilder display(Display value) {
        display = value;
        return this;
    }

    /**
     * Gives a texture a name, by which a scene file calls it; a texture with the same name is replaced. Materials hold
     * their textures themselves.
     */
    public SceneBuilder texture(String key, Texture value) {
        textures.put(key, value);
        return this;
    }

    /**
     * Gives a material a name, by which a scene file calls it; a material with the same name is replaced. Objects hold
     * their materials themselves.
     */
    public SceneBuilder material(String key, Material value) {
        materials.put(key, value);
        return this;
    }

    /** Adds a light. */
    public SceneBuilder light(Light value) {
        lights.add(value);
        return this;
    }

    /** Adds an object without a name. */
    public SceneBuilder object(Shape shape, Material material) {
        return object(SceneObject.of(shape, material));
    }

    /** Adds an object; objects with names need different ones. */
    public SceneBuilder object(SceneObject value) {
        objects.add(value);
        return this;
    }

    /** The settings that the scene asks to be rendered with; {@link RenderDefaults#DEFAULT} unless set. */
    public SceneBuilder render(RenderDefaults value) {
        render = value;
        return this;
    }

    /** How the scene changes over its frames, or null (unless set) if it does not. */
    public SceneBuilder animation(Animation value) {
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
