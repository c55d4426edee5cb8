package enlightenment.engine;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.image.Image;
import enlightenment.plan.RenderPlan;
import enlightenment.render.RenderProgress;
import enlightenment.render.RenderRequest;
import enlightenment.render.RenderResult;
import enlightenment.render.Renderer;
import enlightenment.scene.Method;
import enlightenment.scene.RenderSettings;
import enlightenment.scene.Scene;
import enlightenment.toy.HalfAndHalf;
import enlightenment.toy.ToyScene;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.concurrent.atomic.AtomicInteger;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** A method whose light comes half by tiles and half by paths that may end anywhere, from one process and in units of work. */
class MixedRenderTest {
    private static final Scene SCENE = ToyScene.scene();

    /** 8 paths to a pixel: 7,680, in 4 batches; and 5 columns of tiles. */
    private static final RenderSettings SETTINGS = RenderSettings.of(SCENE)
            .withMethod(Method.named(HalfAndHalf.WORD))
            .withAntialias(4)
            .withThreads(2);

    private static final RenderResult ALONE = Renderer.render(RenderRequest.of(SCENE, SETTINGS));

    private static DividedRender divided(RenderSettings settings) {
        return DividedRender.prepare(SCENE, settings, () -> false);
    }

    private static double rmse(Image a, Image b) {
        float[] p = a.toArray();
        float[] q = b.toArray();
        double sum = 0;
        for (int i = 0; i < p.length; i++) {
            sum += (p[i] - q[i]) * (double) (p[i] - q[i]);
        }
        return Math.sqrt(sum / p.length);
    }

    @Test
    void bothHalvesTogetherAreWhatCameraRaysSeeAndTellTheirError() {
        Image truth = Renderer.render(
                SCENE, RenderSettings.of(SCENE).withMethod(Method.RAYTRACE).withAntialias(16));
        int seeds = 8;
        double squares = 0;
        double told = 0;
        float[] sum = new float[3 * 40 * 24];
        for (long seed = 1; seed <= seeds; seed++) {
            RenderResult result = Renderer.render(RenderRequest.of(SCENE, SETTINGS.withSeed(seed)));
            double error = rmse(result.image(), truth);
            squares += error * error;
            told += result.report().sampling().estimatedError()
                    * result.report().sampling().estimatedError();
            for (int i = 0; i < sum.length; i++) {
                sum[i] += result.image().toArray()[i] / seeds;
            }
        }
        // If all 7,680 paths reached the pixels that show balls, and all alike, each of these would have the variance
        // of half their
        // light.
        double balls = 40 * 24 * mean(truth);
        double least = balls / (40 * 24) * 0.25 * balls / 7_680;
        assertTrue(squares / seeds > 0.8 * least, "squared error " + squares / seeds + " of " + least);
        assertEquals(squares, told, 0.2 * squares);
        double left = rmse(new Image(40, 24, sum), truth);
        assertEquals(squares / seeds / seeds, left * left, 0.25 * squares / seeds / seeds);
    }

    @Test
    void unitsInAnyOrderMakeThePictureAndTheCountsOfOneProcess() {
        DividedRender render = divided(SETTINGS);
        assertEquals(4 + 5 * 3, render.units());
        assertEquals(7_680, render.plan().lightPaths());
        for (long seed = 0; seed < 3; seed++) {
            FilmAssembly film = render.assembly();
            long before = 0;
            for (int unit : UnitOrder.shuffled(render.units(), seed)) {
                film.put(unit, render.maker().make(unit));
                assertTrue(film.has(unit));
                assertTrue(film.pixelsDone() >= before);
                before = film.pixelsDone();
            }
            assertEquals(40 * 24, film.pixelsDone());
            Rendered rendered = film.result();
            assertTrue(rendered.complete());
            assertArrayEquals(ALONE.image().toArray(), rendered.image().toArray());
            assertEquals(ALONE.report().raysByKind(), rendered.report().raysByKind());
            assertEquals(ALONE.report().sampling(), rendered.report().sampling());
            assertEquals(ALONE.report().pixels(), rendered.report().pixels());
        }
        assertEquals(16, ALONE.report().sampling().samplesPerPixel());
    }

    @Test
    void threadsAndTilesHaveNoInfluence() {
        for (int threads : new int[] {1, 3}) {
            RenderSettings settings = SETTINGS.withThreads(threads).withTileSize(8 * threads);
            assertArrayEquals(
                    ALONE.image().toArray(), Renderer.render(SCENE, settings).toArray());
        }
    }

    @Test
    void aUnitThatWasTakenOutOrReplacedLeavesNothing() {
        DividedRender render = divided(SETTINGS);
        DividedRender other = divided(SETTINGS.withSeed(99));
        FilmAssembly film = render.assembly();
        assertTrue(film.needsStore());
        film.keepIn(new KeptResults());
        for (int unit : UnitOrder.shuffled(render.units(), 5)) {
            film.put(unit, other.maker().make(unit));
            if (unit % 2 == 0) {
                film.remove(unit);
                assertFalse(film.has(unit));
            }
            film.put(unit, render.maker().make(unit));
        }
        assertArrayEquals(ALONE.image().toArray(), film.result().image().toArray());
        assertEquals(ALONE.report().sampling(), film.result().report().sampling());
    }

