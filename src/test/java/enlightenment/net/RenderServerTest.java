package enlightenment.net;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.checkpoint.Checkpoint;
import enlightenment.engine.UnitAssembly;
import enlightenment.image.Image;
import enlightenment.image.ImageFiles;
import enlightenment.job.Build;
import enlightenment.job.RenderIdentity;
import enlightenment.job.SceneDocument;
import enlightenment.net.worker.MachineIdentity;
import enlightenment.render.RenderProgress;
import enlightenment.render.RenderRequest;
import enlightenment.render.RenderResult;
import enlightenment.render.Renderer;
import enlightenment.report.RenderReport;
import enlightenment.scene.Method;
import enlightenment.scene.RenderSettings;
import enlightenment.scene.Scene;
import enlightenment.scene.json.SceneReader;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

@Timeout(600)
class RenderServerTest {
    private static final byte[] ALONE = Farm.alone();

    @TempDir
    Path folder;

    @ParameterizedTest
    @CsvSource({"0,0", "1,1", "2,1", "5,2", "3,4"})
    void anyNumberOfWorkersMakesTheBytesOfOneProcess(int workers, int threads) throws Exception {
        ServerOptions.Builder options = Farm.options().awaitWorkers(workers, workers == 0 ? 0.2 : Farm.TIMEOUT_SECONDS);
        try (Farm farm = new Farm(options).begin()) {
            for (int i = 0; i < workers; i++) {
                farm.join(Farm.worker(threads));
            }
            RenderResult result = farm.result();
            assertTrue(result.complete());
            assertArrayEquals(ALONE, Farm.png(result.image()));
            for (CompletableFuture<RenderWorker.Outcome> worker : farm.workers) {
                RenderWorker.Outcome outcome = worker.get(Farm.TIMEOUT_SECONDS, TimeUnit.SECONDS);
                assertEquals("the picture is done", outcome.reason());
                assertTrue(outcome.isDone());
            }
        }
    }

    @Test
    void theServersOwnThreadsAreAWorkerAmongOthers() throws Exception {
        try (Farm farm = new Farm(Farm.options().localThreads(2).awaitWorkers(1, Farm.TIMEOUT_SECONDS)).begin()) {
            farm.join(Farm.worker(1));
            assertArrayEquals(ALONE, Farm.png(farm.result().image()));
        }
    }

    @Test
    void methodClusterCropAndReportAreThoseOfOneProcess() throws Exception {
        RenderSettings settings =
                Farm.SETTINGS.withMethod(Method.CLUSTER).withCrop(new RenderSettings.Crop(9, 3, 50, 30));
        try (Farm farm = new Farm(Farm.SCENE, settings, Farm.options()).begin()) {
            farm.join(Farm.worker(2));
            farm.join(Farm.worker(1));
            RenderResult result = farm.result();
            RenderReport alone = Renderer.render(
                            Farm.SCENE, settings, enlightenment.render.RenderProgress.NONE, () -> false)
                    .report();
            assertArrayEquals(
                    Renderer.render(Farm.SCENE, settings).toArray(),
                    result.image().toArray());
            assertEquals(alone.raysByKind(), result.report().raysByKind());
            assertEquals(alone.sampling(), result.report().sampling());
        }
    }

    /** One file, whoever writes it: what one process has done a server does not do again, and the other way round. */
    @Test
    void aServerGoesOnFromTheCheckpointOfOneProcessAndThatFromTheServers() throws Exception {
        RenderSettings settings = Farm.SETTINGS.withBudget(RenderSettings.Budget.NONE.withSamples(4));
        RenderResult alone = Renderer.render(RenderRequest.of(Farm.SCENE, settings));
        Path file = folder.resolve("checkpoint");
        RenderIdentity render = RenderIdentity.of(SceneDocument.of(Farm.SCENE).hash(), settings, Build.number());
        try (Checkpoint checkpoint = Checkpoint.open(file, render, false)) {
            RenderResult part = Renderer.render(RenderRequest.of(Farm.SCENE, settings)
                    .withArchives(List.of(checkpoint))
                    .withCancelled(() -> checkpoint.results() >= 3));
            assertFalse(part.complete());
        }
        // Everything is made twice: what one process has made must be what workers make, to the byte.
        ServerOptions.Builder options =
                Farm.options().checkpoint(file).auditRate(1).awaitWorkers(1, Farm.TIMEOUT_SECONDS);
        try (Farm farm = new Farm(Farm.SCENE, settings, options).begin()) {
            farm.join(Farm.worker(2));
            assertArrayEquals(alone.image().toArray(), farm.result().image().toArray());
            assertTrue(farm.logHas("tiles are done already"));
            assertFalse(farm.logHas("expelled"));
        }
        try (Checkpoint checkpoint = Checkpoint.open(file, render, true)) {
            int before = checkpoint.results();
            RenderResult again =
                    Renderer.render(RenderRequest.of(Farm.SCENE, settings).withArchives(List.of(checkpoint)));
            assertArrayEquals(alone.image().toArray(), again.image().toArray());
            assertEquals(before, checkpoint.results());
        }
    }

