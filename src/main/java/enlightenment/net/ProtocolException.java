package enlightenment.net;

import java.io.IOException;

/** What came over the wire is not what the protocol allows; the message says what and why. */
final class ProtocolException extends IOException {
    private static final long serialVersionUID = 1L;

    ProtocolException(String message) {
        super(message);
    }

    ProtocolException(String message, Throwable cause) {
        super(message, cause);
    }
}
