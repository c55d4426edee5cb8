package enlightenment.engine;

import enlightenment.image.Image;
import enlightenment.report.RenderReport;

/**
 * What an assembly holds.
 *
 * @param image the picture so far; what is missing is black
 * @param report what was done
 * @param complete whether nothing is missing
 * @param shownPixels number of pixels that are not black for want of samples
 */
public record Rendered(Image image, RenderReport report, boolean complete, long shownPixels) {}
