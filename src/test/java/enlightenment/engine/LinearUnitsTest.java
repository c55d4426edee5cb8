package enlightenment.engine;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.color.Color;
import enlightenment.color.DisplayCurve;
import enlightenment.image.Image;
import enlightenment.render.RenderProgress;
import enlightenment.render.RenderResult;
import enlightenment.render.Renderer;
import enlightenment.scene.RenderSettings;
import enlightenment.scene.Scene;
import enlightenment.scene.json.SceneReader;
import java.nio.ByteBuffer;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Units of pictures of linear light, as bytes. */
class LinearUnitsTest {
    @TempDir
    Path folder;

    private Scene scene() throws Exception {
        Path file = folder.resolve("scene.json");
        String cornell = Files.readString(Path.of("src/test/resources/physical/cornell.json"));
        Files.writeString(
                file,
                cornell.replaceFirst(
                        "\"shading\"", "\"display\": { \"exposure\": 1.5, \"tone\": \"filmic\" }, \"shading\""));
        return SceneReader.read(file);
    }

    private static RenderSettings settings(Scene scene, int side, double samples) {
        return RenderSettings.of(scene)
                .withSize(side, side)
                .withThreads(2)
                .withBudget(RenderSettings.Budget.NONE.withSamples(samples));
    }

    @ParameterizedTest
    @ValueSource(doubles = {1, 2, 5.5, 16})
    void madeAnywhereInAnyOrderTheyMakeThePictureAndTheReportOfTheRenderer(double samples) throws Exception {
        check(settings(scene(), 24, samples));
    }

    @Test
    void passesDoSoToo() throws Exception {
        RenderSettings settings = settings(scene(), 2, 1 << 18);
        DividedRender divided = DividedRender.prepare(scene(), settings, () -> false);
        assertTrue(divided.units() >= 4);
        check(settings);
    }

    private void check(RenderSettings settings) throws Exception {
        Scene scene = scene();
        DividedRender divided = DividedRender.prepare(scene, settings, () -> false);
        FilmAssembly assembly = divided.assembly();
        List<Integer> order = new ArrayList<>();
        for (int unit = 0; unit < divided.units(); unit++) {
            order.add(unit);
        }
        Collections.shuffle(order, new Random(7));
        for (int unit : order) {
            assembly.put(unit, divided.maker().make(unit));
        }
        RenderResult expected = Renderer.render(scene, settings, RenderProgress.NONE, () -> false);
        Rendered actual = assembly.result();
        assertArrayEquals(expected.image().toArray(), actual.image().toArray());
        assertEquals(expected.report().sampling(), actual.report().sampling());
        assertEquals(
                DisplayCurve.of(1.5, DisplayCurve.Tone.FILMIC), actual.image().curve());
        assertEquals(expected.image().curve(), actual.image().curve());
        assertEquals(0, actual.report().lostSamples());
    }

    @Test
    void whatIsNoLightIsRefused() throws Exception {
        RenderSettings settings = settings(scene(), 16, 4);
        DividedRender divided = DividedRender.prepare(scene(), settings, () -> false);
        FilmAssembly assembly = divided.assembly();
        byte[] good = divided.maker().make(0);
        assertTrue(assembly.problem(0, good).isEmpty());
        // The last number is the mean of a quarter.
        byte[] bad = good.clone();
        ByteBuffer.wrap(bad).putFloat(bad.length - Float.BYTES, Float.NaN);
        assertFalse(assembly.problem(0, bad).isEmpty());
        assertEquals(
                "it has " + (good.length - 1) + " bytes instead of " + good.length,
                assembly.problem(0, java.util.Arrays.copyOf(good, good.length - 1))
                        .orElseThrow());
    }

    @Test
    void aPreviewIsShownAsThePictureIs() throws Exception {
        List<Image> seen = Collections.synchronizedList(new ArrayList<>());
        Renderer.render(enlightenment.render.RenderRequest.of(scene(), settings(scene(), 24, 4))
                .withProgressive(true)
                .withProgress(new RenderProgress() {
                    @Override
                    public void progress(long done, long total, java.util.function.Supplier<Image> soFar) {
                        seen.add(soFar.get());
                    }
                }));
        assertFalse(seen.isEmpty());
        for (Image image : seen) {
            assertEquals(Color.Encoding.LINEAR, image.encoding());
            assertEquals(DisplayCurve.of(1.5, DisplayCurve.Tone.FILMIC), image.curve());
        }
    }
}
