package enlightenment.net;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.net.parts.RenderParts;
import enlightenment.physical.InvarianceScenes;
import enlightenment.render.RenderProgress;
import enlightenment.render.RenderRequest;
import enlightenment.render.RenderResult;
import enlightenment.render.Renderer;
import enlightenment.render.TestScenes;
import enlightenment.scene.BuiltInMethod;
import enlightenment.scene.Method;
import enlightenment.scene.RenderSettings;
import enlightenment.scene.Scene;
import java.nio.ByteBuffer;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.CountDownLatch;
import java.util.function.IntFunction;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

/** Passes over tiles and batches of paths go wherever tiles do, and make the picture of one process. */
@Timeout(600)
class UnitKindsTest {
    private static final Scene ROOM = TestScenes.whiteFireAndIce().build();
    private static final Scene PHYSICAL_ROOM = InvarianceScenes.byRadiance();
    private static final Scene BLACK_LIGHT = InvarianceScenes.inBlackLight();

    @TempDir
    Path folder;

    enum Kind {
        /** Two tiles of a pixel, in four passes each. */
        PASSES(
                ROOM,
                RenderSettings.of(ROOM)
                        .withSize(64, 48)
                        .withCrop(new RenderSettings.Crop(31, 20, 2, 1))
                        .with(new BuiltInMethod.RayTraceSettings(1))
                        .withBudget(RenderSettings.Budget.NONE.withSamples(90_000)),
                8),

        /** Eight batches, the last not full. */
        BATCHES(
                ROOM,
                RenderSettings.of(ROOM)
                        .withMethod(Method.named("toy"))
                        .withSize(64, 50)
                        .withCrop(new RenderSettings.Crop(3, 1, 50, 49))
                        .withAntialias(12),
                8),

        /** Twelve tiles of linear light, some not full, and four batches of light paths that are added to them. */
        PHYSICAL(
                PHYSICAL_ROOM, RenderSettings.of(PHYSICAL_ROOM).withAntialias(2).withTileSize(9), 16),

        /** Two blocks of chains, of which a part is rendered, in four passes each, and four batches of light paths. */
        CHAINS(
                PHYSICAL_ROOM,
                RenderSettings.of(PHYSICAL_ROOM)
                        .withMethod(Method.METROPOLIS)
                        .withSize(80, 20)
                        .withCrop(new RenderSettings.Crop(50, 3, 30, 9))
                        .withAntialias(3),
                12),

        /** The same in classic shading, without light paths. */
        CLASSIC_CHAINS(
                ROOM,
                RenderSettings.of(ROOM)
                        .withMethod(Method.METROPOLIS)
                        .withSize(80, 20)
                        .withAntialias(3),
                8),

        /** Twelve tiles that show lights alone, and four batches of the paths that make the rest. */
        LIGHT(
                PHYSICAL_ROOM,
                RenderSettings.of(PHYSICAL_ROOM)
                        .withMethod(BuiltInMethod.LIGHT)
                        .withAntialias(2)
                        .withTileSize(9),
                16),

        /** Twelve tiles of paths from both ends, and four batches of those that are connected to the eye itself. */
        BIDIRECTIONAL(
                PHYSICAL_ROOM,
                RenderSettings.of(PHYSICAL_ROOM)
                        .withMethod(BuiltInMethod.BIDIRECTIONAL)
                        .withAntialias(2)
                        .withTileSize(9),
                16),

        /** The same of fluorescent surfaces, whose paths know of ultraviolet. */
        FLUORESCENT(
                BLACK_LIGHT,
                RenderSettings.of(BLACK_LIGHT)
                        .withMethod(BuiltInMethod.BIDIRECTIONAL)
                        .withAntialias(2)
                        .withTileSize(9),
                16);

        final Scene scene;
        final RenderSettings settings;
        final int units;
        final RenderResult alone;

        Kind(Scene scene, RenderSettings settings, int units) {
            this.scene = scene;
            this.settings = settings.withThreads(1);
            this.units = units;
            alone = Renderer.render(RenderRequest.of(scene, settings));
        }

        void check(RenderResult result) {
            assertTrue(result.complete());
            assertArrayEquals(alone.image().toArray(), result.image().toArray());
            assertEquals(alone.report().raysByKind(), result.report().raysByKind());
            assertEquals(alone.report().sampling(), result.report().sampling());
            assertEquals(alone.report().pixels(), result.report().pixels());
        }
    }

