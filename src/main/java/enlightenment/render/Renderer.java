package enlightenment.render;

import enlightenment.image.Image;
import enlightenment.scene.RenderSettings;
import enlightenment.scene.Scene;
import java.util.List;
import java.util.function.BooleanSupplier;

/**
 * Makes pictures of scenes.
 *
 * <p>The picture is a pure function of the scene and of those settings that say they influence it: the same bytes on any
 * number of threads, on any machine.
 */
public final class Renderer {
    private Renderer() {}

    /** Renders the scene. Fails with {@link enlightenment.scene.SceneException} where the scene cannot be used. */
    public static Image render(Scene scene, RenderSettings settings) {
        return render(scene, settings, RenderProgress.NONE, () -> false).image();
    }

    /**
     * Renders the scene, tells how it gets on, and can be stopped.
     *
     * @param cancelled asked now and then from several threads; once true, the render ends with what it has
     */
    public static RenderResult render(
            Scene scene, RenderSettings settings, RenderProgress progress, BooleanSupplier cancelled) {
        throw new UnsupportedOperationException("not rendered yet");
    }

    /** What a render of this scene would model and need, in plain words, without rendering it. */
    public static Inspection inspect(Scene scene, RenderSettings settings) {
        throw new UnsupportedOperationException("not inspected yet");
    }

    /**
     * What a render would do.
     *
     * @param modelled what the scene requires and is modelled
     * @param notModelled what is left out because the scene does not require it
     * @param primitives number of primitives in the compiled scene
     * @param expectedMemoryBytes estimate of the memory for the compiled scene and the picture
     */
    public record Inspection(
            List<String> modelled, List<String> notModelled, int primitives, long expectedMemoryBytes) {}
}
