package enlightenment.engine;

import enlightenment.image.Image;
import enlightenment.report.RenderReport;

/**
 * The state of an assembly.
 *
 * @param image the picture so far; missing pixels are black
 * @param report statistics and times of the render
 * @param complete whether no unit is missing
 * @param shownPixels number of pixels that have samples
 */
public record Rendered(Image image, RenderReport report, boolean complete, long shownPixels) {}