    @ParameterizedTest
    @EnumSource
    void partsThatKnowNothingOfEachOtherMakeIt(Kind kind) throws Exception {
        List<Path> files = new ArrayList<>();
        for (int part = 3; part > 0; part--) {
            Path file = folder.resolve(part + ".film");
            RenderProgress progress = (done, total, soFar) -> assertTrue(done <= total);
            assertTrue(RenderParts.render(
                    RenderRequest.of(kind.scene, kind.settings).withProgress(progress),
                    part,
                    3,
                    n -> Map.of("n", "" + n),
                    file));
            files.add(file);
        }
        RenderParts.Merged some = RenderParts.merge(files.subList(0, 2), Optional.empty());
        assertEquals(List.of("part 1/3"), some.missing());
        RenderParts.Merged all = RenderParts.merge(files, Optional.empty());
        assertEquals(List.of(), all.missing());
        kind.check(all.result());
        // No picture is small enough for memory where it can be in a file.
        kind.check(RenderParts.merge(files, Optional.of(new RenderRequest.ScratchFolder(folder, 0)))
                .result());
    }

    @ParameterizedTest
    @EnumSource
    void anotherEngineMakesItFromTheContentsAloneAndGoesOnFromACheckpoint(Kind kind) throws Exception {
        Path checkpoint = folder.resolve("ck");
        IntFunction<byte[]> maker;
        try (EngineJob job = EngineJob.start(kind.scene, kind.settings, checkpoint, text -> {}, () -> false)) {
            maker = EngineJob.makers(job.contents()).get();
            assertEquals(kind.units, job.missing().length);
            for (int unit = 0; unit < kind.units; unit += 2) {
                byte[] bytes = maker.apply(unit);
                assertTrue(bytes.length <= job.longest(unit));
                job.put(unit, bytes, "one");
                job.put(unit, bytes, "another");
            }
            assertThrows(IllegalArgumentException.class, () -> job.put(1, new byte[99], "a liar"));
        }
        try (EngineJob job = EngineJob.start(kind.scene, kind.settings, checkpoint, text -> {}, () -> false)) {
            assertEquals(kind.units / 2, job.missing().length);
            for (int unit : job.missing()) {
                job.put(unit, maker.apply(unit), "one");
            }
            kind.check(job.result());
        }
    }

    @ParameterizedTest
    @EnumSource
    void aServerAndItsWorkersMakeIt(Kind kind) throws Exception {
        ServerOptions.Builder options = Farm.options().localThreads(1);
        try (Farm farm = new Farm(kind.scene, kind.settings, options.awaitWorkers(2, Farm.TIMEOUT_SECONDS)).begin()) {
            farm.join(Farm.worker(1));
            farm.join(Farm.worker(2));
            kind.check(farm.result());
        }
    }

    /** No picture is small enough for memory where it can be in a file. */
    private ServerOptions.Builder inFile() {
        return Farm.options().scratch(new RenderRequest.ScratchFolder(folder, 0));
    }

    @ParameterizedTest
    @EnumSource
    void aServerThatWasStoppedGoesOnFromItsCheckpoint(Kind kind) throws Exception {
        Path checkpoint = folder.resolve("ck");
        // Whichever these are, there is a finished tile, or a share of all pixels, among them.
        int done = kind.units - 1;
        CountDownLatch stop = new CountDownLatch(1);
        try (Farm farm = new Farm(kind.scene, kind.settings, inFile().checkpoint(checkpoint)).begin()) {
            farm.join(Farm.stuckAfter(done, stop));
            Farm.until(() -> farm.server.round().job().film().done() == done, "all units but one are done");
            RenderResult stopped = farm.stop();
            assertFalse(stopped.complete());
            assertTrue(stopped.report().pixels() > 0);
        } finally {
            stop.countDown();
        }
        try (Farm farm = new Farm(
                kind.scene, kind.settings, inFile().checkpoint(checkpoint).awaitWorkers(1, Farm.TIMEOUT_SECONDS))) {
            assertEquals(done, farm.server.round().job().film().done());
            farm.begin().join(Farm.worker(2));
            kind.check(farm.result());
        }
    }

    /** What it said is added up with what others said, and has to be taken out again. */
    @ParameterizedTest
    @EnumSource
    void whatAMachineSaidThatIsFoundOutLeavesNothing(Kind kind) throws Exception {
        ServerOptions.Builder options = inFile().auditRate(1).localThreads(1);
        try (Farm farm = new Farm(kind.scene, kind.settings, options.awaitWorkers(2, Farm.TIMEOUT_SECONDS)).begin()) {
            farm.join(Farm.worker(1).machine("liar").tamper((unit, bytes) -> liesLike(kind, bytes)));
            farm.join(Farm.worker(1).machine("honest"));
            kind.check(farm.result());
            assertTrue(farm.logHas(RawPeer.called("liar", farm) + " expelled"), farm.log.toString());
        }
    }

    /** Bytes with nothing wrong about them but what they say. */
    private static byte[] liesLike(Kind kind, byte[] bytes) {
        byte[] wrong = bytes.clone();
        if (kind == Kind.PASSES) {
            ByteBuffer.wrap(wrong).putDouble(wrong.length - 52, 0.125);
        } else {
            wrong[wrong.length - 1] ^= 1;
        }
        return wrong;
    }
}
