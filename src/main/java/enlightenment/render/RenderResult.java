package enlightenment.render;

import enlightenment.image.Image;

/**
 * What a render gave.
 *
 * @param image the picture; where the render was cancelled, the pixels that were not reached are black
 * @param report what was done and how long it took
 * @param complete false where the render was cancelled before its end
 */
public record RenderResult(Image image, RenderReport report, boolean complete) {}
