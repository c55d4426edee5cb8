package enlightenment.cli.film;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.cli.CliRun;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;

/** Films by {@code animate --server}. */
@Timeout(600)
class AnimateServerTest {
    @TempDir
    Path folder;

    private Path scene;

    @BeforeEach
    void scene() throws IOException {
        Path file = CliRun.scene(folder, "\"width\": 24, \"height\": 18");
        String text = Files.readString(file);
        String animation =
                """
                , "animation": { "frames": 4, "framesPerSecond": 25,
                  "tracks": [{ "target": "/objects/0/radius", "keys": { "0": 1, "3": 2 } }] }}
                """;
        scene = Files.writeString(file, text.substring(0, text.lastIndexOf('}')) + animation);
    }

    private CliRun animate(String to, Object... more) {
        Object[] args = new Object[4 + more.length];
        System.arraycopy(
                new Object[] {"animate", scene, "-o", folder.resolve(to).resolve("%d.png")}, 0, args, 0, 4);
        System.arraycopy(more, 0, args, 4, more.length);
        return CliRun.of(args);
    }

    private void assertSameFrames(String one, String other) throws IOException {
        for (int n = 0; n < 4; n++) {
            assertArrayEquals(
                    Files.readAllBytes(folder.resolve(one).resolve(n + ".png")),
                    Files.readAllBytes(folder.resolve(other).resolve(n + ".png")),
                    "frame " + n);
        }
    }

    @Test
    void aFilmWithAServerIsThatOfOneProcessByteForByteAndFramesThatAreThereAreKept() throws IOException {
        assertEquals(
                0,
                animate("alone", "--antialias", 2, "--video", folder.resolve("alone.apng"))
                        .code());
        assertEquals(0, animate("served", "--antialias", 2, "--frames", "1-2").code());
        CliRun run = animate(
                "served",
                "--antialias",
                2,
                "--server",
                "--port",
                0,
                "--status-port",
                0,
                "--video",
                folder.resolve("served.apng"));
        assertEquals(0, run.code(), run.err());
        assertTrue(run.err().startsWith("enlightenment: 2 of 4 frames are there already\n"), run.err());
        assertTrue(run.err().contains("workers join with: enlightenment worker 127.0.0.1:"), run.err());
        assertTrue(run.err().contains("status: http://127.0.0.1:"), run.err());
        assertSameFrames("alone", "served");
        assertArrayEquals(
                Files.readAllBytes(folder.resolve("alone.apng")), Files.readAllBytes(folder.resolve("served.apng")));
        CliRun again = animate("served", "--antialias", 2, "--server", "--port", 0);
        assertEquals(new CliRun(0, "", "enlightenment: 4 of 4 frames are there already\n"), again);
    }

    @Test
    void anErrorIsKeptByAServerAsByOneProcess() throws IOException {
        assertEquals(0, animate("alone", "--error", "0.03").code());
        CliRun run = animate("served", "--error", "0.03", "--server", "--port", 0);
        assertEquals(0, run.code(), run.err());
        assertTrue(run.err().contains("once more with"), run.err());
        assertSameFrames("alone", "served");
    }

    @Test
    void whatDoesNotGoTogetherIsRefused() {
        assertRefused("--port is for --server, which is not given", "--port", 0);
        assertRefused("--local-threads is for --server", "--local-threads", 1);
        assertRefused("unknown option: '--checkpoint'", "--server", "--checkpoint", folder.resolve("ck"));
        assertRefused("unknown option: '--pardon'", "--server", "--pardon", "01234567");
        assertRefused("--time must not be given with --server", "--server", "--time", 1);
        assertRefused("--aov must not be given with --server", "--server", "--aov", "depth");
        assertRefused("--token-file would write over the scene", "--server", "--token-file", scene);
        assertRefused("--host 0.0.0.0 is beyond this machine: --token-file", "--server", "--host", "0.0.0.0");
    }

    private void assertRefused(String words, Object... more) {
        CliRun run = animate("refused", more);
        assertEquals(2, run.code(), run.err());
        assertTrue(run.err().contains(words), run.err());
        assertTrue(Files.notExists(folder.resolve("refused")));
    }

    @Test
    void aFrameThatCannotBeUsedIsNamedBeforeTheServerListens() throws IOException {
        Files.writeString(scene, Files.readString(scene).replace("\"3\": 2", "\"3\": -1"));
        CliRun run = animate("bad", "--server", "--port", 0);
        assertEquals(2, run.code(), run.err());
        assertTrue(run.err().contains("(in frame "), run.err());
    }
}
