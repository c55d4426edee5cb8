package enlightenment.window;

import java.io.IOException;

/** Thrown if there is no display for a window. */
public final class NoDisplayException extends IOException {
    private static final long serialVersionUID = 1L;

    NoDisplayException(Throwable cause) {
        super(cause);
    }
}
