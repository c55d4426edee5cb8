package enlightenment.cli.render;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.cli.CliRun;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** What holds with and without a driver. */
class DeviceCommandTest {
    @TempDir
    private Path folder;

    private CliRun render(String scene, String file, String... options) {
        String[] all = new String[options.length + 6];
        System.arraycopy(
                new String[] {
                    "render",
                    "scenes/" + scene + ".json",
                    "-o",
                    folder.resolve(file).toString(),
                    "--size",
                    "40x20"
                },
                0,
                all,
                0,
                6);
        System.arraycopy(options, 0, all, 6, options.length);
        return CliRun.of((Object[]) all);
    }

    @ParameterizedTest
    @CsvSource({
        "fog, raytrace, the scene has a medium that scatters light",
        "torus, raytrace, the scene has an object of the kind torus",
        "fire-and-ice, cluster, 'devices render by the method raytrace, not by cluster'",
    })
    void whatNoDeviceCanDoIsWrongUsage(String scene, String method, String reason) {
        CliRun run = render(scene, "x.png", "--method", method, "--device", "opencl");
        assertEquals(2, run.code());
        assertTrue(run.err().contains("--device cannot be opencl: " + reason), run.err());
        assertFalse(Files.exists(folder.resolve("x.png")));
    }

    @ParameterizedTest
    @CsvSource({"gpu", "opencl:", "opencl:-1", "opencl:256", "opencl:1x", "OPENCL"})
    void anotherWordIsWrongUsage(String word) {
        CliRun run = render("fire-and-ice", "x.png", "--device", word);
        assertEquals(2, run.code());
        assertTrue(run.err().contains("--device must be cpu, opencl, opencl:N"), run.err());
    }

    @Test
    void theAutomaticDeviceMakesTheSamePicture() throws IOException {
        assertEquals(0, render("fire-and-ice", "a.png").code());
        assertEquals(0, render("fire-and-ice", "b.png", "--device", "auto").code());
        assertArrayEquals(Files.readAllBytes(folder.resolve("a.png")), Files.readAllBytes(folder.resolve("b.png")));
        assertEquals(
                0,
                render("cornell-box", "c.png", "--samples", "1", "--device", "auto")
                        .code());
    }

    @Test
    void framesOfAnAnimationAreTheSameWithTheAutomaticDevice() throws IOException {
        for (String device : new String[] {"cpu", "auto"}) {
            CliRun run = CliRun.of(
                    "animate",
                    "scenes/bounce.json",
                    "-o",
                    folder.resolve(device + "-%02d.png").toString(),
                    "--frames",
                    "3-4",
                    "--size",
                    "40x20",
                    "--antialias",
                    "2",
                    "--device",
                    device);
            assertEquals(0, run.code(), run.err());
        }
        assertArrayEquals(
                Files.readAllBytes(folder.resolve("cpu-04.png")), Files.readAllBytes(folder.resolve("auto-04.png")));
    }

    @Test
    void framesNameWhatNoDeviceCanDo() {
        String frames = folder.resolve("%02d.png").toString();
        CliRun run = CliRun.of(
                "animate",
                "scenes/fire-and-ice-tween.json",
                "-o",
                frames,
                "--frames",
                "3-3",
                "--method",
                "cluster",
                "--device",
                "opencl");
        assertEquals(2, run.code());
        assertTrue(run.err().contains("--device cannot be opencl"), run.err());
    }

    @Test
    void theProcessorIsAlwaysListed() {
        CliRun run = CliRun.of("devices");
        assertEquals(0, run.code());
        assertTrue(run.outLines().get(0).matches("cpu +\\d+ threads, always there"), run.out());
    }
}
