package enlightenment.measure.analysis;

import enlightenment.image.Image;
import enlightenment.measure.trade.TradeRun;
import java.util.Optional;

/**
 * A picture of a comparison at equal time.
 *
 * @param run the run of the picture, with its error
 * @param image the picture; empty if it was not kept
 * @param difference the absolute difference from the reference, times {@code gain}; empty if it was not kept
 * @param gain the factor that makes differences visible; the same for all pictures of a comparison
 */
public record EqualTimePicture(TradeRun run, Optional<Image> image, Optional<Image> difference, int gain) {}
