package enlightenment.checkpoint;

import java.io.IOException;

/** A checkpoint that cannot be used; the message says why. */
final class JournalException extends IOException {
    private static final long serialVersionUID = 1L;

    JournalException(String message) {
        super(message);
    }
}
