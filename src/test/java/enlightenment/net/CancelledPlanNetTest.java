package enlightenment.net;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.net.parts.RenderParts;
import enlightenment.render.RenderProgress;
import enlightenment.render.RenderRequest;
import enlightenment.render.RenderResult;
import enlightenment.render.Renderer;
import enlightenment.scene.Method;
import enlightenment.scene.RenderSettings;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.concurrent.CancellationException;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.function.BooleanSupplier;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;

/** What many machines are to make is not begun with a plan that was made while it was stopped. */
@Timeout(600)
class CancelledPlanNetTest {
    private static final RenderSettings SURVEYED =
            Farm.SETTINGS.withMethod(Method.CLUSTER).withBudget(RenderSettings.Budget.NONE.withSamples(8));

    @TempDir
    Path folder;

    /** Stops soon after planning has begun. */
    private static BooleanSupplier soon() {
        AtomicInteger asked = new AtomicInteger();
        return () -> asked.incrementAndGet() > 3;
    }

    private void assertNothingIsKept() throws IOException {
        try (Stream<Path> files = Files.list(folder)) {
            assertEquals(List.of(), files.toList());
        }
    }

    @Test
    void aServerIsNotStarted() throws IOException {
        ServerOptions options =
                Farm.options().checkpoint(folder.resolve("checkpoint")).build();
        assertThrows(CancellationException.class, () -> RenderServer.start(Farm.SCENE, SURVEYED, options, soon()));
        assertNothingIsKept();
    }

    @Test
    void anotherEnginesJobIsNotStarted() throws IOException {
        assertThrows(
                CancellationException.class,
                () -> EngineJob.start(Farm.SCENE, SURVEYED, folder.resolve("checkpoint"), note -> {}, soon()));
        assertNothingIsKept();
    }

    @Test
    void aPartIsNotWritten() throws IOException {
        assertThrows(
                CancellationException.class,
                () -> RenderParts.render(
                        RenderRequest.of(Farm.SCENE, SURVEYED).withCancelled(soon()),
                        1,
                        2,
                        samples -> Map.of(),
                        folder.resolve("part.film")));
        assertNothingIsKept();
    }

    @Test
    void aFilmIsNotStarted() {
        assertThrows(
                CancellationException.class,
                () -> RenderServer.OfFilm.start(
                        List.of(0),
                        number -> new RenderServer.OfFilm.Frame(Farm.SCENE, SURVEYED),
                        Farm.options().build(),
                        soon()));
    }

    @Test
    void aServersFurtherRoundIsNotBegun() throws IOException {
        RenderSettings settings = Farm.SETTINGS.withBudget(RenderSettings.Budget.NONE.withError(0.01));
        AtomicBoolean stop = new AtomicBoolean();
        List<String> said = Collections.synchronizedList(new ArrayList<>());
        ServerOptions options = Farm.options()
                .localThreads(1)
                .log(line -> {
                    said.add(line);
                    stop.set(stop.get() || line.contains("once more with"));
                })
                .build();
        try (RenderServer server = RenderServer.start(Farm.SCENE, settings, options, stop::get)) {
            RenderResult result = server.await(RenderProgress.NONE, () -> false);
            assertTrue(stop.get());
            assertTrue(result.complete());
            assertEquals(1, result.report().sampling().rounds());
            double samples = result.report().sampling().plannedSamples();
            RenderSettings first = settings.withBudget(RenderSettings.Budget.NONE.withSamples(samples));
            assertArrayEquals(
                    Renderer.render(Farm.SCENE, first).toArray(), result.image().toArray());
            assertTrue(said.contains(stopped(samples)), said.toString());
        }
    }

    /** What {@code render} says, too. */
    private static String stopped(double samples) {
        return String.format(
                Locale.ROOT, "stopped: the picture is that of the round before, with %.0f samples per pixel", samples);
    }

    @Test
    void aServerThatIsStoppedInAFurtherRoundSaysThatItWas() throws Exception {
        RenderSettings settings = Farm.SETTINGS.withBudget(RenderSettings.Budget.NONE.withError(0.01));
        try (Farm farm = new Farm(Farm.SCENE, settings, Farm.options()).begin()) {
            CountDownLatch isOver = new CountDownLatch(1);
            CountDownLatch isFurther = new CountDownLatch(1);
            // Of the further round no tile is ever sent.
            farm.join(Farm.worker(1).tamper((tile, bytes) -> {
                if (farm.logHas("once more with")) {
                    isFurther.countDown();
                    Farm.until(() -> isOver.getCount() == 0, "the server is stopped");
                }
                return bytes;
            }));
            Farm.until(() -> isFurther.getCount() == 0, "the further round has begun");
            RenderResult result = farm.stop();
            isOver.countDown();
            assertTrue(result.complete());
            assertEquals(1, result.report().sampling().rounds());
            String expected = stopped(result.report().sampling().plannedSamples());
            assertTrue(farm.logHas(expected), farm.log.toString());
        }
    }

    /** What a server makes that is stopped as soon as a round has all of its pixels. */
    private static RenderResult stoppedAfterARound(double error, List<String> said) throws Exception {
        RenderSettings settings = Farm.SETTINGS.withBudget(RenderSettings.Budget.NONE.withError(error));
        ServerOptions options = Farm.options().localThreads(1).log(said::add).build();
        AtomicBoolean stop = new AtomicBoolean();
        RenderProgress whole = (done, total, soFar) -> stop.set(done == total);
        try (RenderServer server = RenderServer.start(Farm.SCENE, settings, options, () -> false)) {
            return server.await(whole, stop::get);
        }
    }

    @Test
    void aServerThatIsStoppedBetweenRoundsSaysThatItWas() throws Exception {
        List<String> said = Collections.synchronizedList(new ArrayList<>());
        RenderResult result = stoppedAfterARound(0.01, said);
        assertTrue(result.complete());
        assertTrue(said.contains(stopped(result.report().sampling().plannedSamples())), said.toString());
    }

    @Test
    void aServerWhosePictureIsAsExactAsAskedIsNotSaidToBeStopped() throws Exception {
        List<String> said = Collections.synchronizedList(new ArrayList<>());
        assertTrue(stoppedAfterARound(0.9, said).report().isErrorMet());
        assertTrue(said.stream().noneMatch(line -> line.startsWith("stopped")), said.toString());
    }

    @Test
    void aFilmWhoseFurtherRoundIsNotPlannedLacksFrames() throws IOException {
        RenderSettings settings = Farm.SETTINGS.withBudget(RenderSettings.Budget.NONE.withError(0.01));
        AtomicBoolean stop = new AtomicBoolean();
        ServerOptions options = Farm.options()
                .localThreads(1)
                .log(line -> stop.set(stop.get() || line.contains("once more with")))
                .build();
        try (RenderServer.OfFilm server = RenderServer.OfFilm.start(
                List.of(0), number -> new RenderServer.OfFilm.Frame(Farm.SCENE, settings), options, stop::get)) {
            AtomicInteger given = new AtomicInteger();
            assertFalse(server.await((number, result) -> given.incrementAndGet(), RenderProgress.NONE, () -> false));
            assertTrue(stop.get());
            assertEquals(0, given.get());
        }
    }
}
