package enlightenment.store;

import java.io.IOException;
import java.sql.SQLException;

/** A store that cannot be used, or does not do what it should; the message says why, in one line. */
public final class StoreException extends IOException {
    private static final long serialVersionUID = 1L;

    StoreException(String message) {
        super(message);
    }

    StoreException(String message, Throwable cause) {
        super(message, cause);
    }

    /**
     * Whether there is no room for more: class 53 of SQL's states (insufficient resources), or what SQLite says of a full disk, on which it
     * cannot make its own files either.
     */
    public boolean isOutOfSpace() {
        if (!(getCause() instanceof SQLException e)) {
            return false;
        }
        String state = String.valueOf(e.getSQLState());
        String message = String.valueOf(e.getMessage());
        return state.startsWith("53") || message.contains("SQLITE_FULL") || message.contains("SQLITE_IOERR");
    }
}
