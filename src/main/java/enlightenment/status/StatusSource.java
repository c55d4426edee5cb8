package enlightenment.status;

import enlightenment.image.Image;
import java.util.Optional;

/** The status of a render and its picture so far. Implementations are thread-safe. */
public interface StatusSource {
    /** The status of the render at this moment. */
    Status status();

    /** The picture so far, as it is displayed; empty until there is one. */
    Optional<Image> image();

    /** The state of the render; does not block. */
    State state();
}
