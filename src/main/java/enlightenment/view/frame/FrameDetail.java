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
 */
public record FrameDetail(Image samples, Optional<PictureNoise> noise, List<ErrorPoint> errors, double seconds) {
    public FrameDetail {
        errors = List.copyOf(errors);
    }
}
