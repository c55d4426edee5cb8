package enlightenment.cli.serve;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.cli.CliRun;
import enlightenment.cli.Processes;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.regex.Pattern;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.extension.RegisterExtension;
import org.junit.jupiter.api.io.TempDir;

/** Server and workers as processes of their own, which are killed as {@code kill -9} does. */
@Timeout(600)
class ServerProcessTest {
    private static final String SIZE = "\"width\": 96, \"height\": 72";

    private static final List<Object> WORK = List.of("--antialias", 2, "--shadow-samples", 2);

    /** What the first worker may say: some of the 108 tiles, which have 64 pixels of three numbers at least. */
    private static final int SOME_TILES = 108 * 64 * 3 * Double.BYTES / 3;

    @TempDir
    static Path common;

    private static byte[] alone;

    @TempDir
    Path folder;

    @RegisterExtension
    final Processes processes = new Processes();

    private Path scene;
    private Path picture;
    private Relay relay;

    /** What one process makes of the scene. */
    @BeforeAll
    static void renderAlone() throws IOException {
        List<Object> args =
                new ArrayList<>(List.of("render", CliRun.scene(common, SIZE), "-o", common.resolve("alone.png")));
        args.addAll(WORK);
        alone = CliRun.picture(args.toArray());
    }

    @BeforeEach
    void scene() throws IOException {
        scene = CliRun.scene(folder, SIZE);
        picture = folder.resolve("picture.png");
        relay = new Relay(SOME_TILES);
    }

    @AfterEach
    void endRelay() throws IOException {
        relay.close();
    }

    /** A server at any port that is free: one that was free before may be somebody else's by now. The relay leads to it. */
    private Processes.Running server(Object... more) throws Exception {
        List<Object> args = new ArrayList<>(List.of("server", scene, "-o", picture, "--port", 0));
        args.addAll(WORK);
        args.addAll(List.of("--local-threads", 0, "--wait", 600));
        args.addAll(List.of(more));
        Processes.Running server = processes.start(folder, args.toArray());
        relay.leadTo(port(server));
        return server;
    }

    /** Where a server listens, once it says so. */
    private static int port(Processes.Running server) throws Exception {
        return Integer.parseInt(said(server, " worker 127\\.0\\.0\\.1:(\\d+)\\s"));
    }

    /** What it says at the first place that matches. */
    private static String said(Processes.Running server, String words) throws Exception {
        Pattern pattern = Pattern.compile(words);
        server.until("it says " + words, () -> pattern.matcher(server.said()).find());
        return pattern.matcher(server.said())
                .results()
                .findFirst()
                .orElseThrow()
                .group(1);
    }

    private Processes.Running worker(int at, Object... more) throws IOException {
        List<Object> args = new ArrayList<>(List.of("worker", "127.0.0.1:" + at, "--threads", 1, "--reconnect", 600));
        args.addAll(List.of(more));
        return processes.start(folder, args.toArray());
    }

    private static String pin(Processes.Running server) throws Exception {
        return said(server, " --pin ([0-9a-f]{64})\\R");
    }

    /** Waits until half of what the relay passes on is kept; more than that the server does not get until the relay is freed. */
    private void awaitSomeTiles(Processes.Running server, Path checkpoint) throws Exception {
        server.until("there are tiles", () -> checkpoint.toFile().length() >= SOME_TILES / 2);
        assertFalse(Files.exists(picture));
    }

    @Test
    void killedWorkersCostNothingButTime() throws Exception {
        Path checkpoint = folder.resolve("checkpoint");
        Processes.Running server = server("--checkpoint", checkpoint);
        Processes.Running first = worker(relay.port());
        awaitSomeTiles(server, checkpoint);
        first.kill();
        server.untilSaid("left:");
        Processes.Running second = worker(port(server));
        server.ended(0);
        String said = second.ended(0);
        assertTrue(said.contains("the picture is done"), said);
        assertArrayEquals(alone, Files.readAllBytes(picture));
    }

    @Test
    void aKilledServerGoesOnFromItsCheckpointWithTheSameWorkersAndSecrets() throws Exception {
        Path checkpoint = folder.resolve("checkpoint");
        Path token = folder.resolve("token");
        Object[] kept = {"--checkpoint", checkpoint, "--token-file", token, "--tls", folder.resolve("tls.pem")};
        Processes.Running server = server(kept);
        Processes.Running worker = worker(relay.port(), "--token-file", token, "--pin", pin(server));
        awaitSomeTiles(server, checkpoint);
        server.kill();
        assertFalse(Files.exists(picture));
        relay.free();
        Object[] more = Arrays.copyOf(kept, kept.length + 2);
        System.arraycopy(new Object[] {"--status-port", 0}, 0, more, kept.length, 2);
        String again = server(more).ended(0);
        String said = worker.ended(0);
        assertTrue(again.contains("tiles are done already"), again);
        assertTrue(said.contains("trying again"), said);
        assertArrayEquals(alone, Files.readAllBytes(picture));
    }

    @Test
    void aServerThatIsAskedToEndWritesWhatItHas() throws Exception {
        Path checkpoint = folder.resolve("checkpoint");
        Processes.Running server = server("--checkpoint", checkpoint);
        Processes.Running worker = worker(relay.port());
        awaitSomeTiles(server, checkpoint);
        server.process().destroy();
        String said = server.ended(143);
        assertTrue(said.matches("(?s).*stopped: .* holds [1-9]\\d? % of the picture.*"), said);
        assertTrue(Files.size(picture) > 0);
        worker.process().destroy();
        String last = worker.ended(143);
        assertTrue(last.contains("stopped; "), last);
    }
}
