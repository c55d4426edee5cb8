package enlightenment.store;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.net.ServerSocket;
import java.nio.file.Files;
import java.nio.file.Path;
import java.sql.Connection;
import java.sql.DriverManager;
import java.sql.SQLException;
import java.sql.Statement;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** With a real MariaDB server, of a folder of its own, where one is installed. */
@Tag("full")
class MariaDbTest {
    private static final int UNITS = 1200;
    private static final String USER = "painter";
    private static final String PASSWORD = "not-to-be-shown";

    @TempDir
    private static Path folder;

    private static Process server;
    private static int port;

    @BeforeAll
    static void start() throws Exception {
        Optional<Path> program = List.of("/usr/sbin/mariadbd", "/usr/bin/mariadbd", "/usr/local/bin/mariadbd").stream()
                .map(Path::of)
                .filter(Files::isExecutable)
                .findFirst();
        assumeTrue(program.isPresent(), "MariaDB is not installed");
        try (ServerSocket free = new ServerSocket(0)) {
            port = free.getLocalPort();
        }
        Path data = folder.resolve("data");
        Process made = new ProcessBuilder(
                        "mariadb-install-db",
                        "--no-defaults",
                        "--datadir=" + data,
                        "--auth-root-authentication-method=normal")
                .redirectErrorStream(true)
                .redirectOutput(folder.resolve("install.log").toFile())
                .start();
        assertTrue(made.waitFor(5, TimeUnit.MINUTES));
        server = new ProcessBuilder(
                        program.get().toString(),
                        "--no-defaults",
                        "--datadir=" + data,
                        "--socket=" + folder.resolve("s"),
                        "--port=" + port,
                        "--bind-address=127.0.0.1",
                        "--user=root")
                .redirectErrorStream(true)
                .redirectOutput(folder.resolve("server.log").toFile())
                .start();
        prepare();
    }

    private static void prepare() throws Exception {
        for (int k = 0; ; k++) {
            try (Connection root = DriverManager.getConnection(url("mysql"), "root", "");
                    Statement statement = root.createStatement()) {
                statement.execute("CREATE DATABASE pictures");
                statement.execute("CREATE DATABASE others");
                statement.execute("CREATE USER '" + USER + "'@'127.0.0.1' IDENTIFIED BY '" + PASSWORD + "'");
                statement.execute("GRANT ALL ON pictures.* TO '" + USER + "'@'127.0.0.1'");
                statement.execute("GRANT ALL ON others.* TO '" + USER + "'@'127.0.0.1'");
                return;
            } catch (SQLException e) {
                assertTrue(k < 600 && server.isAlive(), e.toString());
                Thread.sleep(200);
            }
        }
    }

    @AfterAll
    static void stop() throws InterruptedException {
        if (server != null) {
            server.destroy();
            server.waitFor();
        }
    }

    private static String url(String database) {
        return "jdbc:mariadb://127.0.0.1:" + port + "/" + database + "?sslMode=disable";
    }

    private static StoreLogin login() {
        return new StoreLogin(Optional.of(USER), Optional.of(PASSWORD));
    }

    private static Process writer(String database, int first, int end, int step) throws IOException {
        return TestWriter.start(StoreAddress.of(url(database)), USER, first, end, step, PASSWORD);
    }

    @Test
    void twoProcessesWriteAndOneOfThemIsKilled() throws Exception {
        Process up = writer("pictures", 0, UNITS, 1);
        Process down = writer("pictures", UNITS - 1, -1, -1);
        int safe = TestWriter.lastSafe(down, 12);
        TestWriter.lastSafe(up, Integer.MAX_VALUE);
        down.waitFor();
        assertEquals(0, up.waitFor());
        assertTrue(safe > 0);
        TestStores.assertHolds(StoreAddress.of(url("pictures")), login(), 0, UNITS);
    }

    @Test
    void whatTheKilledOneHadAcknowledgedIsThere() throws Exception {
        Process writer = writer("others", 0, UNITS, 1);
        int safe = TestWriter.lastSafe(writer, 9);
        writer.waitFor();
        assertTrue(safe > 0 && safe < UNITS);
        int[] next = {0};
        try (StoreArchive archive =
                TestStores.open(StoreAddress.of(url("others")), login(), TestStores.ID, StoredSamples.PIXELS)) {
            archive.replay(0, (unit, bytes) -> assertEquals(next[0]++, unit));
        }
        assertTrue(next[0] > safe, next[0] + " after " + safe);
    }

    @Test
    void aWrongPasswordIsSaidWithoutItAndWithoutTheOptionsOfTheUrl() {
        StoreLogin wrong = new StoreLogin(Optional.of(USER), Optional.of("secret-word"));
        IOException e =
                assertThrows(IOException.class, () -> SampleStore.open(StoreAddress.of(url("pictures")), wrong));
        assertFalse(e.getMessage().contains("secret-word"), e.getMessage());
        assertFalse(e.getMessage().contains("sslMode"), e.getMessage());
        assertTrue(e.getMessage().contains("denied"), e.getMessage());
    }
}
