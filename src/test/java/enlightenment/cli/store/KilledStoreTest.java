package enlightenment.cli.store;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.cli.CliRun;
import enlightenment.cli.Processes;
import enlightenment.cli.SceneFixture;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.sql.Connection;
import java.sql.DriverManager;
import java.sql.ResultSet;
import java.sql.SQLException;
import java.sql.Statement;
import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import java.util.concurrent.atomic.AtomicInteger;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.extension.RegisterExtension;

/** A render into a store as a process of its own, which is killed as {@code kill -9} does, again and again. */
@Timeout(600)
class KilledStoreTest extends SceneFixture {
    private static final int UNITS = 108;

    @RegisterExtension
    final Processes processes = new Processes();

    KilledStoreTest() {
        super(96, 72);
    }

    private Processes.Running start(Path store, String samples) throws IOException {
        return processes.start(folder, words("render", "--samples", samples, "--store", store, "--store-rays"));
    }

    /** How many results are safe; 0 while there is no table for them. */
    private static int rows(Path store) {
        if (!Files.exists(store)) {
            return 0;
        }
        try (Connection c = DriverManager.getConnection("jdbc:sqlite:" + store + "?open_mode=1");
                Statement statement = c.createStatement();
                ResultSet result = statement.executeQuery("SELECT COUNT(*) FROM film_part")) {
            return result.next() ? result.getInt(1) : 0;
        } catch (SQLException e) {
            // It is being made, or busy.
            return 0;
        }
    }

    private void check(int kills, String samples, long seed) throws Exception {
        byte[] plain = CliRun.picture("render", scene, "-o", folder.resolve("plain.png"), "--samples", samples);
        Path store = folder.resolve("p.db");
        Random random = new Random(seed);
        List<Integer> kept = new ArrayList<>();
        int safe = 0;
        for (int k = 0; k < kills; k++) {
            int most = Math.max(safe + 1, UNITS * (k + 1) / (kills + 2));
            int least = safe + random.nextInt(most - safe);
            AtomicInteger acknowledged = new AtomicInteger();
            start(store, samples)
                    .killOnce(
                            () -> {
                                acknowledged.set(rows(store));
                                return acknowledged.get() > least;
                            },
                            0);
            safe = rows(store);
            assertTrue(safe >= acknowledged.get(), "results: " + kept + ", " + acknowledged + ", then " + safe);
            kept.add(safe);
        }
        String said = start(store, samples).ended(0);
        assertArrayEquals(plain, Files.readAllBytes(picture), "killed after " + kept + " results");
        assertTrue(said.contains(safe + " of " + UNITS + " units are kept"), said + kept);
        assertArrayEquals(plain, CliRun.picture("render-store", store, "-o", picture), "from the store");
        CliRun csv = CliRun.of("store-export", store, "--csv", folder.resolve("s.csv"));
        assertTrue(csv.err().contains(96 * 72 * Integer.parseInt(samples) + " samples"), csv.err());
    }

    @Test
    void killedTwiceItMakesTheSameFile() throws Exception {
        check(2, "16", 1);
    }

    @Test
    @Tag("full")
    void killedAtTwentyRandomMomentsInARowItMakesTheSameFile() throws Exception {
        check(20, "256", 2);
    }
}
