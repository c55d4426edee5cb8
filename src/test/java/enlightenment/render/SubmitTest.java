package enlightenment.render;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.scene.RenderSettings;
import enlightenment.scene.Scene;
import java.awt.image.BufferedImage;
import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.RejectedExecutionException;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

/** Renders on threads of an executor. */
@Timeout(600)
class SubmitTest {
    private static final Scene SCENE = TestScenes.whiteFireAndIce().size(40, 20).build();
    private static final RenderSettings ALONE =
            RenderSettings.of(SCENE).withThreads(1).withTileSize(8);

    private final ExecutorService executor = Executors.newFixedThreadPool(2);

    @AfterEach
    void end() throws InterruptedException {
        executor.shutdownNow();
        assertTrue(executor.awaitTermination(300, TimeUnit.SECONDS), "a render goes on");
    }

    @Test
    void rendersSideBySideGiveThePictureOfOneEachOnItsThread() throws Exception {
        float[] expected = Renderer.render(SCENE, ALONE).toArray();
        Set<Thread> threads = ConcurrentHashMap.newKeySet();
        List<CompletableFuture<RenderResult>> futures = new ArrayList<>();
        for (int i = 0; i < 4; i++) {
            RenderRequest request = RenderRequest.of(SCENE, ALONE)
                    .withProgress((done, total, soFar) -> threads.add(Thread.currentThread()));
            futures.add(Renderer.submit(request, executor));
        }
        for (CompletableFuture<RenderResult> future : futures) {
            assertArrayEquals(expected, future.get().image().toArray());
        }
        assertTrue(threads.size() <= 2 && !threads.contains(Thread.currentThread()), threads.toString());
    }

    @Test
    void anExecutorOfTheCallingThreadRendersThere() {
        CompletableFuture<RenderResult> future = Renderer.submit(RenderRequest.of(SCENE, ALONE), Runnable::run);
        assertTrue(future.isDone());
        assertTrue(future.join().complete());
    }

    @Test
    void cancellingTheFutureEndsTheRender() throws Exception {
        CountDownLatch begun = new CountDownLatch(1);
        CountDownLatch cancelled = new CountDownLatch(1);
        List<Long> told = new ArrayList<>();
        RenderRequest request = RenderRequest.of(SCENE, ALONE).withProgress((done, total, soFar) -> {
            told.add(done);
            begun.countDown();
            await(cancelled);
        });
        CompletableFuture<RenderResult> future = Renderer.submit(request, executor);
        await(begun);
        future.cancel(true);
        cancelled.countDown();
        executor.shutdown();
        assertTrue(executor.awaitTermination(300, TimeUnit.SECONDS));
        assertTrue(future.isCancelled());
        assertEquals(1, told.size(), "units were made after it was cancelled");
    }

    private static void await(CountDownLatch latch) {
        try {
            latch.await();
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
    }

    @Test
    void aRenderThatIsCancelledInTheQueueNeverBegins() {
        List<Runnable> queue = new ArrayList<>();
        List<Long> told = new ArrayList<>();
        CompletableFuture<RenderResult> future = Renderer.submit(
                RenderRequest.of(SCENE, ALONE).withProgress((done, total, soFar) -> told.add(done)), queue::add);
        future.cancel(false);
        queue.get(0).run();
        assertEquals(List.of(), told);
    }

    @Test
    void theWishOfTheRequestStillCounts() throws Exception {
        RenderRequest request = RenderRequest.of(SCENE, ALONE).withCancelled(() -> true);
        assertFalse(Renderer.submit(request, executor).get().complete());
    }

    @Test
    void whatTheListenerThrowsIsWhatTheFutureFailsWith() {
        IllegalStateException fault = new IllegalStateException("a fault");
        RenderRequest request = RenderRequest.of(SCENE, ALONE).withProgress((done, total, soFar) -> {
            throw fault;
        });
        CompletableFuture<RenderResult> future = Renderer.submit(request, executor);
        assertSame(fault, assertThrows(ExecutionException.class, future::get).getCause());
    }

    @Test
    void anExecutorThatIsClosedRefusesAtOnce() {
        executor.shutdown();
        RenderRequest request = RenderRequest.of(SCENE, ALONE);
        assertThrows(RejectedExecutionException.class, () -> Renderer.submit(request, executor));
    }

    @Test
    void aBufferedImageHasThePixelsOfAScreen() {
        var image = Renderer.render(SCENE, ALONE);
        BufferedImage picture = image.toBufferedImage();
        assertEquals(BufferedImage.TYPE_INT_RGB, picture.getType());
        assertArrayEquals(image.toArgb(), picture.getRGB(0, 0, 40, 20, null, 0, 40));
    }
}
