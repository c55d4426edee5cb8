package enlightenment.cli;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import enlightenment.process.JavaProcess;
import java.io.BufferedReader;
import java.io.File;
import java.io.IOException;
import java.io.InputStreamReader;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;

/** The window on a real X server without a screen, Xvfb, where there is one on the path. */
@Timeout(600)
class WindowTest {
    private static Process server;
    private static String display;

    @TempDir
    Path folder;

    @BeforeAll
    static void startServer() throws IOException {
        String path = System.getenv().getOrDefault("PATH", "");
        boolean isAvailable =
                Stream.of(path.split(File.pathSeparator)).anyMatch(place -> Files.isExecutable(Path.of(place, "Xvfb")));
        assumeTrue(isAvailable, "no Xvfb on the path");
        // It chooses a number that is free, and tells it when it is ready.
        server = new ProcessBuilder("Xvfb", "-displayfd", "1", "-screen", "0", "1000x800x24", "-nolisten", "tcp")
                .redirectError(ProcessBuilder.Redirect.DISCARD)
                .start();
        display = server.inputReader().readLine();
        assumeTrue(display != null, "Xvfb does not start here");
    }

    @AfterAll
    static void endServer() throws InterruptedException {
        if (server != null) {
            server.destroy();
            server.waitFor();
        }
    }

    private record Seen(int code, List<String> lines) {}

    private Seen probe(String what, Path picture, Object... command) throws Exception {
        Object[] args =
                Stream.concat(Stream.of(what, picture), Stream.of(command)).toArray();
        ProcessBuilder builder = JavaProcess.of(WindowProbe.class, args).redirectErrorStream(true);
        builder.environment().put("DISPLAY", ":" + display);
        Process process = builder.start();
        try (BufferedReader out =
                new BufferedReader(new InputStreamReader(process.getInputStream(), StandardCharsets.UTF_8))) {
            List<String> lines = out.lines().toList();
            return new Seen(process.waitFor(), lines);
        } finally {
            process.destroyForcibly();
        }
    }

    @Test
    void theFinishedPictureStaysInViewUntilTheWindowIsClosed() throws Exception {
        Path scene = CliRun.scene(folder, "\"width\": 40, \"height\": 24");
        Path picture = folder.resolve("p.png");
        Path alone = folder.resolve("alone.png");
        assertEquals(0, CliRun.of("render", scene, "-o", alone).code());
        Seen seen = probe("finished", picture, "render", scene, "-o", picture, "--window", "--progress", "none");
        assertEquals(
                List.of(
                        "enlightenment: done; the command ends when the window is closed",
                        "title finished \u2013 Two balls",
                        "shown 15 times as large",
                        "ended with 0"),
                seen.lines);
        assertEquals(0, seen.code);
        assertArrayEquals(Files.readAllBytes(alone), Files.readAllBytes(picture));
    }

    @Test
    void closingTheWindowStopsTheRenderWithWhatThereIs() throws Exception {
        Path scene = CliRun.scene(folder, "\"width\": 1000, \"height\": 600");
        Path picture = folder.resolve("p.png");
        Seen seen = probe(
                "growing",
                picture,
                "render",
                scene,
                "-o",
                picture,
                "--window",
                "--samples",
                4000,
                "--progress",
                "none");
        assertEquals(1, seen.code, seen.lines.toString());
        assertTrue(seen.lines.contains("something is lit"), seen.lines.toString());
        assertTrue(
                seen.lines.stream().anyMatch(line -> line.startsWith("enlightenment: stopped: " + picture + " holds ")),
                seen.lines.toString());
        assertTrue(Files.exists(picture));
    }
}
