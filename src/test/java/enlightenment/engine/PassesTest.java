package enlightenment.engine;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.film.FilmTile;
import enlightenment.method.RayTraceMethod;
import enlightenment.plan.RenderPlan;
import enlightenment.render.RenderRequest;
import enlightenment.render.RenderResult;
import enlightenment.render.Renderer;
import enlightenment.render.TestScenes;
import enlightenment.scene.BuiltInMethod;
import enlightenment.scene.Method;
import enlightenment.scene.RenderSettings;
import enlightenment.scene.Scene;
import enlightenment.world.CompiledScene;
import enlightenment.world.SceneCompiler;
import enlightenment.world.parts.RayCounters;
import java.nio.ByteBuffer;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Pixels with so many samples that a tile is made in passes. */
class PassesTest {
    private static final Scene SCENE = TestScenes.whiteFireAndIce().build();

    /** In 4 passes; of the picture only six pixels at the border between two tiles. */
    private static final RenderSettings SETTINGS = RenderSettings.of(SCENE)
            .withSize(64, 48)
            .withCrop(new RenderSettings.Crop(31, 20, 3, 2))
            .with(new BuiltInMethod.RayTraceSettings(1))
            .withBudget(RenderSettings.Budget.NONE.withSamples(90_000))
            .withThreads(2);

    private static final RenderResult ALONE = Renderer.render(RenderRequest.of(SCENE, SETTINGS)
            .withAuxiliary(RenderResult.Auxiliary.SAMPLES, RenderResult.Auxiliary.ERROR));

    private static final DividedRender RENDER = DividedRender.prepare(SCENE, SETTINGS, () -> false);

    /** The results of all units. */
    private static final List<byte[]> MADE = made();

    private static List<byte[]> made() {
        UnitMaker maker = RENDER.maker();
        List<byte[]> all = new ArrayList<>();
        for (int unit = 0; unit < RENDER.units(); unit++) {
            all.add(maker.make(unit));
        }
        return all;
    }

    @ParameterizedTest
    @CsvSource({
        // The paper's job; ordinary pictures; a large one with the same work, which has pixels enough.
        "800, 400, 506250, 16",
        "800, 400, 4096, 1",
        "800, 400, 87381, 1",
        "800, 400, 87382, 4",
        "3840, 2160, 19531, 1",
        "64, 48, 90000, 4",
        // Never more units than a server can listen to, and never a pass without samples.
        "800, 400, 1e9, 32",
        "8, 8, 1e9, 32768",
        "8000, 8000, 1e9, 1"
    })
    void thereAreAsManyPassesAsMakeUnitsOfHalfASecond(int width, int height, double samples, int passes) {
        RenderSettings whole = RenderSettings.of(SCENE).withSize(width, height);
        RenderPlan plan = new RenderPlan(Method.RAYTRACE, samples, samples, "samples");
        assertEquals(passes, WorkUnits.forMachines(whole, plan).passes());
        assertEquals(passes, WorkUnits.forThreads(whole, plan).passes());
        // A function of the whole picture, whatever is rendered of it, and by how many.
        RenderSettings part = whole.withCrop(new RenderSettings.Crop(1, 1, 6, 7))
                .withThreads(64)
                .withTileSize(8);
        assertEquals(passes, WorkUnits.forMachines(part, plan).passes());
        assertEquals(passes, WorkUnits.forThreads(part, plan).passes());
        assertTrue(WorkUnits.forMachines(whole, plan).count() <= 1 << 18);
    }

    /** Its samples are chosen by those before. */
    @Test
    void theClusterMethodIsNotDivided() {
        RenderPlan plan = new RenderPlan(Method.CLUSTER, 1e9, 1e9, "samples");
        assertEquals(1, WorkUnits.forMachines(SETTINGS, plan).passes());
    }

    @Test
    void passesOfATileHaveConsecutiveNumbers() {
        WorkUnits units = WorkUnits.forMachines(SETTINGS, RENDER.plan());
        assertEquals(4, units.passes());
        assertEquals(8, units.count());
        for (int unit = 0; unit < 8; unit++) {
            assertEquals(unit / 4, units.tile(unit));
            assertEquals(unit % 4, units.pass(unit));
        }
    }

