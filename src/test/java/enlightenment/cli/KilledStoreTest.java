package enlightenment.cli;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

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
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;

/** A render into a store as a process of its own, which is killed as {@code kill -9} does, again and again. */
@Timeout(600)
class KilledStoreTest {
    private static final int UNITS = 108;

    @TempDir
    private Path folder;

    private Process process;

    @AfterEach
    void end() throws InterruptedException {
        if (process != null) {
            process.destroyForcibly().waitFor();
        }
    }

    private Process start(Path scene, Path picture, Path store, String samples) throws IOException {
        List<String> command = List.of(
                Path.of(System.getProperty("java.home"), "bin", "java").toString(),
                "-Xmx256m",
                "-XX:TieredStopAtLevel=1",
                "-XX:+UseSerialGC",
                "-cp",
                System.getProperty("java.class.path"),
                "enlightenment.cli.Main",
                "render",
                scene.toString(),
                "-o",
                picture.toString(),
                "--samples",
                samples,
                "--store",
                store.toString(),
                "--store-rays",
                "--progress",
                "none");
        return new ProcessBuilder(command)
                .redirectErrorStream(true)
                .redirectOutput(folder.resolve("log").toFile())
                .start();
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

    private void check(int kills, String samples, long seed) throws IOException, InterruptedException {
        Path scene = CliRun.scene(folder, "\"width\": 96, \"height\": 72");
        Path plain = folder.resolve("plain.png");
        CliRun run = CliRun.of("render", scene, "-o", plain, "--samples", samples);
        assertEquals(0, run.code(), run.err());
        Path picture = folder.resolve("p.png");
        Path store = folder.resolve("p.db");
        Random random = new Random(seed);
        List<Integer> kept = new ArrayList<>();
        int safe = 0;
        for (int k = 0; k < kills; k++) {
            process = start(scene, picture, store, samples);
            int most = Math.max(safe + 1, UNITS * (k + 1) / (kills + 2));
            int least = safe + random.nextInt(most - safe);
            while (process.isAlive() && rows(store) <= least) {
                process.waitFor(3, TimeUnit.MILLISECONDS);
            }
            int acknowledged = rows(store);
            process.destroyForcibly().waitFor();
            safe = rows(store);
            assertTrue(safe >= acknowledged, "results: " + kept + ", " + acknowledged + ", then " + safe);
            kept.add(safe);
        }
        process = start(scene, picture, store, samples);
        assertTrue(process.waitFor(300, TimeUnit.SECONDS));
        String log = Files.readString(folder.resolve("log"));
        assertEquals(0, process.exitValue(), log);
        assertArrayEquals(Files.readAllBytes(plain), Files.readAllBytes(picture), "killed after " + kept + " results");
        assertTrue(log.contains(safe + " of " + UNITS + " units are kept"), log + kept);
        CliRun again = CliRun.of("render-store", store, "-o", picture);
        assertEquals(0, again.code(), again.err());
        assertArrayEquals(Files.readAllBytes(plain), Files.readAllBytes(picture), "from the store");
        CliRun csv = CliRun.of("store-export", store, "--csv", folder.resolve("s.csv"));
        assertTrue(csv.err().contains(96 * 72 * Integer.parseInt(samples) + " samples"), csv.err());
    }

    @Test
    void killedTwiceItMakesTheSameFile() throws IOException, InterruptedException {
        check(2, "16", 1);
    }

    @Test
    @Tag("full")
    void killedAtTwentyRandomMomentsInARowItMakesTheSameFile() throws IOException, InterruptedException {
        check(20, "256", 2);
    }
}
