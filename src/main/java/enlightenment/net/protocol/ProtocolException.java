package enlightenment.net.protocol;

import java.io.IOException;

/** A violation of the protocol; the message says what was received and what is wrong with it. */
public final class ProtocolException extends IOException {
    private static final long serialVersionUID = 1L;

    private final boolean isAboutTls;

    public ProtocolException(String message) {
        this(message, null);
    }

    public ProtocolException(String message, Throwable cause) {
        this(message, cause, false);
    }

    private ProtocolException(String message, Throwable cause, boolean isAboutTls) {
        super(message, cause);
        this.isAboutTls = isAboutTls;
    }

    /** The exception for a peer that begins with TLS, where none is spoken. */
    static ProtocolException tls() {
        return new ProtocolException("the other side speaks TLS here", null, true);
    }

    /** Whether the other side speaks TLS where none is spoken. */
    public boolean isAboutTls() {
        return isAboutTls;
    }
}
