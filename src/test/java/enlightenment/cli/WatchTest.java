package enlightenment.cli;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.cli.terminal.ShutdownSignal;
import enlightenment.cli.terminal.Terminal;
import java.io.BufferedReader;
import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.io.InputStreamReader;
import java.io.PipedInputStream;
import java.io.PipedOutputStream;
import java.io.PrintStream;
import java.net.ConnectException;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.net.Socket;
import java.net.URI;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.concurrent.FutureTask;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.ObjectMapper;

/** Renders that are watched: on a page, or in a window where there is no display. */
@Timeout(600)
class WatchTest extends SceneFixture {
    private static final String TOLD = "enlightenment: the picture so far: ";

    WatchTest() {
        super(40, 24);
    }

    /** A command under way, and what it says. */
    private static final class Running {
        final ShutdownSignal stop = new ShutdownSignal();
        final FutureTask<Integer> code;
        final BufferedReader err;

        Running(Object... args) throws IOException {
            PipedOutputStream said = new PipedOutputStream();
            err = new BufferedReader(
                    new InputStreamReader(new PipedInputStream(said, 1 << 16), StandardCharsets.UTF_8));
            PrintStream print = new PrintStream(said, true, StandardCharsets.UTF_8);
            code = new FutureTask<>(() -> {
                try (print) {
                    return Main.run(CliRun.quiet(CliRun.texts(args)), new Terminal(print, print, stop));
                }
            });
            new Thread(code, "command").start();
        }

        String address() throws IOException {
            String line = err.readLine();
            assertTrue(line.startsWith(TOLD + "http://127.0.0.1:"), line);
            return line.substring(TOLD.length());
        }
    }

    private static byte[] get(String address) throws IOException {
        try (var in = URI.create(address).toURL().openStream()) {
            return in.readAllBytes();
        }
    }

    private static JsonNode json(String address) throws IOException {
        return new ObjectMapper().readTree(get(address));
    }

    /** Waits until it renders, and there is a picture to look at. */
    private static void untilShown(String address) throws Exception {
        JsonNode status = json(address + "status.json");
        while (!status.get("state").asString().equals("rendering")
                || status.get("picture").asLong() == 0) {
            Thread.sleep(5);
            status = json(address + "status.json");
        }
    }

    /** Until some of it is finished, and not only shown coarsely. */
    private static void untilBegun(String address) throws Exception {
        while (json(address + "status.json").get("done").asLong() == 0) {
            Thread.sleep(5);
        }
    }

    /** Whether somebody listens there. */
    private static boolean isHeard(int port) throws IOException {
        try {
            new Socket(InetAddress.getLoopbackAddress(), port).close();
            return true;
        } catch (ConnectException e) {
            return false;
        }
    }

    /** More than a test can wait for, in units of less than a second. */
    private Running endless(Object... more) throws IOException {
        Object[] args = {
            "render", scene, "-o", picture, "--size", "1000x600", "--samples", "4000", "--threads", "2", "--serve"
        };
        Object[] all = java.util.Arrays.copyOf(args, args.length + more.length);
        System.arraycopy(more, 0, all, args.length, more.length);
        return new Running(all);
    }

    @Test
    void aRenderIsShownWhileItRunsAndNoLonger() throws Exception {
        Running run = endless();
        String address = run.address();
        untilShown(address);
        JsonNode status = json(address + "status.json");
        assertEquals("Two balls", status.get("title").asString());
        assertEquals(600_000, status.get("total").asLong());
        assertEquals(4000, status.get("samplesPerPixel").asDouble());
        assertEquals("raytrace", status.get("method").asString());
        assertEquals(
                1000,
                ImageIO.read(new ByteArrayInputStream(get(address + "picture.png")))
                        .getWidth());
        untilBegun(address);
        run.stop.request();
        assertEquals(1, run.code.get());
        assertTrue(run.err.readLine().startsWith("enlightenment: stopped: " + picture + " holds "));
        assertTrue(Files.exists(picture));
        int port = URI.create(address).getPort();
        // The thread that listened there may need a moment to let go of the place.
        while (isHeard(port)) {
            Thread.sleep(5);
        }
    }

