package enlightenment.view.frame;

import enlightenment.image.Image;
import java.util.List;
import java.util.Optional;

/**
 * Statistics of a picture: sample counts, noise, and the history of its error.
 *
 * @param samples number of samples of each pixel so far, as in {@link enlightenment.render.RenderResult.Auxiliary#SAMPLES}
 * @param noise estimated standard errors; empty before the second pass at full resolution
 * @param errors estimated errors after earlier passes and this one, by time
 * @param seconds time since the change of the view that the picture shows
 * @param quarters the means of four shares of the samples, as of {@link PassQuarters#means}; empty before the second pass at full resolution
 */
public record FrameDetail(
        Image samples, Optional<PictureNoise> noise, List<ErrorPoint> errors, double seconds, List<Image> quarters) {
    public FrameDetail {
        errors = List.copyOf(errors);
        quarters = List.copyOf(quarters);
    }
}
