package enlightenment.importer.support;

import enlightenment.camera.Camera;
import enlightenment.color.Rgb;
import enlightenment.geometry.Shape;
import enlightenment.light.Light;
import enlightenment.material.Material;
import enlightenment.scene.Animation;
import enlightenment.scene.SceneObject;
import enlightenment.scene.Shading;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.Set;

/**
 * A scene while it is read from a foreign format, with physical shading. What the file does not say is absent; who finishes the scene fills it in.
 */
public final class ImportDraft {
    private final ImportNotes notes = new ImportNotes();
    private final Map<String, Material> materials = new LinkedHashMap<>();
    private final List<Light> lights = new ArrayList<>();
    private final List<SceneObject> objects = new ArrayList<>();
    private final Set<String> names = new HashSet<>();

    /** By name that is taken: the first number behind it that may be free. */
    private final Map<String, Integer> numbers = new HashMap<>();

    private int width;
    private int height;
    private Camera camera;
    private Shading.Background background = new Shading.Background.Constant(Rgb.BLACK);
    private boolean hasBackground;
    private double exposure;
    private OptionalInt maxBounces = OptionalInt.empty();
    private Animation animation;
    private boolean upIsZ;
    private boolean leavesOutLights;

    /** Nothing yet. */
    public ImportDraft() {}

    /** What is left out or approximated. */
    public ImportNotes notes() {
        return notes;
    }

    /** Says how large the picture is, in pixels. */
    public void size(int w, int h) {
        width = w;
        height = h;
    }

    /** Says where the scene is seen from; the first one stays. */
    public void camera(Camera value) {
        if (camera == null) {
            camera = value;
        }
    }

    /** Says what shines from everywhere. */
    public void background(Shading.Background value) {
        background = value;
        hasBackground = true;
    }

    /** Says by how many stops the picture is made brighter. */
    public void exposure(double stops) {
        exposure = stops;
    }

    /** Says how often light may be scattered at most. */
    public void maxBounces(int value) {
        maxBounces = OptionalInt.of(value);
    }

    /** Sets how objects move. */
    public void animation(Animation value) {
        animation = value;
    }

    /** Says that in the file z points upwards: for the view of a model without a camera. */
    public void upIsZ() {
        upIsZ = true;
    }

    /** Keeps a material by its name; a later one of the same name replaces it. */
    public void material(String name, Material material) {
        materials.put(name, material);
    }

    /** Adds a light. */
    public void light(Light light) {
        lights.add(light);
    }

    /** Says that the file has a light that this renderer has not; what became of it instead, if anything, is a note. */
    public void leaveOutLight() {
        leavesOutLights = true;
    }

    /**
     * Adds an object.
     *
     * @param name what it is called in the file, or ""; a name that is taken gets a number behind it
     */
    public void object(String name, Shape shape, Material material) {
        objects.add(new SceneObject(unique(name), shape, material, List.of()));
    }

    /** A name that no object has had so far. */
    private String unique(String name) {
        if (name.isEmpty() || names.add(name)) {
            return name;
        }
        int n = numbers.getOrDefault(name, 2);
        while (!names.add(name + " " + n)) {
            n++;
        }
        numbers.put(name, n + 1);
        return name + " " + n;
    }

    /** The width in pixels, 0 if the file does not say. */
    public int width() {
        return width;
    }

    /** The height in pixels, 0 if the file does not say. */
    public int height() {
        return height;
    }

    /** The camera, if the file has one. */
    public Optional<Camera> camera() {
        return Optional.ofNullable(camera);
    }

    /** What shines from everywhere; black if the file does not say. */
    public Shading.Background background() {
        return background;
    }

    /** Whether something shines: a light, a background, or an object. */
    public boolean isLit() {
        return hasBackground || hasLights();
    }

    /** Whether a light or an object shines. */
    public boolean hasLights() {
        return !lights.isEmpty()
                || objects.stream().anyMatch(o -> !o.material().radiance().isBlack());
    }

    /** Whether lights of the file are left out. */
    public boolean leavesOutLights() {
        return leavesOutLights;
    }

    /** The exposure in stops. */
    public double exposure() {
        return exposure;
    }

    /** The largest number of bounces, if the file limits them. */
    public OptionalInt maxBounces() {
        return maxBounces;
    }

    /** How objects move, if they do. */
    public Optional<Animation> animation() {
        return Optional.ofNullable(animation);
    }

    /** Whether z points upwards in the file. */
    public boolean isUpZ() {
        return upIsZ;
    }

    /** The named materials, in their order. */
    public Map<String, Material> materials() {
        return materials;
    }

    /** The lights, in their order. */
    public List<Light> lights() {
        return lights;
    }

    /** The objects, in their order. */
    public List<SceneObject> objects() {
        return objects;
    }
}
