package enlightenment.render;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.math.InvalidValueException;
import enlightenment.process.JavaProcess;
import enlightenment.scene.BuiltInMethod;
import enlightenment.scene.RenderSettings;
import enlightenment.scene.Scene;
import enlightenment.scene.json.SceneReader;
import enlightenment.work.PictureMemory;
import enlightenment.work.PictureMemory.Films;
import java.io.IOException;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** What pictures are said to need, against what they need. */
class PictureMemoryTest {
    private static final Scene ROOM = SceneReader.read(Path.of("scenes/cornell-box.json"));

    /** Classes, the scene, and what the collector of garbage cannot use between large arrays. */
    private static final int PROGRAM = 24;

    /** Of 1,000,000 pixels. */
    private static long bytes(boolean isLinear, Films films, int images) {
        RenderSettings settings = RenderSettings.of(ROOM).withSize(1000, 1000);
        return new PictureMemory(settings, isLinear, films, images).bytes();
    }

    @Test
    void filmsImagesAndErrorsAreCounted() {
        // Doubles of three colours, two figures and a number of samples; three floats; a variance.
        assertEquals((24 + 4 + 4 + 4 + 12 + 4) * 1_000_000, bytes(false, Films.TILES, 0));
        // Means of four quarters; two figures, and whether they are of rare light.
        assertEquals((52 + 4 * 12 + 4 + 4 + 1) * 1_000_000, bytes(true, Films.TILES, 0));
        // Four groups of three longs; a variance in double precision.
        assertEquals((4 * 24 + 12 + 4 + 8) * 1_000_000, bytes(true, Films.SPLATS, 0));
        // The sum of both, and four figures where there are few samples.
        assertEquals((109 + 4 * 24 + 84 + 16) * 1_000_000, bytes(true, Films.BOTH, 0));
        assertEquals((52 + 4 * 24 + 36 + 3 * 12) * 1_000_000, bytes(false, Films.BOTH, 3));
    }

    @Test
    void aPictureBeyondTheMemoryIsRefusedAndOneWithinIsNot() {
        long most = Runtime.getRuntime().maxMemory();
        int columns = (int) Math.min(most / 109 / 1000, 1_000_000);
        for (int share : new int[] {90, 110}) {
            RenderSettings settings = RenderSettings.of(ROOM).withSize(Math.max(columns * share / 100, 1), 1000);
            PictureMemory memory = PictureMemory.of(ROOM, settings, Films.TILES, 0);
            assertEquals(share < 100, memory.isEnough());
            try {
                memory.check("; why");
                assertTrue(memory.isEnough());
            } catch (InvalidValueException e) {
                assertFalse(memory.isEnough());
                assertEquals("size", e.key());
                assertTrue(e.getMessage().contains(" needs " + memory.bytes() + " bytes of memory; at most "));
                assertTrue(e.getMessage().endsWith(" pixels; why"));
            }
        }
    }

    @ParameterizedTest
    @CsvSource({"scenes/cylinders.json, RAYTRACE, TILES", "scenes/cornell-box.json, BIDIRECTIONAL, BOTH"})
    void asMuchMemoryIsEnough(String file, BuiltInMethod method, Films films) throws IOException, InterruptedException {
        Scene scene = SceneReader.read(Path.of(file));
        RenderSettings settings = RenderSettings.of(scene).withSize(900, 700);
        int heap = PROGRAM + (int) (PictureMemory.of(scene, settings, films, 0).bytes() >> 20);
        ProcessBuilder builder = JavaProcess.of(PictureMemoryTest.class, file, method.name(), 900, 700)
                .redirectErrorStream(true);
        // Java's usual collector of garbage: others leave generations half empty.
        builder.command()
                .replaceAll(o ->
                        o.startsWith("-Xmx") ? "-Xmx" + heap + "m" : o.equals("-XX:+UseSerialGC") ? "-XX:+UseG1GC" : o);
        Process process = builder.start();
        String output = new String(process.getInputStream().readAllBytes());
        process.waitFor();
        assertTrue(output.contains("complete: true"), output);
    }

    /** Renders with one sample, in memory. */
    public static void main(String[] args) {
        Scene scene = SceneReader.read(Path.of(args[0]));
        RenderSettings settings = RenderSettings.of(scene)
                .withMethod(BuiltInMethod.valueOf(args[1]))
                .withSize(Integer.parseInt(args[2]), Integer.parseInt(args[3]))
                .withBudget(RenderSettings.Budget.NONE.withSamples(1));
        System.out.println("complete: "
                + Renderer.render(RenderRequest.of(scene, settings)).complete());
    }
}
