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

/** Makes a {@link Scene} in code. Everything but the camera has a default. Not safe for use by several threads. */
public final class SceneBuilder {
    private String name = "";
    private int width = 800;
    private int height = 400;
    private Camera camera;
    private ClassicShading shading = ClassicShading.DEFAULT;
    private final Map<String, Texture> textures = new LinkedHashMap<>();
    private final Map<String, Material> materials = new LinkedHashMap<>();
    private final List<Light> lights = new ArrayList<>();
    private final List<SceneObject> objects = new ArrayList<>();
    private RenderDefaults render = RenderDefaults.DEFAULT;
    private Animation animation;

    SceneBuilder() {}

    public SceneBuilder name(String value) {
        name = value;
        return this;
    }

    /** The picture's size in pixels; 800 × 400 unless set. */
    public SceneBuilder size(int w, int h) {
        width = w;
        height = h;
        return this;
    }

    public SceneBuilder camera(Camera value) {
        camera = value;
        return this;
    }

    public SceneBuilder shading(ClassicShading value) {
        shading = value;
        return this;
    }

    public SceneBuilder texture(String key, Texture value) {
        textures.put(key, value);
        return this;
    }

    public SceneBuilder material(String key, Material value) {
        materials.put(key, value);
        return this;
    }

    public SceneBuilder light(Light value) {
        lights.add(value);
        return this;
    }

    public SceneBuilder object(Shape shape, Material material) {
        return object(SceneObject.of(shape, material));
    }

    public SceneBuilder object(SceneObject value) {
        objects.add(value);
        return this;
    }

    public SceneBuilder render(RenderDefaults value) {
        render = value;
        return this;
    }

    public SceneBuilder animation(Animation value) {
        animation = value;
        return this;
    }

    /** The scene; fails where the camera is missing or a value is out of range. */
    public Scene build() {
        Check.that(camera != null, "camera", "is missing; a scene needs it");
        return new Scene(
                name,
                width,
                height,
                camera,
                shading,
                textures,
                materials,
                lights,
                objects,
                render,
                Optional.ofNullable(animation));
    }
}
