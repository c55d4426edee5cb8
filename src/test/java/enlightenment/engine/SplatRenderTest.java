package enlightenment.engine;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.image.Image;
import enlightenment.plan.Planner;
import enlightenment.plan.RenderPlan;
import enlightenment.render.RenderProgress;
import enlightenment.render.RenderRequest;
import enlightenment.render.RenderResult;
import enlightenment.render.Renderer;
import enlightenment.render.TestScenes;
import enlightenment.report.RenderReport;
import enlightenment.scene.Method;
import enlightenment.scene.RenderSettings;
import enlightenment.scene.Scene;
import enlightenment.work.Stopwatch;
import enlightenment.world.SceneCompiler;
import java.io.ByteArrayOutputStream;
import java.nio.ByteBuffer;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.List;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.concurrent.atomic.AtomicLong;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;

/** A method whose paths may end anywhere, from one process and in units of work. */
class SplatRenderTest {
    private static final Scene SCENE = TestScenes.whiteFireAndIce().build();

    /** 204,800 paths: four batches, the last not full. */
    private static final RenderSettings SETTINGS = RenderSettings.of(SCENE)
            .withMethod(Method.named("toy"))
            .withSize(64, 50)
            .withAntialias(8)
            .withThreads(2);

    private static final RenderResult ALONE = Renderer.render(RenderRequest.of(SCENE, SETTINGS));

    private static DividedRender divided(RenderSettings settings) {
        return DividedRender.prepare(SCENE, settings, () -> false);
    }

    @Test
    void unitsInAnyOrderMakeThePictureAndTheCountsOfOneProcess() {
        DividedRender render = divided(SETTINGS);
        assertEquals(4, render.units());
        for (long seed = 0; seed < 3; seed++) {
            FilmAssembly film = render.assembly();
            for (int unit : UnitOrder.shuffled(render.units(), seed)) {
                film.put(unit, render.maker().make(unit));
                assertTrue(film.has(unit));
            }
            Rendered rendered = film.result();
            assertTrue(rendered.complete());
            assertArrayEquals(ALONE.image().toArray(), rendered.image().toArray());
            assertEquals(ALONE.report().raysByKind(), rendered.report().raysByKind());
            assertEquals(ALONE.report().sampling(), rendered.report().sampling());
            assertEquals(ALONE.report().pixels(), rendered.report().pixels());
        }
        assertEquals(64, ALONE.report().sampling().samplesPerPixel());
        assertEquals(204_800, ALONE.report().raysByKind().get("camera"));
        assertEquals(64 * 50, ALONE.shownPixels());
    }

    @Test
    void threadsHaveNoInfluence() {
        for (int threads : new int[] {1, 3}) {
            RenderResult other = Renderer.render(RenderRequest.of(SCENE, SETTINGS.withThreads(threads)));
            assertArrayEquals(ALONE.image().toArray(), other.image().toArray());
        }
    }

