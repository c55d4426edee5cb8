package enlightenment.net;

import enlightenment.image.Image;
import enlightenment.image.ImageFiles;
import enlightenment.net.protocol.Timing;
import enlightenment.render.RenderProgress;
import enlightenment.render.RenderResult;
import enlightenment.render.Renderer;
import enlightenment.render.TestScenes;
import enlightenment.scene.BuiltInMethod;
import enlightenment.scene.RenderSettings;
import enlightenment.scene.Scene;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.net.URI;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.function.BooleanSupplier;

/** A server and its workers, all in this process, on loopback. Deadlines are far away, however busy the machine is. */
public final class Farm implements AutoCloseable {
    static final Scene SCENE = TestScenes.whiteFireAndIce().build();
    static final RenderSettings SETTINGS = RenderSettings.of(SCENE)
            .withSize(75, 42)
            .withAntialias(2)
            .with(new BuiltInMethod.RayTraceSettings(2))
            .withThreads(1);

    /** No deadline comes near, however busy the machine is. A test of a deadline makes that one short, and leaves the others. */
    public static final Timing PATIENT = new Timing(600_000, 600_000, 600_000, 600_000, 200, 600_000);

    /** As long as anything may take: only what hangs takes so long. */
    static final int TIMEOUT_SECONDS = 300;

    private static final double FOR_EVER = 1e6;

    final RenderServer server;
    final List<String> log = Collections.synchronizedList(new ArrayList<>());
    final List<CompletableFuture<RenderWorker.Outcome>> workers = new ArrayList<>();
    private final AtomicBoolean stopServer = new AtomicBoolean();
    private final AtomicBoolean stopWorkers = new AtomicBoolean();
    private CompletableFuture<RenderResult> result;

    Farm(ServerOptions.Builder options) throws IOException {
        this(SCENE, SETTINGS, options);
    }

    Farm(Scene scene, RenderSettings settings, ServerOptions.Builder options) throws IOException {
        server = RenderServer.start(scene, settings, options.log(log::add).build(), () -> false);
    }

    /** No rendering in the server, however long no worker comes; any port, all the patience there is. */
    static ServerOptions.Builder options() {
        return ServerOptions.builder()
                .address("127.0.0.1", 0)
                .localThreads(0)
                .timing(PATIENT)
                .awaitWorkers(0, FOR_EVER);
    }

    static RenderWorker.Options.Builder worker(int threads) {
        return RenderWorker.Options.builder().threads(threads).timing(PATIENT).reconnectSeconds(TIMEOUT_SECONDS);
    }

    /** A worker that needs so long for each tile beside rendering it. */
    static RenderWorker.Options.Builder slow(int millis) {
        return worker(1).tamper((tile, bytes) -> {
            sleep(millis);
            return bytes;
        });
    }

    /** A worker that says so many units and then nothing until it may, however fast the machine is. */
    static RenderWorker.Options.Builder stuckAfter(int units, CountDownLatch freed) {
        AtomicInteger said = new AtomicInteger();
        return worker(1).tamper((unit, bytes) -> {
            try {
                if (said.getAndIncrement() >= units) {
                    freed.await();
                }
            } catch (InterruptedException e) {
                Thread.currentThread().interrupt();
            }
            return bytes;
        });
    }

    static void sleep(long millis) {
        try {
            Thread.sleep(millis);
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
    }

    Farm begin() {
        result = CompletableFuture.supplyAsync(
                () -> {
                    try {
                        return server.await(RenderProgress.NONE, stopServer::get);
                    } catch (IOException e) {
                        throw new UncheckedIOException(e);
                    }
                },
                work -> daemon(work, "farm"));
        return this;
    }

    private static void daemon(Runnable work, String name) {
        Thread thread = new Thread(work, name);
        thread.setDaemon(true);
        thread.start();
    }

    CompletableFuture<RenderWorker.Outcome> join(RenderWorker.Options.Builder options) {
        return join(options, server.port(), stopWorkers::get);
    }

    CompletableFuture<RenderWorker.Outcome> join(RenderWorker.Options.Builder options, int port, BooleanSupplier stop) {
        CompletableFuture<RenderWorker.Outcome> worker = CompletableFuture.supplyAsync(
                () -> {
                    try {
                        return RenderWorker.run("127.0.0.1", port, options.build(), stop);
                    } catch (IOException e) {
                        throw new UncheckedIOException(e);
                    }
                },
                work -> daemon(work, "farm worker"));
        workers.add(worker);
        return worker;
    }

    /** Ends the server as Ctrl-C does. */
    RenderResult stop() throws Exception {
        stopServer.set(true);
        return result();
    }

    RenderResult result() throws Exception {
        return result.get(TIMEOUT_SECONDS, TimeUnit.SECONDS);
    }

    /** Waits until that is so, for as long as anything may take. */
    static void until(BooleanSupplier condition, String what) {
        long end = System.nanoTime() + TIMEOUT_SECONDS * 1_000_000_000L;
        while (!condition.getAsBoolean()) {
            if (System.nanoTime() - end > 0) {
                throw new AssertionError("waited in vain until " + what);
            }
            sleep(5);
        }
    }

    /** What the status page's server answers. */
    String status(String path) throws IOException {
        URI uri = URI.create("http://127.0.0.1:" + server.statusPort() + "/" + path);
        try (InputStream in = uri.toURL().openStream()) {
            return new String(in.readAllBytes(), StandardCharsets.UTF_8);
        }
    }

    boolean logHas(String words) {
        synchronized (log) {
            return log.stream().anyMatch(line -> line.contains(words));
        }
    }

    static byte[] png(Image image) {
        ByteArrayOutputStream out = new ByteArrayOutputStream();
        try {
            ImageFiles.toPng(image, out, ImageFiles.PngOptions.DEFAULT);
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
        return out.toByteArray();
    }

    static byte[] alone() {
        return png(Renderer.render(SCENE, SETTINGS));
    }

    @Override
    public void close() {
        stopServer.set(true);
        stopWorkers.set(true);
        server.close();
    }

    /** Whether a server could listen at the port of this machine. */
    static boolean isFree(int port) {
        try {
            new java.net.ServerSocket(port, 1, java.net.InetAddress.getLoopbackAddress()).close();
            return true;
        } catch (IOException e) {
            return false;
        }
    }
}
