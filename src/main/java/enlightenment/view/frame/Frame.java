package enlightenment.view.frame;

import enlightenment.image.Image;

/**
 * A picture of a view, after some of its passes.
 *
 * @param generation the generation of the {@link Shot} that the picture shows
 * @param image the picture as it was rendered, without the view's exposure
 * @param samples samples per pixel
 * @param shrink side in pixels of the block that each pixel of the image stands for; 1 at full resolution
 * @param isFinal whether this is the picture of the last pass
 * @param detail sample counts, estimated noise, and their history
 */
public record Frame(long generation, Image image, int samples, int shrink, boolean isFinal, FrameDetail detail) {}
