package enlightenment.cli;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;

@Timeout(60)
class ServerCommandTest {
    @TempDir
    Path folder;

    private Path scene;
    private Path picture;

    @BeforeEach
    void scene() throws IOException {
        scene = CliRun.scene(folder, "\"width\": 50, \"height\": 34");
        picture = folder.resolve("picture.png");
    }

    private void assertRefused(String words, Object... more) {
        Object[] args = new Object[4 + more.length];
        System.arraycopy(new Object[] {"server", scene, "-o", picture}, 0, args, 0, 4);
        System.arraycopy(more, 0, args, 4, more.length);
        CliRun run = CliRun.of(args);
        assertEquals(2, run.code(), run.err());
        assertTrue(run.err().contains(words), run.err());
    }

    @Test
    void aServerWithoutWorkersMakesTheFileThatRenderMakes() throws IOException {
        Path alone = folder.resolve("alone.png");
        assertEquals(
                0, CliRun.of("render", scene, "-o", alone, "--progress", "none").code());
        CliRun run = CliRun.of("server", scene, "-o", picture, "--port", 0, "--progress", "none", "--stats");
        assertEquals(0, run.code(), run.err());
        assertTrue(run.err().contains("workers join with: enlightenment worker 127.0.0.1:"), run.err());
        assertTrue(run.out().contains("estimated error"), run.out());
        assertArrayEquals(Files.readAllBytes(alone), Files.readAllBytes(picture));
    }

    @Test
    void aTimeBudgetMakesACompletePicture() {
        CliRun run = CliRun.of("server", scene, "-o", picture, "--port", 0, "--time", "0.3", "--progress", "none");
        assertEquals(0, run.code(), run.err());
    }

    @Test
    void whatDoesNotGoTogetherIsRefused() {
        Path file = folder.resolve("file");
        assertRefused("--host 0.0.0.0 is beyond this machine: --token-file", "--host", "0.0.0.0");
        assertRefused("--tls-cert and --tls-key go together", "--tls-cert", file);
        assertRefused("must not be given with --time", "--time", "3", "--checkpoint", file);
        assertRefused("--shares must be HOST=WEIGHT", "--shares", "fast");
        assertRefused("--shares must be a number", "--shares", "fast=quick");
        assertRefused("--port must be a whole number in 0..65535", "--port", "70000");
        assertRefused("--audit must be a number in 0..1", "--audit", "2");
        assertRefused("must not name the scene itself", "--checkpoint", scene);
    }

    @Test
    void theCheckpointOfAnotherJobIsLeftAsItIs() throws IOException {
        Path checkpoint = folder.resolve("checkpoint");
        Object[] args = {"server", scene, "-o", picture, "--port", 0, "--progress", "none", "--checkpoint", checkpoint};
        assertEquals(0, CliRun.of(args).code());
        byte[] before = Files.readAllBytes(checkpoint);
        Files.writeString(scene, Files.readString(scene).replace("\"radius\": 1,", "\"radius\": 2,"));
        CliRun run = CliRun.of(args);
        assertEquals(1, run.code());
        assertTrue(run.err().contains("is the checkpoint of another job"), run.err());
        assertArrayEquals(before, Files.readAllBytes(checkpoint));
    }

    @Test
    void aWorkerWithoutAServerSaysSo() {
        CliRun run = CliRun.of("worker", "127.0.0.1:1", "--reconnect", "0");
        assertEquals(1, run.code());
        assertTrue(run.err().contains("no server for"), run.err());
        assertEquals(2, CliRun.of("worker", "6002").code());
        assertEquals(2, CliRun.of("worker", "localhost:6002", "--pin", "12").code());
    }
}
