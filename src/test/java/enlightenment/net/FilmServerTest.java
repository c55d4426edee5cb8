package enlightenment.net;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.image.Image;
import enlightenment.net.protocol.Timing;
import enlightenment.physical.InvarianceScenes;
import enlightenment.render.RenderProgress;
import enlightenment.render.RenderResult;
import enlightenment.render.Renderer;
import enlightenment.render.TestScenes;
import enlightenment.scene.Budget;
import enlightenment.scene.RayTraceSettings;
import enlightenment.scene.RenderSettings;
import enlightenment.scene.Scene;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Map;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.stream.IntStream;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

/** The frames of a film as one job: workers come, stay, die and lie, and each frame is that of one process. */
@Timeout(120)
class FilmServerTest {
    private static final Timing PATIENT = new Timing(120_000, 60_000, 60_000, 120_000, 50, 60_000);
    private static final Scene ROOM = TestScenes.whiteFireAndIce().build();
    private static final Scene PHYSICAL_ROOM = InvarianceScenes.byRadiance();

    private final List<String> log = Collections.synchronizedList(new ArrayList<>());
    private final Map<Integer, Image> frames = new ConcurrentHashMap<>();
    private final Map<Integer, Integer> times = new ConcurrentHashMap<>();
    private final AtomicBoolean stop = new AtomicBoolean();
    private final AtomicBoolean stopWorkers = new AtomicBoolean();
    private FilmServer server;

    /** Frames of different sizes; every third is of linear light, with batches of light paths beside tiles. */
    private static FilmServer.Frame frame(int number) {
        boolean isPhysical = number % 3 == 2;
        RenderSettings settings = RenderSettings.of(isPhysical ? PHYSICAL_ROOM : ROOM)
                .withThreads(1)
                .withSize(40 + number, 21)
                .with(new RayTraceSettings(1));
        return new FilmServer.Frame(isPhysical ? PHYSICAL_ROOM : ROOM, settings.withSeed(number));
    }

    private static List<Integer> numbers(int count) {
        return IntStream.range(0, count).boxed().toList();
    }

    private CompletableFuture<Boolean> serve(int count, ServerOptions.Builder options) throws IOException {
        return serve(numbers(count), FilmServerTest::frame, options);
    }

    private CompletableFuture<Boolean> serve(
            List<Integer> numbers, java.util.function.IntFunction<FilmServer.Frame> film, ServerOptions.Builder options)
            throws IOException {
        server = FilmServer.start(
                numbers, film, options.address("127.0.0.1", 0).log(log::add).build(), () -> false);
        return daemon(() -> server.await(this::take, RenderProgress.NONE, stop::get));
    }

    private void take(int number, RenderResult result) {
        assertTrue(result.complete());
        frames.put(number, result.image());
        times.merge(number, 1, Integer::sum);
    }

    @FunctionalInterface
    private interface Work<T> {
        T run() throws IOException;
    }

    private static <T> CompletableFuture<T> daemon(Work<T> work) {
        return CompletableFuture.supplyAsync(
                () -> {
                    try {
                        return work.run();
                    } catch (IOException e) {
                        throw new UncheckedIOException(e);
                    }
                },
                run -> {
                    Thread thread = new Thread(run, "film");
                    thread.setDaemon(true);
                    thread.start();
                });
    }

    private CompletableFuture<RenderWorker.Outcome> worker(WorkerOptions.Builder options, int port) {
        return daemon(() -> RenderWorker.run("127.0.0.1", port, options.build(), stopWorkers::get));
    }

    private static void check(Map<Integer, Image> frames, int count) {
        assertEquals(count, frames.size());
        for (int n = 0; n < count; n++) {
            FilmServer.Frame frame = frame(n);
            assertArrayEquals(
                    Renderer.render(frame.scene(), frame.settings()).toArray(),
                    frames.get(n).toArray(),
                    "frame " + n);
        }
    }

    @AfterEach
    void end() {
        stop.set(true);
        stopWorkers.set(true);
        if (server != null) {
            server.close();
        }
    }

    @Test
    void twoWorkersStayFromTheFirstFrameToTheLastAndEachFrameIsThatOfOneProcess() throws Exception {
        CompletableFuture<Boolean> film = serve(7, Farm.options().awaitWorkers(2, 60));
        List<CompletableFuture<RenderWorker.Outcome>> workers =
                List.of(worker(Farm.worker(1), server.port()), worker(Farm.worker(2), server.port()));
        assertTrue(film.get(60, TimeUnit.SECONDS));
        check(frames, 7);
        assertEquals(2, log.stream().filter(line -> line.endsWith(" joined")).count(), log.toString());
        for (CompletableFuture<RenderWorker.Outcome> worker : workers) {
            assertTrue(worker.get(20, TimeUnit.SECONDS).isDone());
            assertTrue(worker.get().tiles() > 0);
        }
    }