    /** The blue of the toy is the place from left to right, its mean in a column known. */
    @Test
    void thePictureIsTheMeanOfWhatPathsBringTimesItsPixels() {
        Image image = ALONE.image();
        for (int x = 0; x < 64; x += 21) {
            double sum = 0;
            for (int y = 0; y < 50; y++) {
                sum += image.component(x, y, 2);
            }
            // 3,200 paths to a column, their number Poisson's: a standard deviation of 1.8 %.
            double expected = (x + 0.5) / 64;
            assertEquals(expected, sum / 50, 0.09 * expected);
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
        Rendered rendered = film.result();
        assertArrayEquals(ALONE.image().toArray(), rendered.image().toArray());
        assertEquals(ALONE.report().raysByKind(), rendered.report().raysByKind());
        assertEquals(ALONE.report().sampling(), rendered.report().sampling());
    }

    @Test
    void aCropIsAPartOfTheWholeAndTakesAllPaths() {
        RenderSettings settings = SETTINGS.withCrop(new RenderSettings.Crop(13, 7, 20, 31));
        DividedRender render = divided(settings);
        assertEquals(4, render.units());
        assertEquals(1, render.notes().size());
        assertTrue(
                render.notes().get(0).contains("a crop saves no time with toy"),
                render.notes().get(0));
        FilmAssembly film = render.assembly();
        for (int unit : UnitOrder.shuffled(render.units(), 1)) {
            film.put(unit, render.maker().make(unit));
        }
        Image part = Renderer.render(SCENE, settings);
        assertArrayEquals(part.toArray(), film.image().toArray());
        for (int y = 0; y < 31; y++) {
            for (int x = 0; x < 20; x++) {
                for (int c = 0; c < 3; c++) {
                    assertEquals(ALONE.image().component(13 + x, 7 + y, c), part.component(x, y, c));
                }
            }
        }
        assertEquals(64, film.result().report().sampling().samplesPerPixel());
    }

    @Test
    void whatCannotBeABatchIsRefusedWithTheReason() {
        DividedRender render = divided(SETTINGS);
        FilmAssembly film = render.assembly();
        byte[] good = render.maker().make(0);
        assertTrue(good.length <= film.longest(0), good.length + " bytes of at most " + film.longest(0));
        assertRefused(film, 4, good, "there is no unit 4; they are 0..3");
        assertRefused(film, 3, good, "it has 65536 paths instead of 8192");
        assertRefused(film, 0, new byte[good.length], "");
        assertRefused(film, 0, new byte[3], "fewer than its header");
        assertRefused(film, 0, Arrays.copyOf(good, good.length - 1), "");
        assertRefused(film, 0, Arrays.copyOf(good, good.length + 1), "bytes too many");
        assertEquals(0, film.done());
        assertEquals(0, film.result().shownPixels());
    }

    private static void assertRefused(FilmAssembly film, int unit, byte[] bytes, String reason) {
        String message = assertThrows(IllegalArgumentException.class, () -> film.put(unit, bytes))
                .getMessage();
        assertTrue(message.contains(reason), message);
    }

    /** One that says so of all pixels in all batches would otherwise make sums too large, and end the render. */
    @Test
    void aBatchThatIsTooBrightForTheSumsOfAllIsRefused() {
        DividedRender render = divided(SETTINGS);
        // 2^63 - 1 times two, and of the least number, -2^63, the magnitude less one times two and one: both in numbers
        // of 7 bits.
        byte[] bright = ofOnePixel(render, 0xff, 0xff, 0xff, 0xff, 0xff, 0xff, 0xff, 0xff, 0x7f);
        byte[] dark = ofOnePixel(render, 0xff, 0xff, 0xff, 0xff, 0xff, 0xff, 0xff, 0xff, 0xff, 1);
        // Of four batches each has a group of its own; of 16 there are four to a group.
        assertTrue(render.assembly().problem(0, bright).isEmpty());
        DividedRender more = divided(SETTINGS.withAntialias(16));
        assertEquals(13, more.units());
        assertTrue(more.assembly().problem(0, bright).orElse("").contains("brighter"));
        assertTrue(more.assembly().problem(0, dark).orElse("").contains("brighter"));
    }

    /** A batch of 65,536 paths that reaches the first pixel only, with so much red. */
    private static byte[] ofOnePixel(DividedRender render, int... red) {
        ByteArrayOutputStream bytes = new ByteArrayOutputStream();
        bytes.write(
                render.maker().make(0),
                0,
                ResultHeader.length(render.outline().kinds().size()));
        IntStream.of(0x80, 0x80, 4, 1, 1).forEach(bytes::write);
        IntStream.of(red).forEach(bytes::write);
        bytes.write(0);
        bytes.write(0);
        return bytes.toByteArray();
    }

    @Test
    void aCounterThatAllUnitsTogetherWouldOverflowByIsRefused() {
        DividedRender render = divided(SETTINGS);
        byte[] result = render.maker().make(0);
        for (int at = 0; at < ResultHeader.length(render.outline().kinds().size()); at += Long.BYTES) {
            for (long count : new long[] {-1, Long.MAX_VALUE / 8 + 2, Long.MAX_VALUE}) {
                byte[] changed = result.clone();
                ByteBuffer.wrap(changed).putLong(at, count);
                assertRefused(render.assembly(), 0, changed, "a counter is " + count);
            }
        }
    }

    @Test
    void unitsThatCountAsMuchAsTheyMayMakeNoNegativeNumber() {
        DividedRender render = divided(SETTINGS);
        FilmAssembly film = render.assembly();
        long most = (1L << 62) / film.units();
        for (int unit = 0; unit < film.units(); unit++) {
            byte[] result = render.maker().make(unit);
            for (int at = 0; at < ResultHeader.length(render.outline().kinds().size()); at += Long.BYTES) {
                ByteBuffer.wrap(result).putLong(at, most);
            }
            film.put(unit, result);
        }
        RenderReport report = film.result().report();
        long all = most * film.units();
        report.raysByKind().values().forEach(n -> assertEquals(all, n));
        assertEquals(Long.MAX_VALUE, report.rays(), "of four kinds there are more than a number can tell");
        assertTrue(report.sampling().samplesPerPixel() > 0);
    }

    @Test
    void whatIsDoneIsToldAsAShareOfThePixelsAndThePictureIsThatOfThePathsSoFar() {
        List<Long> told = Collections.synchronizedList(new ArrayList<>());
        List<Image> pictures = Collections.synchronizedList(new ArrayList<>());
        RenderProgress progress = (done, total, soFar) -> {
            assertEquals(3_200, total);
            told.add(done);
            pictures.add(soFar.get());
        };
        RenderResult result = Renderer.render(
                RenderRequest.of(SCENE, SETTINGS).withProgress(progress).withProgressive(true));
        assertEquals(4, told.size());
        assertEquals(3_200, told.get(3));
        assertTrue(told.get(0) >= 800);
        double first = mean(pictures.get(0));
        assertEquals(mean(result.image()), first, 0.02 * first);
    }

    private static double mean(Image image) {
        double sum = 0;
        for (float f : image.toArray()) {
            sum += f;
        }
        return sum / image.toArray().length;
    }

    @Test
    void itCanBeStoppedInTheMiddleOfABatchAndShowsThePathsSoFar() {
        AtomicInteger asked = new AtomicInteger();
        // One thread, each path asks: in the third batch.
        RenderResult result = Renderer.render(RenderRequest.of(SCENE, SETTINGS.withThreads(1))
                .withCancelled(() -> asked.incrementAndGet() > 150_000));
        assertFalse(result.complete());
        assertEquals(3_200 / 2, result.report().pixels());
        assertEquals(3_200, result.shownPixels());
        assertEquals(mean(ALONE.image()), mean(result.image()), 0.02 * mean(ALONE.image()));
    }

    @Test
    void samplesAndErrorAreToldOfEachPixel() {
        RenderResult result = Renderer.render(RenderRequest.of(SCENE, SETTINGS)
                .withAuxiliary(RenderResult.Auxiliary.SAMPLES, RenderResult.Auxiliary.ERROR));
        Image samples = result.auxiliary().get(RenderResult.Auxiliary.SAMPLES);
        Image errors = result.auxiliary().get(RenderResult.Auxiliary.ERROR);
        assertEquals(64, samples.component(3, 3, 0));
        double mean = mean(errors);
        assertTrue(mean > 0.01 && mean < 0.3, "mean error " + mean);
        double estimated = result.report().sampling().estimatedError();
        assertEquals(estimated, mean, 0.5 * estimated);
    }

    @Test
    void anErrorIsReachedInRoundsAfterAFirstPictureOfFewPaths() {
        RenderSettings settings = SETTINGS.withBudget(RenderSettings.Budget.NONE.withError(0.2));
        RenderResult result = Renderer.render(RenderRequest.of(SCENE, settings));
        assertTrue(result.report().isErrorMet(), result.report().sampling().toString());
        assertTrue(result.report().sampling().rounds() > 1);
        assertEquals("error", result.report().sampling().decidedBy());
        RenderSettings same = SETTINGS.withBudget(RenderSettings.Budget.NONE.withSamples(
                result.report().sampling().plannedSamples()));
        assertArrayEquals(Renderer.render(SCENE, same).toArray(), result.image().toArray());
        DividedRender render = divided(settings);
        assertEquals(4, render.plan().samples());
        assertTrue(
                render.notes().get(0).contains("no trials for an error"),
                render.notes().get(0));
    }

    @Test
    void aTimeIsMadeANumberOfPathsByTrials() {
        RenderSettings settings = SETTINGS.withThreads(1).withBudget(RenderSettings.Budget.NONE.withSeconds(1));
        double slow = planned(settings, 1_000);
        assertEquals(slow, planned(settings, 1_000));
        assertTrue(slow > 1, slow + " paths per pixel");
        assertTrue(planned(settings, 250) > slow);
        // The whole picture's paths are followed for a part of it.
        assertEquals(slow, planned(settings.withCrop(new RenderSettings.Crop(1, 1, 8, 8)), 1_000));
    }

    /** By a clock that goes on whenever it is read: for each path. */
    private static double planned(RenderSettings settings, long nanosPerReading) {
        AtomicLong clock = new AtomicLong();
        RenderPlan plan = new Planner(SceneCompiler.compile(SCENE, settings), settings, () -> false)
                .plan(new Stopwatch(() -> clock.getAndAdd(nanosPerReading)), 0);
        assertEquals("time", plan.decidedBy());
        return plan.samples();
    }

    @Test
    void batchesOfHugeRendersAreLargerAndNotMore() {
        RenderSettings settings = SETTINGS.withSize(1_000, 1_000);
        for (double samples : new double[] {1, 100, 1e5, 1e8}) {
            WorkUnits units =
                    WorkUnits.forMachines(settings, new RenderPlan(settings.method(), samples, samples, "samples"));
            assertTrue(units.count() <= 1 << 18, units.count() + " units");
            assertEquals((long) (samples * 1e6), units.paths());
            int last = units.count() - 1;
            assertEquals(units.paths(), units.firstPath(last) + units.paths(last));
            assertTrue(samples > 1e4 || units.paths(0) == 1 << 16);
        }
    }
}
