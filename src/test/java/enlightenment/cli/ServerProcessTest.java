package enlightenment.cli;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.net.ServerSocket;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.concurrent.TimeUnit;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;

/** Server and workers as processes of their own, which are killed as {@code kill -9} does. */
@Timeout(180)
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

    private final List<Process> started = new ArrayList<>();
    private Path scene;
    private Path picture;
    private int port;
    private Relay relay;

    /** What one process makes of the scene. */
    @BeforeAll
    static void renderAlone() throws IOException {
        Path file = common.resolve("alone.png");
        List<Object> args = new ArrayList<>(List.of("render", CliRun.scene(common, SIZE), "-o", file));
        args.addAll(WORK);
        CliRun run = CliRun.of(args.toArray());
        assertEquals(0, run.code(), run.err());
        alone = Files.readAllBytes(file);
    }

    @BeforeEach
    void scene() throws IOException {
        scene = CliRun.scene(folder, SIZE);
        picture = folder.resolve("picture.png");
        try (ServerSocket free = new ServerSocket(0)) {
            port = free.getLocalPort();
        }
        relay = new Relay(port, SOME_TILES);
    }

    @AfterEach
    void endAll() throws IOException, InterruptedException {
        relay.close();
        for (Process process : started) {
            process.destroyForcibly().waitFor();
        }
    }

    private Process start(String log, Object... args) throws IOException {
        List<String> command = new ArrayList<>(List.of(
                Path.of(System.getProperty("java.home"), "bin", "java").toString(),
                "-Xmx256m",
                "-XX:TieredStopAtLevel=1",
                "-XX:+UseSerialGC",
                "-cp",
                System.getProperty("java.class.path"),
                "enlightenment.cli.Main"));
        for (Object arg : args) {
            command.add(arg.toString());
        }
        Process process = new ProcessBuilder(command)
                .redirectErrorStream(true)
                .redirectOutput(folder.resolve(log).toFile())
                .start();
        started.add(process);
        return process;
    }

    private Process server(String log, Object... more) throws IOException {
        List<Object> args = new ArrayList<>(List.of("server", scene, "-o", picture, "--port", port));
        args.addAll(WORK);
        args.addAll(List.of("--local-threads", 0, "--wait", 60));
        args.addAll(List.of(more));
        return start(log, args.toArray());
    }

    private Process worker(String log, int at, Object... more) throws IOException {
        List<Object> args = new ArrayList<>(List.of("worker", "127.0.0.1:" + at, "--threads", 1));
        args.addAll(List.of(more));
        return start(log, args.toArray());
    }

    private String log(String name) {
        try {
            return Files.exists(folder.resolve(name)) ? Files.readString(folder.resolve(name)) : "";
        } catch (IOException e) {
            return e.toString();
        }
    }

    private String pin(String log) throws InterruptedException {
        Pattern pin = Pattern.compile(" --pin ([0-9a-f]{64})\\R");
        long end = System.nanoTime() + TimeUnit.SECONDS.toNanos(60);
        Matcher found = pin.matcher(log(log));
        while (!found.find()) {
            assertTrue(System.nanoTime() - end < 0, "waited in vain for a pin in: " + log(log));
            Thread.sleep(20);
            found = pin.matcher(log(log));
        }
        return found.group(1);
    }

    private void await(String log, String words) throws InterruptedException {
        long end = System.nanoTime() + TimeUnit.SECONDS.toNanos(60);
        while (!log(log).contains(words)) {
            assertTrue(System.nanoTime() - end < 0, "waited in vain for \"" + words + "\" in: " + log(log));
            Thread.sleep(20);
        }
    }

    /** Waits until half of what the relay passes on is kept; more than that the server does not get until the relay is freed. */
    private void awaitSomeTiles(Path checkpoint) throws IOException, InterruptedException {
        long end = System.nanoTime() + TimeUnit.SECONDS.toNanos(60);
        while (!Files.exists(checkpoint) || Files.size(checkpoint) < SOME_TILES / 2) {
            assertTrue(System.nanoTime() - end < 0, "waited in vain for tiles: " + log("server"));
            Thread.sleep(10);
        }
        assertFalse(Files.exists(picture));
    }

    private void assertEnds(Process process, int code, String log) throws InterruptedException {
        assertTrue(process.waitFor(90, TimeUnit.SECONDS), () -> log + " does not end: " + log(log));
        assertEquals(code, process.exitValue(), () -> log(log));
    }

    @Test
    void killedWorkersCostNothingButTime() throws Exception {
        Path checkpoint = folder.resolve("checkpoint");
        Process server = server("server", "--checkpoint", checkpoint);
        Process first = worker("first", relay.port());
        awaitSomeTiles(checkpoint);
        first.destroyForcibly().waitFor();
        await("server", "left:");
        Process second = worker("second", port);
        assertEnds(server, 0, "server");
        assertEnds(second, 0, "second");
        assertTrue(log("second").contains("the picture is done"), log("second"));
        assertArrayEquals(alone, Files.readAllBytes(picture));
    }

    @Test
    void aKilledServerGoesOnFromItsCheckpointWithTheSameWorkersAndSecrets() throws Exception {
        Path checkpoint = folder.resolve("checkpoint");
        Path token = folder.resolve("token");
        Object[] kept = {"--checkpoint", checkpoint, "--token-file", token, "--tls", folder.resolve("tls.pem")};
        Process server = server("server", kept);
        Process worker = worker("worker", relay.port(), "--token-file", token, "--pin", pin("server"));
        awaitSomeTiles(checkpoint);
        server.destroyForcibly().waitFor();
        assertFalse(Files.exists(picture));
        relay.free();
        Object[] more = Arrays.copyOf(kept, kept.length + 2);
        System.arraycopy(new Object[] {"--status-port", 0}, 0, more, kept.length, 2);
        Process again = server("again", more);
        assertEnds(again, 0, "again");
        assertEnds(worker, 0, "worker");
        assertTrue(log("again").contains("tiles are done already"), log("again"));
        assertTrue(log("worker").contains("trying again"), log("worker"));
        assertArrayEquals(alone, Files.readAllBytes(picture));
    }

    @Test
    void aServerThatIsAskedToEndWritesWhatItHas() throws Exception {
        Path checkpoint = folder.resolve("checkpoint");
        Process server = server("server", "--checkpoint", checkpoint);
        Process worker = worker("worker", relay.port());
        awaitSomeTiles(checkpoint);
        server.destroy();
        assertEnds(server, 143, "server");
        assertTrue(log("server").matches("(?s).*stopped: .* holds [1-9]\\d? % of the picture.*"), log("server"));
        assertTrue(Files.size(picture) > 0);
        worker.destroy();
        assertEnds(worker, 143, "worker");
        assertTrue(log("worker").contains("stopped; "), log("worker"));
    }
}
