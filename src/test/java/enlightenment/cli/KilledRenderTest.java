package enlightenment.cli;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.checkpoint.Checkpoint;
import enlightenment.job.Build;
import enlightenment.job.RenderIdentity;
import enlightenment.job.SceneDocument;
import enlightenment.scene.RenderSettings;
import enlightenment.scene.Scene;
import enlightenment.scene.json.SceneReader;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;

/** A render with a checkpoint as a process of its own, which is killed as {@code kill -9} does, again and again. */
@Timeout(600)
class KilledRenderTest {
    private static final int UNITS = 108;

    /** What is written before the first result, about, and what a result takes, with which it can grow. */
    private static final int HEAD = 900;

    private static final int RESULT = 64 * (36 + 96);

    @TempDir
    Path folder;

    private Process process;

    @AfterEach
    void end() throws InterruptedException {
        if (process != null) {
            process.destroyForcibly().waitFor();
        }
    }

    private Process start(Path scene, Path picture, Path checkpoint) throws IOException {
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
                "256",
                "--checkpoint",
                checkpoint.toString(),
                "--resume",
                "--progress",
                "none");
        return new ProcessBuilder(command)
                .redirectErrorStream(true)
                .redirectOutput(folder.resolve("log").toFile())
                .start();
    }

    /** Kills it once the file has so many bytes; whether there was somebody to kill. */
    private boolean killedAt(Path checkpoint, long bytes) throws InterruptedException {
        while (process.isAlive() && checkpoint.toFile().length() < bytes) {
            process.waitFor(1, TimeUnit.MILLISECONDS);
        }
        boolean isAlive = process.isAlive();
        process.destroyForcibly().waitFor();
        return isAlive;
    }

    /** How many results the file holds. */
    private static int results(Path checkpoint, Path scene) throws IOException {
        Scene read = SceneReader.read(scene);
        RenderIdentity render =
                RenderIdentity.of(SceneDocument.of(read).hash(), RenderSettings.of(read), Build.number());
        try (Checkpoint kept = Checkpoint.open(checkpoint, render, true)) {
            return kept.results();
        }
    }

    private void check(int kills, long seed) throws IOException, InterruptedException {
        Path scene = CliRun.scene(folder, "\"width\": 96, \"height\": 72");
        Path plain = folder.resolve("plain.png");
        CliRun run = CliRun.of("render", scene, "-o", plain, "--samples", 256);
        assertEquals(0, run.code(), run.err());
        Path picture = folder.resolve("p.png");
        Path checkpoint = folder.resolve("p.ck");
        Random random = new Random(seed);
        List<Integer> kept = new ArrayList<>();
        int done = 0;
        for (int k = 0; k < kills; k++) {
            process = start(scene, picture, checkpoint);
            // At any byte of any record, and the first time in what comes before them.
            long most = HEAD + (long) RESULT * (k + 1) * UNITS / (kills + 2);
            long least = k == 0 ? 1 : Math.min(checkpoint.toFile().length() + 1, most);
            if (!killedAt(checkpoint, least + (long) (random.nextDouble() * (most - least)))) {
                break;
            }
            int now = results(checkpoint, scene);
            assertTrue(now >= done, "results: " + kept + ", then " + now);
            done = now;
            kept.add(now);
        }
        assertTrue(kept.size() > kills / 2, "killed after " + kept + " results");
        process = start(scene, picture, checkpoint);
        assertTrue(process.waitFor(300, TimeUnit.SECONDS));
        assertEquals(0, process.exitValue(), Files.readString(folder.resolve("log")));
        assertArrayEquals(Files.readAllBytes(plain), Files.readAllBytes(picture), "killed after " + kept + " results");
        String log = Files.readString(folder.resolve("log"));
        assertTrue(done == 0 || log.contains(done + " of " + UNITS + " units are kept"), log + kept);
    }

    @Test
    void killedThreeTimesItMakesTheSameFile() throws IOException, InterruptedException {
        check(3, 1);
    }

    @Test
    @Tag("full")
    void killedAtTwentyRandomMomentsInARowItMakesTheSameFile() throws IOException, InterruptedException {
        check(20, 2);
    }
}
