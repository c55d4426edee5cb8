package enlightenment.engine;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.film.FilmTile;
import enlightenment.plan.RenderPlan;
import enlightenment.render.RenderProgress;
import enlightenment.render.RenderResult;
import enlightenment.render.Renderer;
import enlightenment.render.TestScenes;
import enlightenment.scene.BuiltInMethod;
import enlightenment.scene.ClassicMethods;
import enlightenment.scene.Method;
import enlightenment.scene.RenderSettings;
import enlightenment.scene.Scene;
import enlightenment.scene.json.SceneReader;
import java.nio.ByteBuffer;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Optional;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;

class DividedRenderTest {
    private static final Scene SCENE = TestScenes.whiteFireAndIce().build();

    private static RenderSettings settings(Method method) {
        return RenderSettings.of(SCENE)
                .withMethod(method)
                .withSize(75, 42)
                .withAntialias(2)
                .with(new BuiltInMethod.RayTraceSettings(2))
                .withThreads(2);
    }

    private static DividedRender tiled(RenderSettings settings) {
        return DividedRender.prepare(SCENE, settings, () -> false);
    }

    @ParameterizedTest
    @ClassicMethods
    void tilesInAnyOrderMakeThePictureAndTheCountsOfTheRenderer(Method method) {
        RenderSettings settings = settings(method);
        DividedRender tiled = tiled(settings);
        FilmAssembly assembly = tiled.assembly();
        List<Integer> order = new ArrayList<>();
        for (int tile = 0; tile < tiled.units(); tile++) {
            order.add(tile);
        }
        order.addAll(order);
        Collections.shuffle(order, new Random(7));
        for (int tile : order) {
            assembly.put(tile, tiled.maker().make(tile));
        }
        RenderResult expected = Renderer.render(SCENE, settings, RenderProgress.NONE, () -> false);
        Rendered actual = assembly.result();
        assertTrue(actual.complete());
        assertArrayEquals(expected.image().toArray(), actual.image().toArray());
        assertEquals(expected.report().raysByKind(), actual.report().raysByKind());
        assertEquals(expected.report().sampling(), actual.report().sampling());
        assertEquals(expected.report().hitsByPrimitive(), actual.report().hitsByPrimitive());
        assertEquals(expected.report().pixels(), actual.report().pixels());
    }

    @Test
    void aWorkersOutlineIsThatOfTheRenderThatWasPlanned() {
        Scene scene = SceneReader.read(Path.of("scenes/caustics.json"));
        RenderSettings settings =
                RenderSettings.of(scene).withSize(12, 8).withBudget(RenderSettings.Budget.NONE.withSamples(2));
        DividedRender planned = DividedRender.prepare(scene, settings, () -> false);
        DividedRender worker = DividedRender.planned(scene, settings, planned.plan(), file -> null);
        assertEquals(1, planned.outline().undersampled().size());
        assertEquals(planned.outline(), worker.outline());
        for (int unit = 0; unit < planned.units(); unit++) {
            assertArrayEquals(planned.maker().make(unit), worker.maker().make(unit));
        }
    }

    @Test
    void aTileThatWasTakenOutOrReplacedLeavesNothing() {
        RenderSettings settings = settings(Method.RAYTRACE);
        DividedRender tiled = tiled(settings);
        FilmAssembly assembly = tiled.assembly();
        for (int tile = 0; tile < tiled.units(); tile++) {
            byte[] right = tiled.maker().make(tile);
            byte[] wrong = right.clone();
            ByteBuffer counters = ByteBuffer.wrap(wrong);
            int header = right.length - 36 * pixels(tiled, tile);
            for (int at = 0; at < header; at += Long.BYTES) {
                counters.putLong(at, 1_000_003);
            }
            counters.putDouble(header, 0.75)
                    .putFloat(header + 24, 3)
                    .putFloat(header + 28, 9)
                    .putInt(header + 32, 4);
            assembly.put(tile, wrong);
            if (tile % 2 == 0) {
                assembly.remove(tile);
            }
            assembly.put(tile, right);
        }
        RenderResult expected = Renderer.render(SCENE, settings, RenderProgress.NONE, () -> false);
        Rendered actual = assembly.result();
        assertArrayEquals(expected.image().toArray(), actual.image().toArray());
        assertEquals(expected.report().raysByKind(), actual.report().raysByKind());
        assertEquals(expected.report().sampling(), actual.report().sampling());
        assertEquals(expected.report().hitsByPrimitive(), actual.report().hitsByPrimitive());
    }

