package enlightenment.render;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.scene.Method;
import enlightenment.scene.RenderSettings;
import enlightenment.scene.Scene;
import enlightenment.scene.json.SceneReader;
import java.nio.file.Path;
import java.util.concurrent.CancellationException;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** A scene that is prepared once for several renders. */
class PreparedRenderTest {
    private static final Scene SCENE = SceneReader.read(Path.of("scenes/knot.json"));

    private static RenderSettings settings(Method method) {
        return RenderSettings.of(SCENE)
                .withMethod(method)
                .withSize(24, 12)
                .withThreads(1)
                .withBudget(RenderSettings.Budget.NONE.withSamples(1));
    }

    private static Film film() {
        return Film.of(1, 1, frame -> SCENE);
    }

    private static void assertSame(RenderSettings settings, RenderResult result) {
        assertArrayEquals(
                Renderer.render(SCENE, settings).toArray(), result.image().toArray());
    }

    @ParameterizedTest
    @ValueSource(strings = {"raytrace", "bidirectional", "auto"})
    void picturesAreThoseOfRendersThatPrepareTheScene(String word) {
        Film film = film();
        RenderSettings first = settings(Method.named(word));
        RenderRequest.MethodChoice prepared = film.prepare(SCENE, first, () -> false);
        RenderSettings[] all = {
            first.withSeed(7),
            first.withBudget(RenderSettings.Budget.NONE.withSamples(3)),
            first.withCrop(new RenderSettings.Crop(5, 3, 4, 4))
        };
        for (RenderSettings settings : all) {
            RenderRequest request = RenderRequest.of(SCENE, settings).withChoice(prepared.with(settings));
            RenderResult result = film.render(request);
            assertSame(settings.withMethod(prepared.settings().method()), result);
            assertTrue(result.report().phases().stream().noneMatch(p -> p.name().equals("compile")));
        }
    }

    /** What one scene has in common with the next changes nothing, whatever came before. */
    @Test
    void tablesOfMaterialsAreTheSameInAFilm() {
        Film film = film();
        RenderSettings settings = settings(RenderSettings.of(SCENE).method());
        Scene other = SceneReader.read(Path.of("scenes/metals.json"));
        for (Scene scene : new Scene[] {SCENE, SCENE, other, SCENE}) {
            RenderResult result = film.render(RenderRequest.of(scene, settings));
            assertArrayEquals(
                    Renderer.render(scene, settings).toArray(), result.image().toArray());
        }
    }

    @Test
    void anotherSizeIsRefused() {
        RenderSettings settings = settings(RenderSettings.of(SCENE).method());
        RenderRequest.MethodChoice prepared = film().prepare(SCENE, settings, () -> false);
        IllegalArgumentException e =
                assertThrows(IllegalArgumentException.class, () -> prepared.with(settings.withSize(12, 24)));
        assertEquals("prepared for 24x12 pixels, not for 12x24", e.getMessage());
    }

    @Test
    void preparationCanBeCancelled() {
        Scene several = SceneReader.read(Path.of("scenes/fire-and-ice.json"));
        assertThrows(
                CancellationException.class, () -> film().prepare(several, RenderSettings.of(several), () -> true));
    }
}
