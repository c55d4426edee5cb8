package enlightenment.net;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.device.OpenClDriver;
import enlightenment.engine.DividedRender;
import enlightenment.image.Image;
import enlightenment.physical.InvarianceScenes;
import enlightenment.render.RenderProgress;
import enlightenment.render.RenderRequest;
import enlightenment.render.RenderResult;
import enlightenment.render.Renderer;
import enlightenment.render.TestScenes;
import enlightenment.scene.BuiltInMethod;
import enlightenment.scene.RenderSettings;
import enlightenment.scene.Scene;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.stream.IntStream;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;

/** The frames of a film as one job: workers come, stay, die and lie, and each frame is that of one process. */
@Timeout(600)
class FilmServerTest {
    private static final Scene ROOM = TestScenes.whiteFireAndIce().build();
    private static final Scene PHYSICAL_ROOM = InvarianceScenes.byRadiance();

    private final List<String> log = Collections.synchronizedList(new ArrayList<>());
    private final Map<Integer, Image> frames = new ConcurrentHashMap<>();
    private final Map<Integer, Integer> times = new ConcurrentHashMap<>();
    private final AtomicBoolean stop = new AtomicBoolean();
    private final AtomicBoolean stopWorkers = new AtomicBoolean();
    private RenderServer.OfFilm server;

    /** Frames of different sizes; every third is of linear light, with batches of light paths beside tiles. */
    private static RenderServer.OfFilm.Frame frame(int number) {
        boolean isPhysical = number % 3 == 2;
        RenderSettings settings = RenderSettings.of(isPhysical ? PHYSICAL_ROOM : ROOM)
                .withThreads(1)
                .withSize(40 + number, 21)
                .with(new BuiltInMethod.RayTraceSettings(1));
        return new RenderServer.OfFilm.Frame(isPhysical ? PHYSICAL_ROOM : ROOM, settings.withSeed(number));
    }

    /** Number of units of the first so many frames. */
    private static int unitsOfFirst(int count) {
        return numbers(count).stream()
                .map(FilmServerTest::frame)
                .mapToInt(f -> DividedRender.prepare(f.scene(), f.settings(), () -> false)
                        .units())
                .sum();
    }

    private static List<Integer> numbers(int count) {
        return IntStream.range(0, count).boxed().toList();
    }

    private CompletableFuture<Boolean> serve(int count, ServerOptions.Builder options) throws IOException {
        return serve(numbers(count), FilmServerTest::frame, options);
    }

