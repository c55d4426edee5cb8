package enlightenment.cli.render;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.checkpoint.Checkpoint;
import enlightenment.cli.CliRun;
import enlightenment.cli.Processes;
import enlightenment.cli.SceneFixture;
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
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.extension.RegisterExtension;

/** A render with a checkpoint as a process of its own, which is killed as {@code kill -9} does, again and again. */
@Timeout(600)
class KilledRenderTest extends SceneFixture {
    private static final int UNITS = 108;

    /** What is written before the first result, about, and what a result takes, with which it can grow. */
    private static final int HEAD = 900;

    private static final int RESULT = 64 * (36 + 96);

    @RegisterExtension
    final Processes processes = new Processes();

    KilledRenderTest() {
        super(96, 72);
    }

    private Processes.Running start(Path checkpoint) throws IOException {
        return processes.start(
                folder, words("render", "--threads", 2, "--samples", 256, "--checkpoint", checkpoint, "--resume"));
    }

    /** How many results the file holds. */
    private int results(Path checkpoint) throws IOException {
        Scene read = SceneReader.read(scene);
        RenderIdentity render =
                RenderIdentity.of(SceneDocument.of(read).hash(), RenderSettings.of(read), Build.number());
        try (Checkpoint kept = Checkpoint.open(checkpoint, render, true)) {
            return kept.results();
        }
    }

    private void check(int kills, long seed) throws Exception {
        byte[] plain = CliRun.picture("render", scene, "-o", folder.resolve("plain.png"), "--samples", 256);
        Path checkpoint = folder.resolve("p.ck");
        Random random = new Random(seed);
        List<Integer> kept = new ArrayList<>();
        int done = 0;
        for (int k = 0; k < kills; k++) {
            // At any byte of any record, and the first time in what comes before them.
            long most = HEAD + (long) RESULT * (k + 1) * UNITS / (kills + 2);
            long least = k == 0 ? 1 : Math.min(checkpoint.toFile().length() + 1, most);
            long bytes = least + (long) (random.nextDouble() * (most - least));
            if (!start(checkpoint).killOnce(() -> checkpoint.toFile().length() >= bytes, 0)) {
                break;
            }
            int now = results(checkpoint);
            assertTrue(now >= done, "results: " + kept + ", then " + now);
            done = now;
            kept.add(now);
        }
        assertTrue(kept.size() > kills / 2, "killed after " + kept + " results");
        String said = start(checkpoint).ended(0);
        assertArrayEquals(plain, Files.readAllBytes(picture), "killed after " + kept + " results");
        assertTrue(done == 0 || said.contains(done + " of " + UNITS + " units are kept"), said + kept);
    }

    @Test
    void killedThreeTimesItMakesTheSameFile() throws Exception {
        check(3, 1);
    }

    @Test
    @Tag("full")
    void killedAtTwentyRandomMomentsInARowItMakesTheSameFile() throws Exception {
        check(20, 2);
    }
}
