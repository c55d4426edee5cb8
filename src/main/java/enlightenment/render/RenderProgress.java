package enlightenment.render;

import enlightenment.image.Image;
import java.util.function.Supplier;

/** Hears how a render gets on. Called from the thread that renders or from its workers, one call at a time. */
@FunctionalInterface
public interface RenderProgress {
    /** Hears nothing. */
    RenderProgress NONE = (done, total, soFar) -> {};

    /**
     * Some more of the picture is done.
     *
     * @param done pixels finished
     * @param total pixels in all
     * @param soFar makes the picture so far; what is not rendered yet is black
     */
    void progress(long done, long total, Supplier<Image> soFar);
}
