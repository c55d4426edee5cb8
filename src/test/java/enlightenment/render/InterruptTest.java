package enlightenment.render;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.engine.DividedRender;
import enlightenment.scene.BuiltInMethod;
import enlightenment.scene.RenderSettings;
import enlightenment.scene.Scene;
import enlightenment.scene.json.SceneReader;
import enlightenment.work.Workers;
import java.nio.file.Path;
import java.util.List;
import java.util.Set;
import java.util.concurrent.CancellationException;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.atomic.AtomicInteger;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Who interrupts the thread that renders gets it back soon, with what there is. */
class InterruptTest {
    private static final Scene SCENE = TestScenes.whiteFireAndIce().size(80, 40).build();
    private static final RenderSettings QUICK =
            RenderSettings.of(SCENE).withAntialias(1).with(new BuiltInMethod.RayTraceSettings(1));
    private static final int TILE = 8 * 8;

    @AfterEach
    void takeTheInterruptBack() {
        Thread.interrupted();
    }

    @ParameterizedTest
    @ValueSource(ints = {1, 3})
    void anInterruptEndsTheRenderAfterTheTilesUnderWay(int threads) {
        Thread caller = Thread.currentThread();
        RenderResult result = Renderer.render(
                SCENE, QUICK.withThreads(threads), (done, total, soFar) -> caller.interrupt(), () -> false);
        assertFalse(result.complete());
        long pixels = result.report().pixels();
        assertTrue(pixels >= TILE && pixels <= (long) threads * TILE, pixels + " pixels");
        assertEquals(pixels, result.shownPixels());
        assertTrue(Thread.interrupted(), "the interrupt stays set");
    }

    @Test
    void anInterruptBeforeTheRenderLeavesNothingToShow() {
        Thread.currentThread().interrupt();
        RenderResult result = Renderer.render(RenderRequest.of(SCENE, QUICK).withProgressive(true));
        assertFalse(result.complete());
        assertEquals(0, result.shownPixels());
        assertTrue(Thread.interrupted());
    }

    @Test
    void anInterruptDoesNotKeepTexturesFromBeingRead() {
        Path file = Path.of(System.getProperty("project.directory"), "scenes", "fire-and-ice.json");
        Scene scene = SceneReader.read(file);
        RenderSettings settings = RenderSettings.of(scene).withSize(16, 8);
        Thread.currentThread().interrupt();
        assertTrue(Renderer.inspect(scene, settings).primitives() > 0);
        // Of a render there would be nothing to see: it does not read them all.
        assertThrows(CancellationException.class, () -> Renderer.render(RenderRequest.of(scene, settings)));
        assertTrue(Thread.interrupted());
    }

    @Test
    void whoAsksForAnImageOnlyIsNotGivenHalfOfIt() {
        Thread.currentThread().interrupt();
        assertThrows(CancellationException.class, () -> Renderer.render(SCENE, QUICK));
        assertTrue(Thread.interrupted());
        assertEquals(80, Renderer.render(SCENE, QUICK).width());
    }

    @Test
    void anInterruptWhileItWaitsForHelpersEndsTheirWorkToo() {
        Thread caller = Thread.currentThread();
        AtomicInteger pieces = new AtomicInteger();
        // The calling thread leaves all to the helper, and waits for it.
        Workers.run(2, 1000, () -> Thread.currentThread() == caller, () -> piece -> {
            while (caller.getState() != Thread.State.WAITING) {
                Thread.onSpinWait();
            }
            pieces.incrementAndGet();
            caller.interrupt();
            // Until it has heard of it.
            while (caller.isInterrupted()) {
                Thread.onSpinWait();
            }
        });
        assertTrue(pieces.get() >= 1 && pieces.get() < 1000, pieces + " pieces");
        assertTrue(Thread.interrupted());
    }

    @Test
    void tilesStopToo() {
        Thread caller = Thread.currentThread();
        DividedRender render = DividedRender.prepare(SCENE, QUICK.withThreads(1), () -> false);
        Set<Integer> made = ConcurrentHashMap.newKeySet();
        int[] all = {0, 1, 2};
        render.make(all, List.of(), () -> false, (tile, bytes) -> {
            made.add(tile);
            caller.interrupt();
        });
        assertEquals(Set.of(0), made);
        assertTrue(Thread.interrupted());
    }
}