    @Test
    void aWorkerThatDiesInTheMiddleChangesNothing() throws Exception {
        CompletableFuture<Boolean> film = serve(7, Farm.options().awaitWorkers(2, 60));
        try (FaultProxy proxy = new FaultProxy(server.port())) {
            worker(Farm.slow(20), server.port());
            AtomicInteger made = new AtomicInteger();
            worker(
                    Farm.worker(1).reconnectSeconds(0).tamper((tile, bytes) -> {
                        if (made.incrementAndGet() == 12) {
                            // Its connection is reset with tiles in hand, and it is never heard of again.
                            proxy.cut();
                        }
                        return bytes;
                    }),
                    proxy.port());
            assertTrue(film.get(60, TimeUnit.SECONDS));
            assertTrue(made.get() >= 12, "it died too late");
        }
        check(frames, 7);
    }

    @Test
    void theServerAloneMakesItToo() throws Exception {
        assertTrue(serve(4, Farm.options().localThreads(2)).get(60, TimeUnit.SECONDS));
        check(frames, 4);
    }

    /** What it said of frames that are whole and were given away is not believed any more: they are made again. */
    @Test
    void framesThatAMachineMadeWhichIsFoundOutComeAgain() throws Exception {
        CompletableFuture<Boolean> film =
                serve(6, Farm.options().timing(PATIENT).auditRate(0).awaitWorkers(1, 60));
        worker(
                Farm.worker(1)
                        .timing(PATIENT)
                        .machine("liar")
                        .tamper((tile, bytes) -> frames.size() < 2 ? lie(bytes) : new byte[3]),
                server.port());
        Farm.until(() -> log.stream().anyMatch(line -> line.contains(" expelled")), "it is found out");
        List<Image> wrong = List.copyOf(frames.values());
        assertTrue(wrong.size() >= 2);
        worker(Farm.worker(2).timing(PATIENT).machine("honest"), server.port());
        assertTrue(film.get(60, TimeUnit.SECONDS));
        check(frames, 6);
        assertEquals(2, times.get(0));
        assertEquals(2, times.get(1));
        assertEquals(1, times.get(5));
    }

    /** Bytes with nothing wrong about them but what they say. */
    private static byte[] lie(byte[] bytes) {
        byte[] wrong = bytes.clone();
        wrong[wrong.length - 1] ^= 1;
        return wrong;
    }

    @Test
    void framesThatAreNotAsExactAsAskedAreRenderedAgainWithMoreSamples() throws Exception {
        java.util.function.IntFunction<FilmServer.Frame> film = n -> new FilmServer.Frame(
                ROOM,
                RenderSettings.of(ROOM)
                        .withThreads(1)
                        .withSize(48, 24)
                        .withSeed(n)
                        .withBudget(Budget.NONE.withError(0.03)));
        CompletableFuture<Boolean> done =
                serve(numbers(3), film, Farm.options().awaitWorkers(1, 60).localThreads(1));
        worker(Farm.worker(1), server.port());
        assertTrue(done.get(100, TimeUnit.SECONDS));
        for (int n = 0; n < 3; n++) {
            FilmServer.Frame frame = film.apply(n);
            assertArrayEquals(
                    Renderer.render(frame.scene(), frame.settings()).toArray(),
                    frames.get(n).toArray());
        }
    }

    @Test
    void aFilmThatIsStoppedKeepsTheFramesThatAreWhole() throws Exception {
        CompletableFuture<Boolean> film = serve(6, Farm.options().awaitWorkers(1, 60));
        worker(Farm.slow(5), server.port());
        Farm.until(() -> frames.size() >= 2, "two frames are whole");
        stop.set(true);
        assertFalse(film.get(60, TimeUnit.SECONDS));
        for (Map.Entry<Integer, Image> e : frames.entrySet()) {
            FilmServer.Frame frame = frame(e.getKey());
            assertArrayEquals(
                    Renderer.render(frame.scene(), frame.settings()).toArray(),
                    e.getValue().toArray());
        }
    }

    @Test
    void whatNoFilmCanHaveIsRefused() {
        IllegalArgumentException checkpoint = assertThrows(
                IllegalArgumentException.class, () -> serve(2, Farm.options().checkpoint(Path.of("film.ck"))));
        assertTrue(checkpoint.getMessage().startsWith("a film has no checkpoint"), checkpoint.getMessage());
        IllegalArgumentException time = assertThrows(
                IllegalArgumentException.class,
                () -> serve(
                        numbers(1),
                        n -> new FilmServer.Frame(ROOM, RenderSettings.of(ROOM).withBudget(Budget.NONE.withSeconds(1))),
                        Farm.options()));
        assertTrue(time.getMessage().contains("must not depend on the time"), time.getMessage());
    }
}