    /** Workers come to the render that follows, whose picture is that of one process. */
    @ParameterizedTest
    @ValueSource(booleans = {false, true})
    void aPictureThatIsNotAsExactAsAskedIsRenderedAgainWithTheWorkers(boolean isRestarted) throws Exception {
        RenderSettings settings = Farm.SETTINGS.withBudget(RenderSettings.Budget.NONE.withError(0.01));
        RenderResult alone = Renderer.render(RenderRequest.of(Farm.SCENE, settings));
        assertTrue(alone.report().sampling().rounds() > 1);
        Path checkpoint = folder.resolve("checkpoint");
        ServerOptions.Builder options =
                Farm.options().awaitWorkers(1, Farm.TIMEOUT_SECONDS).checkpoint(checkpoint);
        if (isRestarted) {
            options.scratch(new RenderRequest.ScratchFolder(folder, 0));
        }
        for (int run = 0; run < (isRestarted ? 2 : 1); run++) {
            try (Farm farm = new Farm(Farm.SCENE, settings, options).begin()) {
                CompletableFuture<RenderWorker.Outcome> worker = farm.join(Farm.worker(2));
                RenderResult result = farm.result();
                assertTrue(result.report().isErrorMet());
                assertArrayEquals(alone.image().toArray(), result.image().toArray());
                assertEquals(alone.report().sampling(), result.report().sampling());
                assertTrue(farm.logHas("once more with"));
                if (run == 0) {
                    assertEquals(
                            "the picture is done",
                            worker.get(Farm.TIMEOUT_SECONDS, TimeUnit.SECONDS).reason());
                }
                try (Stream<Path> files = Files.list(folder)) {
                    assertEquals(List.of(checkpoint), files.toList(), "one file for all rounds");
                }
            }
        }
    }

    @ParameterizedTest
    @ValueSource(strings = {"png", "jpg"})
    void imagesTravelToWorkersByTheirContent(String kind) throws Exception {
        Image picture = Renderer.render(Farm.SCENE, Farm.SETTINGS);
        Path image = folder.resolve("photo." + kind);
        if (kind.equals("png")) {
            ImageFiles.writePng(picture, image);
        } else {
            writeJpeg(image);
        }
        Scene scene = SceneReader.readString(
                """
                { "image": { "width": 40, "height": 30 },
                  "camera": { "type": "perspective", "eye": [0, 0, -5], "lookAt": [0, 0, 0], "up": [0, 1, 0],
                              "fieldOfView": 40 },
                  "textures": { "photo": { "file": "photo.KIND" } },
                  "lights": [ { "type": "sphere", "center": [2, 3, -4], "radius": 0.5, "color": "#ffffff" } ],
                  "objects": [ { "type": "sphere", "center": [0, 0, 0], "radius": 1.5,
                                 "material": { "type": "matte", "color": { "texture": "photo" } } } ] }
                """
                        .replace("KIND", kind),
                folder,
                "");
        RenderSettings settings = RenderSettings.of(scene).withThreads(1);
        Image alone = Renderer.render(scene, settings);
        try (Farm farm = new Farm(scene, settings, Farm.options()).begin()) {
            Files.delete(image);
            farm.join(Farm.worker(2));
            assertArrayEquals(alone.toArray(), farm.result().image().toArray());
        }
    }

    private static void writeJpeg(Path file) throws IOException {
        java.awt.image.BufferedImage image =
                new java.awt.image.BufferedImage(64, 32, java.awt.image.BufferedImage.TYPE_INT_RGB);
        for (int i = 0; i < 64 * 32; i++) {
            image.setRGB(i % 64, i / 64, i * 0x010305);
        }
        javax.imageio.ImageIO.write(image, "jpeg", file.toFile());
    }

    @Test
    void anInterruptEndsTheServerWithWhatThereIs() throws Exception {
        int port;
        try (RenderServer server = RenderServer.start(
                Farm.SCENE, Farm.SETTINGS, Farm.options().localThreads(1).build(), () -> false)) {
            port = server.port();
            Thread.currentThread().interrupt();
            assertFalse(server.await(RenderProgress.NONE, () -> false).complete());
            assertTrue(Thread.interrupted(), "the interrupt stays set");
        }
        // The thread that listened there may need a moment to let go of the place.
        Farm.until(() -> Farm.isFree(port), "the place is free again");
    }

