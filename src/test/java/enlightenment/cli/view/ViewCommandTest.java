package enlightenment.cli.view;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.cli.CliRun;
import enlightenment.cli.input.Failures;
import enlightenment.cli.terminal.ShutdownSignal;
import enlightenment.cli.terminal.Terminal;
import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStreamReader;
import java.io.PipedInputStream;
import java.io.PipedOutputStream;
import java.io.PrintStream;
import java.net.HttpURLConnection;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.net.URI;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.concurrent.FutureTask;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import picocli.CommandLine;

@Timeout(600)
class ViewCommandTest {
    private static final String TOLD = "enlightenment: the view: ";

    @TempDir
    private Path folder;

    /** A view under way, and what it says. */
    private static final class Running {
        final ShutdownSignal stop = new ShutdownSignal();
        final FutureTask<Integer> code;
        final BufferedReader err;
        final String address;

        Running(Object... args) throws IOException {
            PipedOutputStream said = new PipedOutputStream();
            err = new BufferedReader(
                    new InputStreamReader(new PipedInputStream(said, 1 << 16), StandardCharsets.UTF_8));
            PrintStream print = new PrintStream(said, true, StandardCharsets.UTF_8);
            Terminal terminal = new Terminal(print, print, stop);
            code = new FutureTask<>(() -> {
                try (print) {
                    return new CommandLine(new ViewCommand(terminal))
                            .registerConverter(Path.class, Path::of)
                            .setExecutionExceptionHandler(new Failures(terminal))
                            .execute(CliRun.texts(args));
                }
            });
            new Thread(code, "command").start();
            String line = err.readLine();
            assertTrue(line.startsWith(TOLD + "http://127.0.0.1:"), line);
            address = line.substring(TOLD.length()).replace(" (Ctrl-C ends it)", "");
        }

        /** Asks for an action, and gives the code of the answer. */
        int act(String query) throws IOException {
            String[] parts = address.split("#");
            URI uri = URI.create(parts[0] + "do?key=" + parts[1] + "&" + query);
            HttpURLConnection connection = (HttpURLConnection) uri.toURL().openConnection();
            connection.setRequestMethod("POST");
            return connection.getResponseCode();
        }
    }

    @Test
    void savedAtTheEndIsWhatWasSeen() throws Exception {
        Path scene = CliRun.scene(folder, "\"width\": 8, \"height\": 6");
        String before = Files.readString(scene);
        Running running = new Running(scene, "--save", "--threads", "1");
        assertEquals(200, running.act("action=dolly&x=2"));
        running.stop.request();
        assertEquals(0, running.code.get());
        assertEquals(before.replace("[0, 0, -5]", "[0, 0, -10]"), Files.readString(scene));
    }

    @Test
    void withoutThatTheFileStaysAsItIs() throws Exception {
        Path scene = CliRun.scene(folder, "\"width\": 8, \"height\": 6");
        String before = Files.readString(scene);
        Running running = new Running(scene);
        assertEquals(200, running.act("action=dolly&x=2"));
        running.stop.request();
        assertEquals(0, running.code.get());
        assertEquals(before, Files.readString(scene));
    }

    @Test
    void modelsAreSeenButNotWritten() throws Exception {
        Path model = Files.writeString(folder.resolve("a.obj"), "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
        Running running = new Running(model, "--view", "30,20", "--save", "--samples", "1");
        assertEquals(200, running.act("action=orbit&x=5&y=5"));
        assertEquals(409, running.act("action=save"));
        running.stop.request();
        assertEquals(1, running.code.get());
        String refusal = running.err.lines().reduce((a, b) -> b).orElseThrow();
        assertTrue(refusal.startsWith("enlightenment: --save: this is a file of another program"), refusal);
        assertEquals("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n", Files.readString(model));
    }

    @Test
    void aBrokenSceneIsRefusedAtOnceWithItsPlaces() throws Exception {
        CliRun run = CliRun.of("view", CliRun.badScene(folder));
        assertEquals(2, run.code());
        assertEquals(3, run.errLines().size(), run.err());
        assertTrue(run.errLines().get(0).contains("bad.json:"), run.err());
    }

    @ParameterizedTest
    @ValueSource(strings = {"none.json", "none.obj"})
    void aFileThatIsNotThereIsRefusedInALine(String name) {
        CliRun run = CliRun.of("view", folder.resolve(name));
        assertEquals(2, run.code());
        assertEquals(1, run.errLines().size(), run.err());
        assertTrue(run.err().contains(name) && run.err().contains("no such file"), run.err());
    }

    @Test
    void standardInputAndOptionsThatDoNotFitAreRefused() throws Exception {
        Path scene = CliRun.scene(folder, "\"width\": 8, \"height\": 6");
        assertEquals(
                "enlightenment: view needs a file that it can watch, not standard input\n",
                CliRun.of("view", "-").err());
        CliRun foreign = CliRun.of("view", scene, "--up", "z");
        assertEquals(2, foreign.code());
        assertTrue(foreign.err().contains("--up is for files of other programs"), foreign.err());
        CliRun samples = CliRun.of("view", scene, "--samples", "0");
        assertEquals(2, samples.code());
    }

    @Test
    void aPortThatIsTakenIsToldInALine() throws Exception {
        Path scene = CliRun.scene(folder, "\"width\": 8, \"height\": 6");
        try (ServerSocket taken = new ServerSocket(0, 1, InetAddress.getLoopbackAddress())) {
            CliRun run = CliRun.of("view", scene, "--port", taken.getLocalPort());
            assertEquals(1, run.code());
            assertEquals(1, run.errLines().size(), run.err());
            assertTrue(run.err().startsWith("enlightenment: --port: cannot listen at port "), run.err());
        }
    }

    @Test
    void browsersAreStartedByWhatTheSystemHas() {
        assertEquals(List.of("xdg-open", "http://a"), Browser.command("Linux", "http://a"));
        assertEquals(List.of("open", "http://a"), Browser.command("Mac OS X", "http://a"));
        assertEquals("rundll32", Browser.command("Windows 11", "http://a").get(0));
    }
}
