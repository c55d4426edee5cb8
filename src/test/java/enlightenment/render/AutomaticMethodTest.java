package enlightenment.render;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.engine.DividedRender;
import enlightenment.scene.BuiltInMethod;
import enlightenment.scene.Method;
import enlightenment.scene.RenderSettings;
import enlightenment.scene.RenderSettings.Crop;
import enlightenment.scene.Scene;
import enlightenment.scene.json.SceneReader;
import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.CancellationException;
import org.junit.jupiter.api.Test;

/** The method that the program chooses takes the place of {@link Method#AUTO} everywhere, and is the same everywhere. */
class AutomaticMethodTest {
    /** Enough that a pilot is worth it. */
    private static final double MANY = 1024;

    private static Scene scene(String name) throws IOException {
        return SceneReader.read(Path.of("scenes", name + ".json"));
    }

    private static RenderSettings auto(Scene scene, double samples) {
        return RenderSettings.of(scene)
                .withMethod(Method.AUTO)
                .withSize(48, 32)
                .withBudget(RenderSettings.Budget.NONE.withSamples(samples))
                .withThreads(2);
    }

    private static Method chosen(Scene scene, RenderSettings settings) {
        return Renderer.choose(scene, settings, () -> false).settings().method();
    }

    @Test
    void theChoiceDependsNeitherOnThreadsNorOnTilesNorOnTheCrop() throws IOException {
        Scene scene = scene("door-ajar");
        RenderSettings settings = auto(scene, MANY);
        String reason = Renderer.choose(scene, settings, () -> false).reason().orElseThrow();
        for (RenderSettings other : List.of(
                settings.withThreads(1),
                settings.withThreads(5).withTileSize(32),
                settings.withCrop(new Crop(3, 5, 7, 9)))) {
            assertEquals(
                    reason, Renderer.choose(scene, other, () -> false).reason().orElseThrow());
        }
    }

    @Test
    void thePictureIsThatOfTheMethodAndTheReasonIsTold() throws IOException {
        Scene scene = scene("cornell-box");
        RenderSettings settings = auto(scene, 8);
        List<String> notes = new ArrayList<>();
        RenderProgress progress = new RenderProgress() {
            @Override
            public void progress(long done, long total, java.util.function.Supplier<enlightenment.image.Image> soFar) {}

            @Override
            public void note(String text) {
                notes.add(text);
            }
        };
        RenderResult result = Renderer.render(scene, settings, progress, () -> false);
        RenderRequest.MethodChoice choice = Renderer.choose(scene, settings, () -> false);
        assertEquals(choice.settings(), result.report().settings());
        assertTrue(notes.contains(choice.reason().orElseThrow()), notes.toString());
        assertNotEquals(Method.AUTO, choice.settings().method());
        float[] named = Renderer.render(scene, choice.settings()).toArray();
        assertArrayEquals(named, result.image().toArray());
        RenderResult prepared = Renderer.render(RenderRequest.of(scene).withChoice(choice));
        assertArrayEquals(named, prepared.image().toArray());
        assertEquals(
                choice.settings(),
                DividedRender.prepare(scene, settings, () -> false).outline().settings());
    }

    @Test
    void aMethodThatIsNamedIsKept() throws IOException {
        Scene scene = scene("cornell-box");
        RenderSettings settings = auto(scene, 8).withMethod(Method.METROPOLIS);
        RenderRequest.MethodChoice choice = Renderer.choose(scene, settings, () -> false);
        assertSame(settings, choice.settings());
        assertTrue(choice.reason().isEmpty());
    }

    @Test
    void matteRoomsGoToClustersAndLampsBehindDoorsToPathsFromLights() throws IOException {
        Scene room = scene("cornell-box");
        assertEquals(Method.CLUSTER, chosen(room, auto(room, MANY)));
        Scene door = scene("door-ajar");
        assertEquals(BuiltInMethod.BIDIRECTIONAL_CLUSTER, chosen(door, auto(door, MANY)));
    }

    @Test
    void whatAMethodCannotSeeIsNotLeftToIt() throws IOException {
        Scene scene = scene("glass-physical");
        for (long seed = 0; seed < 3; seed++) {
            assertNotEquals(BuiltInMethod.LIGHT, chosen(scene, auto(scene, MANY).withSeed(seed)));
        }
    }

    @Test
    void aSmallRenderHasNoPilotButTheMethodThatIsBestMostOften() throws IOException {
        Scene door = scene("door-ajar");
        RenderRequest.MethodChoice choice = Renderer.choose(door, auto(door, 8), () -> false);
        assertEquals(Method.CLUSTER, choice.settings().method());
        assertTrue(choice.reason().orElseThrow().contains("too small for a pilot"));
        assertEquals(Method.RAYTRACE, chosen(door, auto(door, 4)));
        RenderSettings hasty = auto(door, 8).withSize(480, 320).withBudget(RenderSettings.Budget.NONE.withSeconds(8));
        assertEquals(Method.CLUSTER, chosen(door, hasty));
    }

    @Test
    void classicShadingHasItsClusters() throws IOException {
        Scene scene = scene("fire-and-ice");
        assertEquals(Method.CLUSTER, chosen(scene, auto(scene, 4)));
    }

    @Test
    void aChoiceThatIsCancelledIsNone() throws IOException {
        Scene scene = scene("cornell-box");
        assertThrows(CancellationException.class, () -> Renderer.choose(scene, auto(scene, MANY), () -> true));
    }
}
