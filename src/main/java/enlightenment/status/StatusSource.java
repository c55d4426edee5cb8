package enlightenment.status;

import enlightenment.image.Image;
import java.util.Optional;

/** A render that can be watched: how far it is, and its picture so far. For use by several threads at once. */
public interface StatusSource {
    /** The status of the render at this moment. */
    Status status();

    /** The picture so far, as it is to be shown; empty as long as there is none. */
    Optional<Image> image();

    /** The state of the render; does not block. */
    State state();
}
