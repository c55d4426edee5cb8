package enlightenment.store;

import java.io.IOException;

/** A store that cannot be used, or does not do what it should; the message says why, in one line. */
public final class StoreException extends IOException {
    private static final long serialVersionUID = 1L;

    StoreException(String message) {
        super(message);
    }

    StoreException(String message, Throwable cause) {
        super(message, cause);
    }
}