    @Test
    void whatATileCanGrowByIsTakenOfWhatWasKeptAndRefusedOfAWorker() {
        DividedRender tiled = tiled(settings(Method.RAYTRACE));
        byte[] plain = tiled.maker().make(0);
        byte[] grown = tiled.growing(() -> false, null).make(0, null);
        assertTrue(grown.length > plain.length);
        FilmAssembly assembly = tiled.assembly();
        assertEquals(Optional.empty(), assembly.problemOfKept(0, grown));
        assertEquals(Optional.empty(), assembly.problemOfKept(0, plain));
        String expected = "it has " + grown.length + " bytes instead of " + plain.length;
        ResultCheck check = ResultCheck.of(tiled.outline());
        assertEquals(Optional.of(expected), assembly.problem(0, grown));
        assertEquals(Optional.of(expected), check.problem(0, grown));
        assertEquals(Optional.empty(), assembly.problem(0, plain));
        assertEquals(Optional.empty(), check.problem(0, plain));
    }

    private static int pixels(DividedRender tiled, int tile) {
        RenderSettings.Crop place = new ColumnGrid(tiled.outline().settings(), tiled.plan()).place(tile);
        return place.width() * place.height();
    }

    @Test
    void aTileHasTheSameBytesWhateverWasMadeBefore() {
        DividedRender tiled = tiled(settings(Method.CLUSTER));
        UnitMaker maker = tiled.maker();
        byte[] first = maker.make(11);
        maker.make(3);
        assertArrayEquals(first, maker.make(11));
        assertArrayEquals(first, tiled(settings(Method.CLUSTER)).maker().make(11));
    }

    @Test
    void tilesOfACropAreCutWhereThoseOfTheWholePictureAre() {
        RenderSettings settings = settings(Method.CLUSTER).withCrop(new RenderSettings.Crop(13, 5, 30, 21));
        DividedRender tiled = tiled(settings);
        FilmAssembly assembly = tiled.assembly();
        for (int tile = 0; tile < tiled.units(); tile++) {
            assembly.put(tile, tiled.maker().make(tile));
        }
        assertArrayEquals(
                Renderer.render(SCENE, settings).toArray(), assembly.image().toArray());
    }

    @Test
    void tilesCoverLargePicturesExactlyOnceInPiecesThatFitIntoAFrame() {
        int[][] sizes = {{1, 1}, {9, 65_536}, {800, 400}, {65_536, 17}, {4_000, 3_000}};
        for (int[] size : sizes) {
            assertCovers(size[0], size[1], grid(size[0], size[1], 1));
            assertCovers(size[0], size[1], grid(size[0], size[1], 1e7));
        }
    }

    private static ColumnGrid grid(int width, int height, double samples) {
        return new ColumnGrid(
                settings(Method.RAYTRACE).withSize(width, height),
                new RenderPlan(Method.RAYTRACE, 1, samples, "samples"));
    }

    private static void assertCovers(int width, int height, ColumnGrid grid) {
        long pixels = 0;
        for (int tile = 0; tile < grid.tiles(); tile++) {
            RenderSettings.Crop place = grid.place(tile);
            pixels += (long) place.width() * place.height();
            assertTrue(52 * place.width() * place.height() + ResultHeader.length(100) < 1 << 20);
            assertEquals(0, place.x() % FilmTile.BLOCK_SIDE + place.y() % FilmTile.BLOCK_SIDE);
        }
        assertEquals((long) width * height, pixels);
    }

