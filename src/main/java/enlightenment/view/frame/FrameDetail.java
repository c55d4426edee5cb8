package enlightenment.view.frame;

import enlightenment.image.Image;
import java.util.List;
import java.util.Optional;

/**
 * What is known of a picture beside its colours.
 *
 * @param samples of each pixel so far, as {@link enlightenment.render.RenderResult.Auxiliary#SAMPLES} has them
 * @param noise how exact it is; empty before the second pass
 * @param errors how exact it was after each pass, by time
 * @param seconds since the change that it shows
 */
public record FrameDetail(Image samples, Optional<PictureNoise> noise, List<ErrorPoint> errors, double seconds) {
    public FrameDetail {
        errors = List.copyOf(errors);
    }
}