    @Test
    void aWorkerThatComesLateGetsItsShare() throws Exception {
        try (Farm farm = new Farm(Farm.options()).begin()) {
            UnitAssembly film = farm.server.round().job().film();
            // After a few tiles the first worker makes no other until the second has made a dozen.
            farm.join(Farm.worker(1).tamper((tile, bytes) -> {
                Farm.until(() -> film.done() < 4 || film.done() > 16, "the second worker has done its share");
                return bytes;
            }));
            Farm.until(() -> film.done() > 3, "the first worker has begun");
            CompletableFuture<RenderWorker.Outcome> late = farm.join(Farm.worker(1));
            assertArrayEquals(ALONE, Farm.png(farm.result().image()));
            assertTrue(late.get().tiles() > 10, "what one worker had was not shared");
        }
    }

    @Test
    void theServerBeginsWhenTheWorkersAreThere() throws Exception {
        try (Farm farm = new Farm(Farm.options().awaitWorkers(2, 1e6)).begin()) {
            farm.join(Farm.worker(1));
            Farm.until(() -> farm.logHas("joined"), "the worker is there");
            assertEquals(0, farm.server.round().snapshot().workers().size(), "it waits for the other one");
            farm.join(Farm.worker(1));
            assertArrayEquals(ALONE, Farm.png(farm.result().image()));
        }
    }

    @Test
    void theServerDoesNotWaitForEver() throws Exception {
        try (Farm farm = new Farm(Farm.options().awaitWorkers(2, 0.3)).begin()) {
            farm.join(Farm.worker(1));
            assertArrayEquals(ALONE, Farm.png(farm.result().image()));
        }
    }

    @Test
    void whatIsDoneWhenTheServerIsStoppedIsThePictureSoFar() throws Exception {
        Path checkpoint = folder.resolve("checkpoint");
        CountDownLatch isStopped = new CountDownLatch(1);
        int done;
        try (Farm farm = new Farm(Farm.options().checkpoint(checkpoint)).begin()) {
            farm.join(Farm.stuckAfter(11, isStopped));
            Farm.until(() -> farm.server.round().job().film().done() > 10, "some tiles are done");
            RenderResult result = farm.stop();
            isStopped.countDown();
            done = farm.server.round().job().film().done();
            assertFalse(result.complete());
            assertTrue(result.report().pixels() >= 64 * 5);
        }
        try (Farm farm = new Farm(Farm.options().checkpoint(checkpoint).awaitWorkers(1, Farm.TIMEOUT_SECONDS))) {
            assertEquals(done, farm.server.round().job().film().done());
            farm.begin().join(Farm.worker(2));
            assertArrayEquals(ALONE, Farm.png(farm.result().image()));
            assertTrue(farm.workers
                            .get(0)
                            .get(Farm.TIMEOUT_SECONDS, TimeUnit.SECONDS)
                            .tiles()
                    < farm.server.round().job().tiles());
        }
        try (Farm farm = new Farm(Farm.options().checkpoint(checkpoint)).begin()) {
            assertArrayEquals(ALONE, Farm.png(farm.result().image()));
        }
    }

    @Test
    void workersGoOnWithAServerThatComesBack() throws Exception {
        Path checkpoint = folder.resolve("checkpoint");
        int port;
        CompletableFuture<RenderWorker.Outcome> worker;
        try (Farm farm = new Farm(Farm.options().checkpoint(checkpoint)).begin()) {
            port = farm.server.port();
            worker = farm.join(Farm.slow(10), port, () -> false);
            Farm.until(() -> farm.server.round().job().film().done() > 5, "some tiles are done");
            farm.stop();
        }
        ServerOptions.Builder again =
                Farm.options().address("127.0.0.1", port).checkpoint(checkpoint).awaitWorkers(1, Farm.TIMEOUT_SECONDS);
        try (Farm farm = new Farm(again).begin()) {
            assertArrayEquals(ALONE, Farm.png(farm.result().image()));
            assertTrue(worker.get(Farm.TIMEOUT_SECONDS, TimeUnit.SECONDS).isDone());
        }
    }

    @Test
    void aWorkersNameIsThatOfItsMachineWithTheNumberOfItsProcess() throws Exception {
        try (Farm farm = new Farm(Farm.options()).begin()) {
            farm.join(Farm.worker(1));
            assertTrue(farm.result().complete());
            String name = MachineIdentity.name() + "#" + ProcessHandle.current().pid();
            assertTrue(farm.logHas(name + " (127.0.0.1) joined"), farm.log.toString());
            assertEquals(MachineIdentity.name(), MachineIdentity.machineOf(name));
        }
    }

    @Test
    void sharesAreFoundByNameAndByAddress() {
        ServerOptions options = ServerOptions.builder()
                .shares(Map.of("fast", 4.0, "10.0.0.7", 2.0))
                .build();
        assertEquals(4, options.weight("fast", "10.0.0.7"));
        assertEquals(4, options.weight("fast#4711", "10.0.0.7"), "every worker of the machine");
        assertEquals(1, options.weight("faster#4711", "10.0.0.8"));
        assertEquals(2, options.weight("other", "10.0.0.7"));
        assertEquals(1, options.weight("other", "10.0.0.8"));
    }
}
