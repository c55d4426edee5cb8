package enlightenment.store;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.io.IOException;
import java.sql.SQLException;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** A full disk costs the store and not the picture; whatever else keeps a store from being used ends the render. */
class StoreExceptionTest {
    @ParameterizedTest
    @CsvSource({
        "[SQLITE_FULL] Insertion failed because database is full, , true",
        "[SQLITE_IOERR_SHMSIZE] I/O error within xShmMap, , true",
        "could not extend file: No space left on device, 53100, true",
        "[SQLITE_CANTOPEN] Unable to open the database file, , false",
        "[SQLITE_READONLY] attempt to write a readonly database, , false",
        "password authentication failed, 28P01, false"
    })
    void onlyALackOfRoomIsOne(String message, String state, boolean isOutOfSpace) {
        assertEquals(isOutOfSpace, new StoreException(message, new SQLException(message, state)).isOutOfSpace());
    }

    @Test
    void whatNoDatabaseSaidIsNone() {
        assertEquals(false, new StoreException("SQLITE_FULL", new IOException("SQLITE_FULL")).isOutOfSpace());
        assertEquals(false, new StoreException("SQLITE_FULL").isOutOfSpace());
    }
}