    @Test
    void aUnitThatIsReplacedInACompletePictureIsSeenAtOnce() {
        DividedRender render = divided(SETTINGS);
        FilmAssembly film = render.assembly();
        film.keepIn(new KeptResults());
        for (int u = 0; u < render.units(); u++) {
            film.put(u, render.maker().make(u));
        }
        assertArrayEquals(ALONE.image().toArray(), film.image().toArray());
        UnitMaker other = divided(SETTINGS.withSeed(99)).maker();
        int batches = 0;
        int tiles = 0;
        for (int u = 0; u < render.units(); u++) {
            film.put(u, other.make(u));
            boolean isSeen = rmse(ALONE.image(), film.image()) > 0;
            batches += isSeen && u < 4 ? 1 : 0;
            tiles += isSeen && u >= 4 ? 1 : 0;
            film.put(u, render.maker().make(u));
            assertArrayEquals(ALONE.image().toArray(), film.image().toArray());
        }
        assertEquals(4, batches);
        // Some tiles show nothing but the sky.
        assertTrue(tiles > 0);
        assertEquals(ALONE.report().sampling(), film.result().report().sampling());
    }

    @Test
    void aCropIsAPartOfTheWholeAndTakesAllPaths() {
        RenderSettings settings = SETTINGS.withCrop(new RenderSettings.Crop(13, 7, 20, 11));
        DividedRender render = divided(settings);
        assertEquals(7_680, render.plan().lightPaths());
        assertTrue(
                render.notes().get(0).contains("the light paths of the whole picture"),
                render.notes().get(0));
        Image part = Renderer.render(SCENE, settings);
        for (int y = 0; y < 11; y++) {
            for (int x = 0; x < 20; x++) {
                assertEquals(ALONE.image().component(13 + x, 7 + y, 0), part.component(x, y, 0));
            }
        }
    }

    @Test
    void resultsOfTheOtherKindAreRefused() {
        DividedRender render = divided(SETTINGS);
        FilmAssembly film = render.assembly();
        byte[] batch = render.maker().make(0);
        byte[] tile = render.maker().make(4);
        assertTrue(batch.length <= film.longest(0) && tile.length == film.longest(4));
        assertThrows(IllegalArgumentException.class, () -> film.put(0, tile));
        assertThrows(IllegalArgumentException.class, () -> film.put(4, batch));
        assertThrows(IllegalArgumentException.class, () -> film.put(19, tile));
        assertEquals(0, film.done());
    }

    /** Batches come first: so what there is of a picture has all that paths bring. */
    @Test
    void aStoppedPictureIsBlackWhereTilesAreMissingAndWholeElsewhere() {
        AtomicInteger units = new AtomicInteger();
        RenderProgress progress = (done, total, soFar) -> units.incrementAndGet();
        RenderResult result =
                Renderer.render(RenderRequest.of(SCENE, SETTINGS.withThreads(1).withTileSize(8))
                        .withProgress(progress)
                        .withCancelled(() -> units.get() >= 4 + 6));
        assertFalse(result.complete());
        assertEquals(6 * 64, result.shownPixels());
        int same = 0;
        for (int i = 0; i < 3 * 40 * 24; i++) {
            float whole = ALONE.image().toArray()[i];
            float there = result.image().toArray()[i];
            assertTrue(there == 0 || there == whole);
            same += there == whole ? 1 : 0;
        }
        assertTrue(same >= 3 * result.shownPixels());
    }

    @Test
    void aProgressiveRenderShowsWhatThePathsHaveBroughtSoFar() {
        List<Image> pictures = Collections.synchronizedList(new ArrayList<>());
        List<Long> told = Collections.synchronizedList(new ArrayList<>());
        RenderProgress progress = (done, total, soFar) -> {
            told.add(done);
            pictures.add(soFar.get());
        };
        RenderResult result = Renderer.render(
                RenderRequest.of(SCENE, SETTINGS).withProgress(progress).withProgressive(true));
        assertArrayEquals(ALONE.image().toArray(), result.image().toArray());
        assertEquals(40 * 24, told.get(told.size() - 1));
        int begun = told.lastIndexOf(0L) + 1;
        // All light from the first batch on.
        assertEquals(mean(result.image()), mean(pictures.get(begun)), 0.1 * mean(result.image()));
        assertTrue(mean(pictures.get(begun - 1)) < 0.7 * mean(result.image()));
    }

    private static double mean(Image image) {
        double sum = 0;
        for (float f : image.toArray()) {
            sum += f;
        }
        return sum / image.toArray().length;
    }

    @Test
    void anErrorAskedForIsKept() {
        RenderResult result = Renderer.render(
                RenderRequest.of(SCENE, SETTINGS.withBudget(RenderSettings.Budget.NONE.withError(0.02))));
        assertTrue(result.report().isErrorMet(), result.report().sampling().toString());
    }

    @ParameterizedTest
    @ValueSource(longs = {1, 3, 4, 1_000, 262_144, 262_145, 1_000_003, 1L << 40})
    void groupsOfBatchesHaveEquallyManyPaths(long paths) {
        WorkUnits units = WorkUnits.forMachines(SETTINGS, new RenderPlan(SETTINGS.method(), 1, 1, "samples", paths));
        assertEquals(0, units.batches() % 4);
        assertTrue(units.batches() <= 1 << 18);
        int last = units.batches() - 1;
        assertEquals(units.paths(0), units.paths(last));
        assertEquals(units.paths(), units.firstPath(last) + units.paths(last));
        assertTrue(units.paths() >= paths && units.paths() < paths + units.batches(), units.paths() + " paths");
        assertEquals(
                WorkUnits.forThreads(SETTINGS, new RenderPlan(SETTINGS.method(), 1, 1, "x", paths))
                        .paths(),
                units.paths());
    }
}
