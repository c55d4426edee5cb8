package enlightenment.net;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.render.RenderProgress;
import enlightenment.render.RenderResult;
import enlightenment.render.Renderer;
import enlightenment.scene.Budget;
import enlightenment.scene.Method;
import enlightenment.scene.RenderSettings;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.concurrent.CancellationException;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.function.BooleanSupplier;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;

/** What many machines are to make is not begun with a plan that was made while it was stopped. */
@Timeout(120)
class CancelledPlanNetTest {
    private static final RenderSettings SURVEYED =
            Farm.SETTINGS.withMethod(Method.CLUSTER).withBudget(Budget.NONE.withSamples(8));

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
                        Farm.SCENE,
                        SURVEYED,
                        1,
                        2,
                        samples -> Map.of(),
                        folder.resolve("part.film"),
                        RenderProgress.NONE,
                        soon()));
        assertNothingIsKept();
    }

    @Test
    void aFilmIsNotStarted() {
        assertThrows(
                CancellationException.class,
                () -> FilmServer.start(
                        List.of(0),
                        number -> new FilmServer.Frame(Farm.SCENE, SURVEYED),
                        Farm.options().build(),
                        soon()));
    }

    @Test
    void aServersFurtherRoundIsNotBegun() throws IOException {
        RenderSettings settings = Farm.SETTINGS.withBudget(Budget.NONE.withError(0.01));
        AtomicBoolean stop = new AtomicBoolean();
        ServerOptions options = Farm.options()
                .localThreads(1)
                .log(line -> stop.set(stop.get() || line.contains("once more with")))
                .build();
        try (RenderServer server = RenderServer.start(Farm.SCENE, settings, options, stop::get)) {
            RenderResult result = server.await(RenderProgress.NONE, () -> false);
            assertTrue(stop.get());
            assertTrue(result.complete());
            assertEquals(1, result.report().sampling().rounds());
            double samples = result.report().sampling().plannedSamples();
            RenderSettings first = settings.withBudget(Budget.NONE.withSamples(samples));
            assertArrayEquals(
                    Renderer.render(Farm.SCENE, first).toArray(), result.image().toArray());
        }
    }

    @Test
    void aFilmWhoseFurtherRoundIsNotPlannedLacksFrames() throws IOException {
        RenderSettings settings = Farm.SETTINGS.withBudget(Budget.NONE.withError(0.01));
        AtomicBoolean stop = new AtomicBoolean();
        ServerOptions options = Farm.options()
                .localThreads(1)
                .log(line -> stop.set(stop.get() || line.contains("once more with")))
                .build();
        try (FilmServer server = FilmServer.start(
                List.of(0), number -> new FilmServer.Frame(Farm.SCENE, settings), options, stop::get)) {
            AtomicInteger given = new AtomicInteger();
            assertFalse(server.await((number, result) -> given.incrementAndGet(), RenderProgress.NONE, () -> false));
            assertTrue(stop.get());
            assertEquals(0, given.get());
        }
    }
}