    private CompletableFuture<Boolean> serve(
            List<Integer> numbers,
            java.util.function.IntFunction<RenderServer.OfFilm.Frame> film,
            ServerOptions.Builder options)
            throws IOException {
        server = RenderServer.OfFilm.start(
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

    private CompletableFuture<RenderWorker.Outcome> worker(RenderWorker.Options.Builder options, int port) {
        return daemon(() -> RenderWorker.run("127.0.0.1", port, options.build(), stopWorkers::get));
    }

    private static void check(Map<Integer, Image> frames, int count) {
        assertEquals(count, frames.size());
        for (int n = 0; n < count; n++) {
            RenderServer.OfFilm.Frame frame = frame(n);
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
    void framesWhosePixelsAreInFilesAreThoseOfOneProcess(@TempDir Path folder) throws Exception {
        ServerOptions.Builder options = Farm.options().awaitWorkers(1, Farm.TIMEOUT_SECONDS);
        CompletableFuture<Boolean> film = serve(4, options.scratch(new RenderRequest.ScratchFolder(folder, 0)));
        worker(Farm.worker(2), server.port());
        assertTrue(film.get(Farm.TIMEOUT_SECONDS, TimeUnit.SECONDS));
        check(frames, 4);
    }

    @Test
    void twoWorkersStayFromTheFirstFrameToTheLastAndEachFrameIsThatOfOneProcess() throws Exception {
        CompletableFuture<Boolean> film = serve(7, Farm.options().awaitWorkers(2, Farm.TIMEOUT_SECONDS));
        // Neither goes on before both have made something, however the machine shares its time out.
        List<AtomicInteger> made = List.of(new AtomicInteger(), new AtomicInteger());
        List<CompletableFuture<RenderWorker.Outcome>> workers = new ArrayList<>();
        for (int i = 0; i < 2; i++) {
            AtomicInteger mine = made.get(i);
            AtomicInteger others = made.get(1 - i);
            workers.add(worker(
                    Farm.worker(i + 1).tamper((unit, bytes) -> {
                        mine.incrementAndGet();
                        Farm.until(() -> others.get() > 0, "the other worker has made something");
                        return bytes;
                    }),
                    server.port()));
        }
        assertTrue(film.get(Farm.TIMEOUT_SECONDS, TimeUnit.SECONDS));
        check(frames, 7);
        assertEquals(2, log.stream().filter(line -> line.endsWith(" joined")).count(), log.toString());
        for (CompletableFuture<RenderWorker.Outcome> worker : workers) {
            assertTrue(worker.get(Farm.TIMEOUT_SECONDS, TimeUnit.SECONDS).isDone());
            assertTrue(worker.get().tiles() > 0);
        }
    }

    /** Its threads go from frame to frame, of both kinds of shading. */
    @Test
    void aWorkerWithADeviceMakesTheSameFrames() throws Exception {
        OpenClDriver.assume();
        CompletableFuture<Boolean> film = serve(4, Farm.options().awaitWorkers(1, Farm.TIMEOUT_SECONDS));
        worker(Farm.worker(1).device("opencl"), server.port());
        assertTrue(film.get(Farm.TIMEOUT_SECONDS, TimeUnit.SECONDS));
        check(frames, 4);
    }

    /** What is left of a film may be one frame, whose units are a film's all the same. */
    @Test
    void aWorkerMakesTheOnlyFrameOfAFilm() throws Exception {
        CompletableFuture<Boolean> film = serve(1, Farm.options().auditRate(1).awaitWorkers(1, Farm.TIMEOUT_SECONDS));
        CompletableFuture<RenderWorker.Outcome> worker = worker(Farm.worker(1), server.port());
        assertTrue(film.get(Farm.TIMEOUT_SECONDS, TimeUnit.SECONDS));
        check(frames, 1);
        assertTrue(log.stream().noneMatch(line -> line.contains("expelled")), log.toString());
        assertTrue(worker.get(Farm.TIMEOUT_SECONDS, TimeUnit.SECONDS).tiles() > 0);
    }

    @Test
    void aWorkerThatDiesInTheMiddleChangesNothing() throws Exception {
        CompletableFuture<Boolean> film = serve(7, Farm.options().awaitWorkers(2, Farm.TIMEOUT_SECONDS));
        try (FaultProxy proxy = new FaultProxy(server.port())) {
            AtomicInteger made = new AtomicInteger();
            worker(
                    Farm.worker(1).tamper((unit, bytes) -> {
                        Farm.until(() -> made.get() >= 12, "the other worker is dead");
                        return bytes;
                    }),
                    server.port());
            worker(
                    Farm.worker(1).reconnectSeconds(0).tamper((tile, bytes) -> {
                        if (made.incrementAndGet() == 12) {
                            // Its connection is reset with tiles in hand, and it is never heard of again.
                            proxy.cut();
                        }
                        return bytes;
                    }),
                    proxy.port());
            assertTrue(film.get(Farm.TIMEOUT_SECONDS, TimeUnit.SECONDS));
        }
        check(frames, 7);
    }

    @Test
    void theServerAloneMakesItToo() throws Exception {
        assertTrue(serve(4, Farm.options().localThreads(2)).get(Farm.TIMEOUT_SECONDS, TimeUnit.SECONDS));
        check(frames, 4);
    }

    /** What it said of frames that are whole and were given away is not believed any more: they are made again. */
    @Test
    void framesThatAMachineMadeWhichIsFoundOutComeAgain() throws Exception {
        CompletableFuture<Boolean> film = serve(6, Farm.options().auditRate(0).awaitWorkers(1, Farm.TIMEOUT_SECONDS));
        int ofTwoFrames = unitsOfFirst(2);
        worker(
                Farm.worker(1).machine("liar").tamper((unit, bytes) -> {
                    if (unit < ofTwoFrames) {
                        return lie(bytes);
                    }
                    // Of no further frame it makes all units, however long it takes until two are given away.
                    Farm.until(() -> frames.size() == 2, "two frames are given away");
                    return new byte[3];
                }),
                server.port());
        Farm.until(() -> log.stream().anyMatch(line -> line.contains(" expelled")), "it is found out");
        assertEquals(Set.of(0, 1), frames.keySet());
        worker(Farm.worker(2).machine("honest"), server.port());
        assertTrue(film.get(Farm.TIMEOUT_SECONDS, TimeUnit.SECONDS));
        check(frames, 6);
        assertEquals(Map.of(0, 2, 1, 2, 2, 1, 3, 1, 4, 1, 5, 1), times);
    }

    /** Bytes with nothing wrong about them but what they say. */
    private static byte[] lie(byte[] bytes) {
        byte[] wrong = bytes.clone();
        wrong[wrong.length - 1] ^= 1;
        return wrong;
    }

    @Test
    void framesThatAreNotAsExactAsAskedAreRenderedAgainWithMoreSamples() throws Exception {
        java.util.function.IntFunction<RenderServer.OfFilm.Frame> film = n -> new RenderServer.OfFilm.Frame(
                ROOM,
                RenderSettings.of(ROOM)
                        .withThreads(1)
                        .withSize(48, 24)
                        .withSeed(n)
                        .withBudget(RenderSettings.Budget.NONE.withError(0.03)));
        CompletableFuture<Boolean> done = serve(
                numbers(3),
                film,
                Farm.options().awaitWorkers(1, Farm.TIMEOUT_SECONDS).localThreads(1));
        worker(Farm.worker(1), server.port());
        assertTrue(done.get(Farm.TIMEOUT_SECONDS, TimeUnit.SECONDS));
        for (int n = 0; n < 3; n++) {
            RenderServer.OfFilm.Frame frame = film.apply(n);
            assertArrayEquals(
                    Renderer.render(frame.scene(), frame.settings()).toArray(),
                    frames.get(n).toArray());
        }
    }

    @Test
    void aFilmThatIsStoppedKeepsTheFramesThatAreWhole() throws Exception {
        CompletableFuture<Boolean> film = serve(6, Farm.options().awaitWorkers(1, Farm.TIMEOUT_SECONDS));
        int ofFiveFrames = unitsOfFirst(5);
        worker(
                Farm.worker(1).tamper((unit, bytes) -> {
                    // Not only until it is told to stop: it hears that a little later.
                    Farm.until(() -> unit < ofFiveFrames || film.isDone(), "the film is stopped");
                    return bytes;
                }),
                server.port());
        Farm.until(() -> frames.size() >= 2, "two frames are whole");
        stop.set(true);
        assertFalse(film.get(Farm.TIMEOUT_SECONDS, TimeUnit.SECONDS));
        for (Map.Entry<Integer, Image> e : frames.entrySet()) {
            RenderServer.OfFilm.Frame frame = frame(e.getKey());
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
                        n -> new RenderServer.OfFilm.Frame(
                                ROOM, RenderSettings.of(ROOM).withBudget(RenderSettings.Budget.NONE.withSeconds(1))),
                        Farm.options()));
        assertTrue(time.getMessage().contains("must not depend on the time"), time.getMessage());
    }
}
