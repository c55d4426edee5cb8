package enlightenment.store;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Path;
import java.sql.Statement;
import java.util.List;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Stores that have no room left: SQLite undoes by itself what it could not write, and there is no transaction to end. */
class FullStoreTest {
    /** Of 4096 bytes each: more than the empty tables take. */
    private static final int PAGES = 40;

    /** More than fit into all pages: each result has 100 bytes and more. */
    private static final int UNITS = PAGES * 4096 / 100;

    @TempDir
    private Path folder;

    private Path file;
    private StoreAddress full;

    @BeforeEach
    void address() {
        file = folder.resolve("s.db");
        full = StoreAddress.of("jdbc:sqlite:" + file + "?max_page_count=" + PAGES);
    }

    private static void keep(StoreArchive archive, int from, int to) throws IOException {
        for (int unit = from; unit < to; unit++) {
            archive.keep(0, unit, "me", TestStores.result(unit));
        }
        archive.write();
    }

    @Test
    void aFullStoreIsToldAsSuchAndOnceAndKeepsWhatWasWritten() throws IOException {
        StoreArchive archive = TestStores.open(full, StoreLogin.NONE, TestStores.ID, StoredSamples.NONE);
        archive.keep(TestStores.PLAN);
        keep(archive, 0, 3);
        IOException e = assertThrows(IOException.class, () -> keep(archive, 3, UNITS));
        assertTrue(e.getMessage().startsWith(file + ": "), e.getMessage());
        assertTrue(e.getMessage().contains("[SQLITE_FULL]"), e.getMessage());
        archive.close();
        try (StoreArchive again = TestStores.open(file)) {
            int[] next = {0};
            again.replay(0, (unit, bytes) -> {
                assertEquals(next[0]++, unit);
                assertArrayEquals(TestStores.result(unit), bytes);
            });
            assertTrue(next[0] >= 3 && next[0] < UNITS, next[0] + " units");
            assertEquals(0, again.damaged());
        }
    }

    @Test
    void afterAFailureTheNextTransactionHasAConnectionThatIsFitForIt() throws IOException {
        try (Database database = Database.toWrite(full, StoreLogin.NONE, Drivers.ofProgram())) {
            IOException e = assertThrows(IOException.class, () -> insert(database, PAGES * 4096));
            assertTrue(e.getMessage().contains("[SQLITE_FULL]"), e.getMessage());
            insert(database, 1);
            List<Integer> sizes = database.rows("SELECT LENGTH(data) FROM render_plan", 9, row -> row.getInt(1));
            assertEquals(List.of(1), sizes);
        }
    }

    private static void insert(Database database, int bytes) throws IOException {
        database.write(c -> {
            try (Statement statement = c.createStatement()) {
                return statement.executeUpdate("INSERT INTO render_plan (render_id, pass, texts, crc, data)"
                        + " VALUES ('a', 0, ZEROBLOB(0), 0, ZEROBLOB(" + bytes + "))");
            }
        });
    }
}
