import enlightenment.image.Image;
import enlightenment.image.ImageFiles;
import enlightenment.net.RenderServer;
import enlightenment.net.RenderWorker;
import enlightenment.net.ServerOptions;
import enlightenment.render.RenderProgress;
import enlightenment.render.RenderResult;
import enlightenment.render.Renderer;
import enlightenment.scene.RenderSettings;
import enlightenment.scene.Scene;
import enlightenment.scene.json.SceneReader;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;

/**
 * One picture by a server and two workers, here on one machine; the same picture, bit for bit, as by this process alone.
 *
 * <pre>
 * java -cp enlightenment-0.1.0.jar:jackson-core.jar:jackson-databind.jar:jackson-dataformat-cbor.jar:... \
 *     src/examples/java/ManyMachines.java scenes/fire-and-ice.json picture.png
 * </pre>
 *
 * <p>On real machines a worker is a process of its own, {@code enlightenment worker HOST:PORT}, and both sides have a token
 * ({@code tokenFile}) and TLS ({@code tls}, {@code pin}): a server that listens beyond loopback refuses to start without a token.
 */
public final class ManyMachines {
    private static final int WORKERS = 2;

    private ManyMachines() {}

    public static void main(String[] args) throws Exception {
        Scene scene = SceneReader.read(Path.of(args[0]));
        RenderSettings settings = RenderSettings.of(scene);
        RenderResult result = serve(scene, settings);
        ImageFiles.writePng(result.image(), Path.of(args[1]));
        Image alone = Renderer.render(scene, settings);
        System.out.println(
                "same bits: " + Arrays.equals(alone.toArray(), result.image().toArray()));
    }

    static RenderResult serve(Scene scene, RenderSettings settings) throws Exception {
        ServerOptions options = ServerOptions.builder()
                // Port 0: any that is free.
                .address("127.0.0.1", 0)
                // The server only hands out work, and begins when both workers are there, or after a minute.
                .localThreads(0)
                .awaitWorkers(WORKERS, 60)
                .log(System.err::println)
                .build();
        ExecutorService threads = Executors.newFixedThreadPool(WORKERS);
        try (RenderServer server = RenderServer.start(scene, settings, options, () -> false)) {
            List<Future<RenderWorker.Outcome>> workers = new ArrayList<>();
            for (int i = 0; i < WORKERS; i++) {
                workers.add(threads.submit(() -> RenderWorker.run(
                        "127.0.0.1",
                        server.port(),
                        RenderWorker.Options.builder().threads(1).build(),
                        () -> false)));
            }
            RenderResult result = server.await(RenderProgress.NONE, () -> false);
            for (Future<RenderWorker.Outcome> worker : workers) {
                System.out.println("a worker made " + worker.get().tiles() + " tiles: "
                        + worker.get().reason());
            }
            return result;
        } finally {
            threads.shutdownNow();
        }
    }
}
