package enlightenment.cli.serve;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.cli.CliRun;
import enlightenment.cli.SceneFixture;
import enlightenment.cli.terminal.ShutdownSignal;
import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

@Timeout(600)
class ServerCommandTest extends SceneFixture {
    ServerCommandTest() {
        super(50, 34);
    }

    private void assertRefused(String words, Object... more) {
        CliRun run = CliRun.of(words("server", more));
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
    void anErrorIsKeptByAServerAsByOneProcess() throws IOException {
        Path alone = folder.resolve("alone.png");
        CliRun render = CliRun.of("render", scene, "-o", alone, "--error", "0.02", "--progress", "none");
        assertEquals(0, render.code(), render.err());
        assertTrue(render.err().contains("once more with"), render.err());
        CliRun run = CliRun.of("server", scene, "-o", picture, "--port", 0, "--error", "0.02", "--progress", "none");
        assertEquals(0, run.code(), run.err());
        assertArrayEquals(Files.readAllBytes(alone), Files.readAllBytes(picture));
        CliRun limited = CliRun.of(
                "server", scene, "-o", picture, "--port", 0, "--error", "0.02", "--samples", 1, "--progress", "none");
        assertEquals(1, limited.code(), limited.err());
        assertTrue(limited.err().contains("more than --error 0.02; decided by samples"), limited.err());
    }

    @Test
    void aTimeBudgetMakesACompletePicture() {
        CliRun run = CliRun.of("server", scene, "-o", picture, "--port", 0, "--time", "0.3", "--progress", "none");
        assertEquals(0, run.code(), run.err());
    }

    @Test
    void aServerStoppedBeforeItBeganWritesNothing() {
        ShutdownSignal stop = new ShutdownSignal();
        stop.request();
        CliRun run = CliRun.of(stop, "server", scene, "-o", picture, "--port", 0);
        String said = "enlightenment: stopped before anything was rendered; " + picture + " was not written\n";
        assertEquals(new CliRun(1, "", said), run);
    }

    @Test
    void whatDoesNotGoTogetherIsRefused() {
        Path file = folder.resolve("file");
        assertRefused("--host 0.0.0.0 is beyond this machine: --token-file", "--host", "0.0.0.0");
        assertRefused("--tls-cert and --tls-key go together", "--tls-cert", file);
        assertRefused("--tls must not be given together", "--tls", file, "--tls-cert", file, "--tls-key", file);
        assertRefused("--tls and -o would write the same file", "--tls", picture);
        assertRefused("--token-file would write over the scene", "--token-file", scene);
        assertRefused("--token-file and --tls would write the same file", "--tls", file, "--token-file", file);
        assertRefused("must not be given with --time", "--time", "3", "--checkpoint", file);
        assertRefused("--shares must be HOST=WEIGHT", "--shares", "fast");
        assertRefused("--shares must be a number", "--shares", "fast=quick");
        assertRefused("--port must be a whole number in 0..65535", "--port", "70000");
        assertRefused("--audit must be a number in 0..1", "--audit", "2");
        assertRefused("--checkpoint would write over the scene", "--checkpoint", scene);
    }

    @Test
    void secretsThatAreMissingAreMadeAndNamedInTheLineForWorkers() throws IOException {
        Path token = folder.resolve("token");
        Path tls = folder.resolve("tls.pem");
        Object[] args = {
            "server", scene, "-o", picture, "--port", 0, "--progress", "none", "--token-file", token, "--tls", tls
        };
        CliRun first = CliRun.of(args);
        assertEquals(0, first.code(), first.err());
        assertTrue(first.err().contains("made a new secret token: " + token), first.err());
        assertTrue(first.err().contains("made a new certificate and its private key: " + tls), first.err());
        assertTrue(first.err().contains(" --token-file " + token + " --pin "), first.err());
        CliRun second = CliRun.of(args);
        assertFalse(second.err().contains("made a new"), second.err());
        assertEquals(pin(first), pin(second));
    }

    private static String pin(CliRun run) {
        return run.err().replaceAll("(?s).* --pin ([0-9a-f]{64})\\R.*", "$1");
    }

    @Test
    void nothingIsMadeForASceneThatIsOfNoUse() throws IOException {
        Path token = folder.resolve("token");
        CliRun run = CliRun.of("server", CliRun.badScene(folder), "-o", picture, "--port", 0, "--token-file", token);
        assertEquals(2, run.code(), run.err());
        assertFalse(Files.exists(token));
    }

    @Test
    void aWorkerReadsTheTokenFromStandardInput() {
        InputStream usual = System.in;
        try {
            System.setIn(new ByteArrayInputStream("0123456789abcde\nmore".getBytes(StandardCharsets.US_ASCII)));
            CliRun run = CliRun.of("worker", "127.0.0.1:1", "--token-file", "-", "--reconnect", "0");
            assertEquals(1, run.code());
            assertTrue(run.err().contains("the token on standard input: a token has at least 16"), run.err());
            System.setIn(new ByteArrayInputStream("0123456789abcdef\n".getBytes(StandardCharsets.US_ASCII)));
            run = CliRun.of("worker", "127.0.0.1:1", "--token-file", "-", "--reconnect", "0");
            assertTrue(run.err().contains("no server for"), run.err());
        } finally {
            System.setIn(usual);
        }
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
        assertTrue(run.err().contains("is the checkpoint of another render, which differs in the scene"), run.err());
        assertArrayEquals(before, Files.readAllBytes(checkpoint));
    }

    /** A label of more than 63 letters cannot be asked for (RFC 1035): nobody is, and the test stays on this machine. */
    @Test
    void aHostThatIsNotKnownIsSaidToBeNone() {
        String host = "x".repeat(64) + ".invalid";
        String words = "the host " + host + " is not known";
        CliRun run = CliRun.of("worker", host + ":1", "--reconnect", "0");
        assertEquals(1, run.code());
        assertTrue(run.err().matches("(?s).*no server for \\d+ s: " + words + ".*"), run.err());
        run = CliRun.of("server", scene, "-o", picture, "--host", host, "--port", 0);
        assertEquals(1, run.code());
        assertTrue(run.err().contains(words), run.err());
        assertFalse(run.err().contains(host + ": "), run.err());
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