    @Test
    void longRendersAreCutFinerAsFarAsThereArePixels() {
        // 100 columns of 50 blocks: the fewest tiles, 4,096, make pieces of two blocks.
        assertEquals(2_500, grid(800, 400, 1).tiles());
        assertEquals(2_500, grid(800, 400, 4_096 * 2_097_152.0 / 320_000).tiles());
        assertEquals(5_000, grid(800, 400, 1e7).tiles());
        // 450 columns of 225 blocks; 90,000 tiles of 2^21 rays are 200 to a column.
        assertEquals(
                450 * 113,
                grid(3_600, 1_800, 90_000 * 2_097_152.0 / (3_600 * 1_800)).tiles());
        assertEquals(450 * 225, grid(3_600, 1_800, 1e7).tiles());
        // 1,000 columns of 1,000 blocks; at most 2^18 tiles are 262 to a column, of four blocks each.
        assertEquals(1_000 * 250, grid(8_000, 8_000, 1e9).tiles());
    }

    @Test
    void howFineTheCutIsDoesNotChangeThePicture() {
        RenderSettings settings = settings(Method.CLUSTER).withSize(800, 400).withAntialias(1);
        DividedRender usual = tiled(settings);
        // As if fifty thousand rays per pixel were to come, where one does.
        RenderPlan plan = new RenderPlan(usual.plan().method(), usual.plan().level(), 5e4, "samples");
        DividedRender finer = DividedRender.planned(SCENE, settings, plan, file -> null);
        assertEquals(2_500, usual.units());
        assertEquals(5_000, finer.units());
        FilmAssembly fine = finer.assembly();
        UnitMaker maker = finer.maker();
        for (int tile = 0; tile < finer.units(); tile++) {
            fine.put(tile, maker.make(tile));
        }
        assertArrayEquals(
                Renderer.render(SCENE, settings).toArray(), fine.image().toArray());
    }

    @Test
    void whatCannotBeATileIsRefusedWithTheReason() {
        DividedRender tiled = tiled(settings(Method.RAYTRACE));
        FilmAssembly assembly = tiled.assembly();
        byte[] good = tiled.maker().make(0);
        int pixels = good.length - 64 * 36;
        assertRefused(assembly, 0, new byte[good.length - 1], "bytes instead of");
        assertRefused(assembly, tiled.units(), good, "there is no unit");
        assertRefused(assembly, -1, good, "there is no unit");
        ByteBuffer changed = ByteBuffer.wrap(good.clone());
        assertRefused(assembly, 0, changed.putDouble(pixels, Double.NaN).array(), "pixel 0,0 a colour is NaN");
        assertRefused(assembly, 0, changed.putDouble(pixels, 1e300).array(), "a colour is 1.0E300");
        changed = ByteBuffer.wrap(good.clone());
        assertRefused(assembly, 0, changed.putFloat(pixels + 24, -1).array(), "a spread is -1.0");
        changed = ByteBuffer.wrap(good.clone());
        assertRefused(assembly, 0, changed.putInt(pixels + 32, 0).array(), "number of samples is 0");
        changed = ByteBuffer.wrap(good.clone());
        assertRefused(assembly, 0, changed.putLong(8, -1).array(), "a counter is -1, outside 0..");
        assertEquals(0, assembly.done());
    }

    private static void assertRefused(FilmAssembly assembly, int tile, byte[] bytes, String reason) {
        String message = assertThrows(IllegalArgumentException.class, () -> assembly.put(tile, bytes))
                .getMessage();
        assertTrue(message.contains(reason), message);
    }

    @Test
    void aTileThatIsTakenOutIsMissingAgain() {
        DividedRender tiled = tiled(settings(Method.RAYTRACE));
        FilmAssembly assembly = tiled.assembly();
        assembly.put(2, tiled.maker().make(2));
        assembly.put(2, tiled.maker().make(2));
        assertEquals(1, assembly.done());
        assembly.remove(2);
        assembly.remove(2);
        assertEquals(0, assembly.done());
        assertEquals(0, assembly.result().report().rays());
        assertFalse(assembly.result().complete());
        assertArrayEquals(tiled.assembly().image().toArray(), assembly.image().toArray());
    }
}
