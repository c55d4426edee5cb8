package enlightenment.cli.terminal;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.cli.CliRun;
import enlightenment.cli.Processes;
import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.atomic.AtomicReference;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.condition.DisabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.extension.RegisterExtension;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class ShutdownSignalTest {
    private static final int SIGTERM_EXIT = 128 + 15;

    @TempDir
    Path folder;

    @RegisterExtension
    final Processes processes = new Processes();

    @Test
    @Timeout(600)
    @DisabledOnOs(value = OS.WINDOWS, disabledReason = "a process cannot be asked to end there")
    void aSignalLeavesThePartOfThePictureThatIsDone() throws Exception {
        // Days of work, if nobody stopped it.
        Path scene = CliRun.scene(folder, "\"width\": 800, \"height\": 600");
        Path picture = folder.resolve("part.png");
        Processes.Running render = processes.start(
                folder,
                "render",
                scene,
                "-o",
                picture,
                "--antialias",
                16,
                "--shadow-samples",
                1000,
                "--threads",
                1,
                "--progress",
                "plain");
        render.until("something is rendered", () -> !render.said().isEmpty());
        render.process().destroy();
        String said = render.ended(SIGTERM_EXIT);
        String last = "enlightenment: stopped: \\Q" + picture + "\\E holds \\d+ % of the picture\n";
        assertTrue(said.matches("(?s)\\d+ % done.*\n" + last), said);
        BufferedImage image = ImageIO.read(picture.toFile());
        assertNotNull(image);
        assertEquals(800, image.getWidth());
    }

    /** The wish is heard in the middle of a tile: waiting for its end would take hours. */
    @ParameterizedTest
    @ValueSource(strings = {"raytrace", "cluster"})
    @Timeout(600)
    void aSignalEndsARenderOfWhichEachTileTakesHours(String method) throws IOException, InterruptedException {
        Path scene = Files.writeString(
                folder.resolve("scene.json"),
                """
                {
                  "image": { "width": 800, "height": 400 },
                  "camera": { "type": "perspective", "eye": [0.1, 0.2, 0], "lookAt": [1, 0, 0], "up": [0, 1, 0],
                              "fieldOfView": 40 },
                  "shading": { "maxBounces": 1000000 },
                  "materials": { "wall": { "type": "mirror", "color": "#ffffff" } },
                  "lights": [ { "type": "point", "position": [0, 0.5, 0], "color": "#ffffff" } ],
                  "objects": [ { "type": "sphere", "center": [0, 0, 0], "radius": 1, "material": "wall" } ]
                }
                """);
        Path picture = folder.resolve("part.png");
        ShutdownSignal stop = new ShutdownSignal();
        AtomicReference<CliRun> ended = new AtomicReference<>();
        Thread render = new Thread(() ->
                ended.set(CliRun.of(stop, "render", scene, "-o", picture, "--method", method, "--antialias", "16")));
        render.start();
        while (!isShading()) {
            assertTrue(render.isAlive(), "the render goes on until it is stopped");
            Thread.sleep(5);
        }
        stop.request();
        render.join();
        String message = "enlightenment: stopped before anything was rendered; " + picture + " was not written\n";
        assertEquals(new CliRun(1, "", message), ended.get());
        assertFalse(Files.exists(picture));
    }

    /** Whether some thread is inside a path of rays. */
    private static boolean isShading() {
        return Thread.getAllStackTraces().values().stream()
                .flatMap(Arrays::stream)
                .anyMatch(frame -> frame.getClassName().startsWith("enlightenment.transport."));
    }

    @Test
    void whatIsNotBroughtToAnEndIsGivenUpWithAWord() throws InterruptedException {
        CountDownLatch said = new CountDownLatch(1);
        ShutdownSignal stop = new ShutdownSignal(said::countDown, 0);
        stop.run();
        assertEquals(0, said.getCount());
    }

    @Test
    void whatHasFinishedIsNotWaitedFor() {
        ShutdownSignal stop = new ShutdownSignal();
        assertFalse(stop.getAsBoolean());
        stop.finished();
        assertFalse(stop.processIsEnding());
        stop.run();
        assertTrue(stop.getAsBoolean());
        assertTrue(stop.processIsEnding());
    }

    @Test
    void aWishFromInsideTheProcessLeavesTheExitCodeToTheCommand() {
        ShutdownSignal stop = new ShutdownSignal();
        stop.request();
        assertTrue(stop.getAsBoolean());
        assertFalse(stop.processIsEnding());
    }
}
