package enlightenment.plan;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.compiled.ChanceError;
import enlightenment.compiled.ChanceLights;
import enlightenment.compiled.CompiledScene;
import enlightenment.compiled.SceneCompiler;
import enlightenment.method.LightPaths;
import enlightenment.scene.Budget;
import enlightenment.scene.BuiltInMethod;
import enlightenment.scene.RenderSettings;
import enlightenment.scene.Scene;
import enlightenment.scene.json.SceneReader;
import enlightenment.work.Stopwatch;
import java.nio.file.Path;
import java.util.concurrent.CancellationException;
import java.util.concurrent.atomic.AtomicInteger;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/**
 * The search for light that is left to chance follows thousands of paths before a picture is begun: where each of them meets hundreds of
 * surfaces it takes long, and whoever stops it must be heard.
 */
class CancelledSearchTest {
    private static ChanceError error(CompiledScene scene, RenderSettings settings, int polls, AtomicInteger asked) {
        return Integrators.chance(
                settings.method(), scene, 16, settings.region(), () -> asked.incrementAndGet() > polls);
    }

    @ParameterizedTest
    @CsvSource({
        "caustics, RAYTRACE",
        "caustics, BIDIRECTIONAL",
        "milk-and-glass, RAYTRACE",
        "milk-and-glass, METROPOLIS",
        "milk-and-glass, BIDIRECTIONAL"
    })
    void itIsHeardSoonAndLeavesNothingBehind(String name, BuiltInMethod method) {
        Scene scene = SceneReader.read(Path.of("scenes/" + name + ".json"));
        RenderSettings settings = RenderSettings.of(scene).withSize(12, 8).withMethod(method);
        AtomicInteger asked = new AtomicInteger();
        CompiledScene compiled = SceneCompiler.compile(scene, settings);
        ChanceError whole = error(compiled, settings, Integer.MAX_VALUE, asked);
        int polls = asked.get();
        assertTrue(polls >= 24, polls + " times asked of 24,576 paths");
        CompiledScene again = SceneCompiler.compile(scene, settings);
        for (int stop : new int[] {0, polls / 2, polls - 1}) {
            AtomicInteger now = new AtomicInteger();
            assertThrows(CancellationException.class, () -> error(again, settings, stop, now));
            assertEquals(stop + 1, now.get(), "asked again after it was heard");
        }
        assertEquals(whole, error(again, settings, Integer.MAX_VALUE, asked));
        // Who plans has it done, so that nobody has to wait for it later.
        CompiledScene planned = SceneCompiler.compile(scene, settings);
        new Planner(planned, settings, () -> false).plan(Stopwatch.started(), 0);
        int before = asked.get();
        assertEquals(whole, error(planned, settings, Integer.MAX_VALUE, asked));
        assertEquals(before, asked.get());
    }

    /** A render that was stopped while it was planned has not found out what its rounds ask for. */
    @Test
    void roundsForAnErrorAreEndedToo() {
        Scene scene = SceneReader.read(Path.of("scenes/caustics.json"));
        RenderSettings settings = RenderSettings.of(scene).withSize(12, 8).withBudget(Budget.NONE.withError(0.01));
        CompiledScene compiled = SceneCompiler.compile(scene, settings);
        assertThrows(CancellationException.class, () -> Rounds.of(settings, compiled, () -> true));
    }

    /** Without media behind a refracting border paths from both ends miss what paths from the eye miss. */
    @Test
    void thatOfBothEndsIsMadeOnlyWherePathsCouldMeetInMedia() {
        for (String name : new String[] {"caustics", "milk-and-glass"}) {
            Scene scene = SceneReader.read(Path.of("scenes/" + name + ".json"));
            CompiledScene compiled =
                    SceneCompiler.compile(scene, RenderSettings.of(scene).withSize(12, 8));
            ChanceLights byEye = LightPaths.leftToChance(compiled, () -> false);
            assertEquals(name.equals("caustics"), byEye == LightPaths.leftByBothEnds(compiled, () -> false), name);
        }
    }
}
