package enlightenment.cli.render;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.cli.CliRun;
import enlightenment.cli.SceneFixture;
import enlightenment.cli.terminal.ShutdownSignal;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

/** {@code render --checkpoint FILE [--resume]}. */
class CheckpointCommandTest extends SceneFixture {
    /** Longer than what comes before results: a result or more. */
    private static final long ENOUGH = 5000;

    private Path checkpoint;

    CheckpointCommandTest() {
        super(40, 24);
    }

    @BeforeEach
    void files() {
        checkpoint = folder.resolve("p.ck");
    }

    private byte[] made(Object... more) throws IOException {
        CliRun run = render(more);
        assertEquals(0, run.code(), run.err());
        return Files.readAllBytes(picture);
    }

    private void assertRefused(int code, String words, Object... more) throws IOException {
        Files.deleteIfExists(picture);
        CliRun run = render(more);
        assertEquals(code, run.code(), run.err());
        assertEquals(1, run.errLines().size(), run.err());
        assertTrue(run.err().contains(words), run.err());
        assertFalse(Files.exists(picture));
    }

    @Test
    void theSameFileIsMadeAndMadeAgainFromWhatIsKept() throws IOException {
        byte[] plain = made("--samples", 5);
        assertArrayEquals(plain, made("--samples", 5, "--checkpoint", checkpoint));
        long size = Files.size(checkpoint);
        CliRun again = render("--samples", 5, "--checkpoint", checkpoint, "--resume");
        assertTrue(again.err().contains("15 of 15 units are kept from before"), again.err());
        assertArrayEquals(plain, Files.readAllBytes(picture));
        assertEquals(size, Files.size(checkpoint), "nothing was done again");
    }

    @Test
    void moreSamplesGoOnFromIt() throws IOException {
        byte[] plain = made("--samples", 48);
        made("--samples", 16, "--checkpoint", checkpoint);
        CliRun more = render("--samples", 48, "--checkpoint", checkpoint, "--resume");
        assertTrue(more.err().contains("tiles go on from 16 samples per pixel"), more.err());
        assertArrayEquals(plain, Files.readAllBytes(picture));
    }

    @Test
    void whatIsThereIsOnlyUsedIfThatWasSaid() throws IOException {
        made("--checkpoint", checkpoint);
        assertRefused(1, "--resume goes on with them", "--checkpoint", checkpoint);
    }

    @Test
    void whereNothingIsThereTheRenderBeginsAnewAndSaysSo() throws IOException {
        CliRun run = render("--checkpoint", checkpoint, "--resume");
        assertEquals(0, run.code());
        assertTrue(run.err().contains("there is no such file yet, the render begins anew"), run.err());
        Files.write(checkpoint, new byte[0]);
        assertTrue(render("--checkpoint", checkpoint, "--resume").err().contains("holds nothing yet"));
    }

    @Test
    void anotherSceneAndOtherSettingsAreRefusedByName() throws IOException {
        made("--checkpoint", checkpoint);
        assertRefused(1, "the settings (seed 0 there, 3 here)", "--checkpoint", checkpoint, "--resume", "--seed", 3);
        assertRefused(
                1,
                "the settings (size 40x24 there, 20x12 here)",
                "--checkpoint",
                checkpoint,
                "--resume",
                "--size",
                "20x12");
        Files.writeString(scene, Files.readString(scene).replace("[2, 3, -2]", "[2, 3, -3]"));
        assertRefused(1, "differs in the scene or one of its image files", "--checkpoint", checkpoint, "--resume");
    }

    @Test
    void aFileOfSomethingElseIsNotWrittenOver() throws IOException {
        Files.writeString(checkpoint, "Dear Ryan, this is no checkpoint but a letter about spheres.");
        assertRefused(1, "is not a checkpoint; it is left as it is", "--checkpoint", checkpoint, "--resume");
        assertRefused(2, "would write over the scene", "--checkpoint", scene);
        assertRefused(2, "would write the same file", "--checkpoint", picture);
        assertRefused(1, "there is no folder", "--checkpoint", folder.resolve("no/where.ck"));
    }

    @Test
    void whatItDoesNotGoWithIsRefused() throws IOException {
        assertRefused(2, "--resume needs --checkpoint", "--resume");
        assertRefused(
                2,
                "--dump-clusters",
                "--method",
                "cluster",
                "--checkpoint",
                checkpoint,
                "--dump-clusters",
                folder.resolve("c.csv"));
        picture = folder.resolve("p.film");
        assertRefused(2, "--checkpoint must not be given with --part", "--checkpoint", checkpoint, "--part", "1/2");
        assertFalse(Files.exists(checkpoint));
    }

    @Test
    void aStoppedRenderSaysHowItGoesOn() throws Exception {
        byte[] plain = made("--samples", 4096);
        ShutdownSignal stop = new ShutdownSignal();
        Thread impatient = new Thread(() -> {
            while (!Files.exists(checkpoint) || checkpoint.toFile().length() < ENOUGH) {
                Thread.onSpinWait();
            }
            stop.request();
        });
        impatient.start();
        // By one thread: as many as there are tiles would end all of them at about the same time.
        Object[] slowly = words("render", "--samples", 4096, "--checkpoint", checkpoint, "--threads", 1);
        CliRun stopped = CliRun.of(stop, slowly);
        impatient.join();
        assertEquals(1, stopped.code());
        assertTrue(stopped.err().contains("; what is done is kept: --resume goes on with it"), stopped.err());
        assertArrayEquals(plain, made("--samples", 4096, "--checkpoint", checkpoint, "--resume"));
    }

    @Test
    void errorsTimesReportsAndFurtherPicturesWorkWithIt() throws IOException {
        Path report = folder.resolve("r.json");
        byte[] plain = made("--error", 0.02);
        assertArrayEquals(plain, made("--error", 0.02, "--checkpoint", checkpoint));
        assertArrayEquals(
                plain,
                made(
                        "--error",
                        0.02,
                        "--checkpoint",
                        checkpoint,
                        "--resume",
                        "--report",
                        report,
                        "--stats",
                        "--preview",
                        1,
                        "--aov",
                        "error,samples,depth"));
        assertTrue(Files.readString(report).contains("\"raysPerSecond\""), Files.readString(report));
        assertTrue(Files.exists(folder.resolve("p.samples.png")), "further pictures");
        Path timed = folder.resolve("t.ck");
        byte[] first = made("--time", 0.2, "--checkpoint", timed);
        assertArrayEquals(first, made("--time", 0.2, "--checkpoint", timed, "--resume"));
    }
}
