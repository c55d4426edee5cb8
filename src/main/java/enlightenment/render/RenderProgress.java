package enlightenment.render;

import enlightenment.image.Image;
import java.util.function.Supplier;

/**
 * A listener that is called while a render runs, from the thread that asked for the render or from one of its helpers, one call at a time;
 * threads that finish a unit of work meanwhile wait, so a call should be short. What it throws ends the render.
 */
@FunctionalInterface
public interface RenderProgress {
    /** A listener that ignores all calls. */
    RenderProgress NONE = (done, total, soFar) -> {};

    /**
     * Called when more of the picture is done.
     *
     * @param done pixels finished, where a unit of work that is a share of several pixels counts as that share of them; 0 while a
     *     progressive or watched render refines its first coarse pass
     * @param total pixels in all
     * @param soFar makes the picture so far, when it is called before this method returns. What is not rendered yet is black;
     *     in a progressive or watched render there is no such thing, because the first call comes after the first coarse pass, nor with a
     *     method whose paths may end anywhere: there it is the picture of the paths so far
     */
    void progress(long done, long total, Supplier<Image> soFar);

    /**
     * The whole picture, coarsely: called once, before {@link #planned}, by a render that is {@linkplain RenderRequest#watched watched}.
     *
     * @param soFar makes the picture, when it is called before this method returns; no pixel is black for want of samples
     */
    default void coarse(Supplier<Image> soFar) {}

    /**
     * Called when the number of samples is planned. That is before the first progress, and again before a further round for a picture that
     * was not as exact as asked; on the thread that called the render.
     *
     * @param samples camera rays per pixel in the mean: as {@code --samples} this makes the same picture
     * @param decidedBy which part of the budget was decisive: antialias, samples, error or time
     */
    default void planned(double samples, String decidedBy) {}

    /** One sentence about the budget for the user who waits: that it cannot be kept, or what it takes. */
    default void note(String text) {}
}