    @Test
    void thePictureHasTheSameBytesAsIfNobodyLooked() throws Exception {
        assertEquals(new CliRun(0, "", ""), CliRun.of("render", scene, "-o", picture));
        Path watched = folder.resolve("watched.png");
        CliRun run = CliRun.of("render", "--serve", scene, "-o", watched);
        assertEquals(0, run.code());
        assertTrue(run.err().startsWith(TOLD), run.err());
        assertEquals(1, run.errLines().size());
        assertArrayEquals(Files.readAllBytes(picture), Files.readAllBytes(watched));
    }

    @Test
    void onlyANumberIsAPort() {
        for (Object[] args : new Object[][] {
            {"render", "--serve", "0", scene, "-o", picture},
            {"render", "--serve=0", scene, "-o", picture},
            {"render", scene, "--serve", "-o", picture},
            {"render", scene, "-o", picture, "--serve"}
        }) {
            CliRun run = CliRun.of(args);
            assertEquals(0, run.code(), run.err());
        }
        for (String bad : new String[] {"--serve=x", "--serve=", "--serve=-1", "--serve=65536"}) {
            CliRun run = CliRun.of("render", scene, "-o", picture, bad);
            assertEquals(2, run.code());
            assertEquals(
                    "enlightenment: --serve must be a whole number in 0..65535, not \"" + bad.substring(8) + "\"\n",
                    run.err());
        }
    }

    @Test
    void aPortThatIsInUseIsOneLineAndNothingIsRendered() throws Exception {
        try (ServerSocket taken = new ServerSocket(0, 1, InetAddress.getLoopbackAddress())) {
            CliRun run = CliRun.of("render", scene, "-o", picture, "--serve", taken.getLocalPort());
            assertEquals(1, run.code());
            assertEquals(1, run.errLines().size(), run.err());
            assertTrue(run.err().contains("cannot listen at port " + taken.getLocalPort()), run.err());
            assertFalse(Files.exists(picture));
        }
    }

    @Test
    void withoutADisplayAWindowIsOneLineAndNothingIsRendered() {
        CliRun run = CliRun.of("render", scene, "-o", picture, "--window", "--serve");
        assertEquals(1, run.code());
        assertEquals(List.of("enlightenment: --window: no display; try --serve"), run.errLines());
        assertFalse(Files.exists(picture));
    }

    @Test
    void partsHaveNoPictureToLookAt() {
        CliRun run = CliRun.of("render", scene, "-o", folder.resolve("p.film"), "--part", "1/2", "--serve");
        assertEquals(2, run.code());
        assertTrue(run.err().contains("--serve, --window"), run.err());
    }

    @Test
    void whatIsMissedIsSaidAllTheSame() throws Exception {
        CliRun run = CliRun.of(
                "render", scene, "-o", picture, "--serve", "--error", "0.002", "--samples", "1", "--shadow-samples", 1);
        assertEquals(1, run.code());
        assertEquals(2, run.errLines().size(), run.err());
    }

    @Test
    void framesOfAFilmAreNamed() throws Exception {
        Path film = Files.writeString(
                folder.resolve("film.json"),
                Files.readString(scene)
                        .replace(
                                "\"image\"",
                                "\"animation\": { \"frames\": 2, \"framesPerSecond\": 24, \"tracks\": [ { \"target\": \"/objects/0/center/0\", \"keys\": { \"0\": 0, \"1\": 1 } } ] },\n"
                                        + "  \"image\""));
        Running run = new Running(
                "animate", film, "-o", folder.resolve("f%04d.png"), "--size", "1000x600", "--samples", 4000, "--serve");
        String address = run.address();
        untilShown(address);
        JsonNode status = json(address + "status.json");
        assertEquals("Two balls, frame 0", status.get("title").asString());
        assertEquals(1_200_000, status.get("total").asLong());
        run.stop.request();
        assertEquals(1, run.code.get());
    }
}
