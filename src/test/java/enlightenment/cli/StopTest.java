package enlightenment.cli;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.condition.DisabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;

class StopTest {
    private static final int SIGTERM_EXIT = 128 + 15;

    @TempDir
    Path folder;

    @Test
    @Timeout(300)
    @DisabledOnOs(value = OS.WINDOWS, disabledReason = "a process cannot be asked to end there")
    void aSignalLeavesThePartOfThePictureThatIsDone() throws IOException, InterruptedException {
        // Days of work, if nobody stopped it.
        Path scene = CliRun.scene(folder, "\"width\": 2000, \"height\": 2000");
        Path picture = folder.resolve("part.png");
        Path err = folder.resolve("err.txt");
        Process process = new ProcessBuilder(
                        Path.of(System.getProperty("java.home"), "bin", "java").toString(),
                        "-cp",
                        System.getProperty("java.class.path"),
                        "enlightenment.cli.Main",
                        "render",
                        scene.toString(),
                        "-o",
                        picture.toString(),
                        "--antialias",
                        "16",
                        "--shadow-samples",
                        "100",
                        "--progress",
                        "plain")
                .redirectError(err.toFile())
                .start();
        try {
            // The first line of progress tells that something is rendered.
            while (Files.size(err) == 0) {
                assertTrue(process.isAlive(), "the render goes on until it is stopped");
                Thread.sleep(20);
            }
            process.destroy();
            process.waitFor();
        } finally {
            process.destroyForcibly();
        }
        assertEquals(SIGTERM_EXIT, process.exitValue());
        String said = Files.readString(err);
        String last = "enlightenment: stopped: \\Q" + picture + "\\E holds \\d+ % of the picture\n";
        assertTrue(said.matches("(?s)\\d+ % done.*\n" + last), said);
        BufferedImage image = ImageIO.read(picture.toFile());
        assertNotNull(image);
        assertEquals(2000, image.getWidth());
    }

    @Test
    void whatHasFinishedIsNotWaitedFor() {
        Stop stop = new Stop();
        assertFalse(stop.getAsBoolean());
        stop.finished();
        stop.run();
        assertTrue(stop.getAsBoolean());
    }
}