    @Test
    void passesInAnyOrderMakeThePictureTheCountsAndTheErrorOfOneProcess() {
        for (long seed = 0; seed < 4; seed++) {
            FilmAssembly film = RENDER.assembly();
            long before = 0;
            for (int unit : UnitOrder.shuffled(RENDER.units(), seed)) {
                film.put(unit, MADE.get(unit));
                assertTrue(film.pixelsDone() >= before);
                before = film.pixelsDone();
            }
            assertEquals(6, film.pixelsDone());
            Rendered rendered = film.result();
            assertTrue(rendered.complete());
            assertArrayEquals(ALONE.image().toArray(), rendered.image().toArray());
            assertEquals(ALONE.report().raysByKind(), rendered.report().raysByKind());
            assertEquals(ALONE.report().sampling(), rendered.report().sampling());
        }
        assertEquals(90_000, ALONE.report().sampling().plannedSamples());
        float[] samples = ALONE.auxiliary().get(RenderResult.Auxiliary.SAMPLES).toArray();
        for (float count : samples) {
            assertTrue(count == 65_536 || count == 131_072, count + " samples");
        }
    }

    /** The same samples as in one pass; sums are compensated, so that they agree to the last bit of a float. */
    @Test
    void thePictureIsThatOfOnePass() {
        RenderSettings settings = SETTINGS.withThreads(1);
        CompiledScene scene = SceneCompiler.compile(SCENE, settings);
        RayTraceMethod method = RayTraceMethod.of(
                scene,
                settings,
                new RayCounters(scene.kindNames.size()),
                RENDER.plan().level());
        FilmTile tile = new FilmTile(31, 20, 3, 2);
        method.render(tile);
        float[] spread = ALONE.auxiliary().get(RenderResult.Auxiliary.ERROR).toArray();
        for (int y = 0; y < 2; y++) {
            for (int x = 0; x < 3; x++) {
                for (int c = 0; c < 3; c++) {
                    assertEquals(
                            (float) tile.mean(31 + x, 20 + y, c), ALONE.image().component(x, y, c));
                }
                assertTrue(spread[3 * (3 * y + x)] > 0 && spread[3 * (3 * y + x)] < 0.01);
            }
        }
    }

    @Test
    void aPassThatWasTakenOutOrReplacedLeavesNothing() {
        Map<Integer, byte[]> kept = new HashMap<>();
        FilmAssembly film = RENDER.assembly();
        assertTrue(film.needsStore());
        film.keepIn(new ResultStore() {
            @Override
            public void keep(int unit, byte[] bytes) {
                kept.put(unit, bytes);
            }

            @Override
            public byte[] get(int unit) {
                return kept.get(unit);
            }
        });
        for (int unit : UnitOrder.shuffled(RENDER.units(), 9)) {
            film.put(unit, wrong(unit));
        }
        assertTrue(film.result().complete());
        for (int unit : UnitOrder.shuffled(RENDER.units(), 10)) {
            if (unit % 2 == 0) {
                film.remove(unit);
                film.remove(unit);
                assertEquals(7, film.done());
                assertFalse(film.has(unit));
                assertFalse(film.result().complete());
                assertEquals(5, film.pixelsDone());
            }
            film.put(unit, MADE.get(unit));
        }
        Rendered rendered = film.result();
        assertArrayEquals(ALONE.image().toArray(), rendered.image().toArray());
        assertEquals(ALONE.report().raysByKind(), rendered.report().raysByKind());
        assertEquals(ALONE.report().sampling(), rendered.report().sampling());
    }

    private static int start() {
        return ResultHeader.length(RENDER.outline().kinds().size());
    }

    private static byte[] wrong(int unit) {
        byte[] bytes = MADE.get(unit).clone();
        return ByteBuffer.wrap(bytes).putLong(0, 77).putDouble(start(), 0.5).array();
    }

    @Test
    void whatCannotBeAPassIsRefusedWithTheReason() {
        FilmAssembly film = RENDER.assembly();
        byte[] good = MADE.get(0);
        assertEquals(film.longest(0), good.length);
        assertRefused(film, 0, new byte[good.length - 1], "bytes instead of");
        assertRefused(film, 8, good, "there is no unit 8");
        ByteBuffer changed = ByteBuffer.wrap(good.clone());
        assertRefused(film, 0, changed.putDouble(start(), Double.NaN).array(), "samples is NaN");
        assertRefused(film, 0, changed.putDouble(start(), 1e300).array(), "samples is 1.0E300");
        changed = ByteBuffer.wrap(good.clone());
        assertRefused(film, 0, changed.putInt(start() + 48, 0).array(), "a sum of 0 samples");
        // Four of these could not be counted together.
        changed = ByteBuffer.wrap(good.clone());
        assertRefused(film, 0, changed.putInt(start() + 48, 1 << 30).array(), "a sum of 1073741824 samples");
        assertEquals(0, film.done());
    }

    private static void assertRefused(FilmAssembly film, int unit, byte[] bytes, String reason) {
        String message = assertThrows(IllegalArgumentException.class, () -> film.put(unit, bytes))
                .getMessage();
        assertTrue(message.contains(reason), message);
    }
}
