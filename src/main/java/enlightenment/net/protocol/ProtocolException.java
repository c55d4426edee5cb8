package enlightenment.net.protocol;

import java.io.IOException;

/** What came over the wire is not what the protocol allows; the message says what and why. */
public final class ProtocolException extends IOException {
    private static final long serialVersionUID = 1L;

    public ProtocolException(String message) {
        super(message);
    }

    public ProtocolException(String message, Throwable cause) {
        super(message, cause);
    }
}
