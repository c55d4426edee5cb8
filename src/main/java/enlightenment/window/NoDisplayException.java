package enlightenment.window;

import java.io.IOException;

/** There is nothing that a window could be shown on. */
public final class NoDisplayException extends IOException {
    private static final long serialVersionUID = 1L;

    NoDisplayException(Throwable cause) {
        super(cause);
    }
}
