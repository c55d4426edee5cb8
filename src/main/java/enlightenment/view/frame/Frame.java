package enlightenment.view.frame;

import enlightenment.image.Image;

/**
 * A picture of a view.
 *
 * @param generation of the {@link Shot} that it shows
 * @param image as it was rendered, without the view's exposure
 * @param samples per pixel that it is the mean of
 * @param shrink the side of the squares of pixels that each of its pixels stands for
 * @param isFinal whether there will be no finer one
 * @param detail what is known of it beside its colours
 */
public record Frame(long generation, Image image, int samples, int shrink, boolean isFinal, FrameDetail detail) {}
