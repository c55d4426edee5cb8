package enlightenment.physical;

import enlightenment.image.Image;
import enlightenment.scene.BuiltInMethod;
import enlightenment.scene.RenderSettings;
import enlightenment.scene.Scene;
import java.util.List;
import java.util.Map;
import java.util.concurrent.ConcurrentHashMap;

/** Path-traced reference pictures of a test class, rendered once per scene: the other methods are each compared with them. */
final class PathTracedReferences {
    /** Seeds of references must not be those of the pictures that are compared with them. */
    private static final int FIRST_SEED = 101;

    private final Map<String, List<Image>> rendered = new ConcurrentHashMap<>();
    private final int seeds;
    private final int antialias;

    /**
     * @param seeds pictures of each scene
     * @param antialias samples per pixel and axis
     */
    PathTracedReferences(int seeds, int antialias) {
        this.seeds = seeds;
        this.antialias = antialias;
    }

    /** @param name distinguishes the scene from the others of the test class */
    List<Image> of(String name, Scene scene) {
        RenderSettings settings =
                RenderSettings.of(scene).withMethod(BuiltInMethod.RAYTRACE).withAntialias(antialias);
        return rendered.computeIfAbsent(name, n -> Rendered.seeds(scene, settings, FIRST_SEED, seeds));
    }
}
