package enlightenment.net;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.render.RenderProgress;
import enlightenment.render.RenderResult;
import enlightenment.render.Renderer;
import enlightenment.scene.BuiltInMethod;
import enlightenment.scene.RenderSettings;
import enlightenment.scene.Scene;
import enlightenment.scene.json.SceneReader;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.function.IntFunction;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class EngineJobTest {
    private static final Path SCENE = Path.of(System.getProperty("project.directory"), "scenes", "fire-and-ice.json");

    private static final Scene FIRE_AND_ICE = SceneReader.read(SCENE);
    private static final RenderSettings SETTINGS = RenderSettings.of(FIRE_AND_ICE)
            .withSize(24, 16)
            .withAntialias(1)
            .with(new BuiltInMethod.RayTraceSettings(4))
            .withThreads(1);

    private static final RenderResult ONE = Renderer.render(FIRE_AND_ICE, SETTINGS, RenderProgress.NONE, () -> false);

    @TempDir
    Path folder;

    @Test
    void tilesMadeFromTheContentsAloneMakeThePictureOfOneProcess() throws IOException {
        try (EngineJob job = start(null)) {
            IntFunction<byte[]> maker = EngineJob.makers(job.contents()).get();
            int[] missing = job.missing();
            for (int i = missing.length - 1; i >= 0; i--) {
                byte[] bytes = maker.apply(missing[i]);
                assertEquals(job.longest(missing[i]), bytes.length);
                job.put(missing[i], bytes, "a");
                job.put(missing[i], bytes, "b");
            }
            assertEquals(0, job.missing().length);
            assertSamePicture(job.result());
        }
    }

    @Test
    void aJobGoesOnFromItsCheckpoint() throws IOException {
        Path checkpoint = folder.resolve("job.ck");
        int all;
        try (EngineJob job = start(checkpoint)) {
            all = job.missing().length;
            IntFunction<byte[]> maker = EngineJob.makers(job.contents()).get();
            for (int tile = 0; tile < all; tile += 2) {
                job.put(tile, maker.apply(tile), "a");
            }
        }
        try (EngineJob job = start(checkpoint)) {
            int[] missing = job.missing();
            assertEquals(all / 2, missing.length);
            IntFunction<byte[]> maker = EngineJob.makers(job.contents()).get();
            for (int tile : missing) {
                assertEquals(1, tile % 2);
                job.put(tile, maker.apply(tile), "a");
            }
            assertSamePicture(job.result());
        }
    }

    @Test
    void aDamagedCheckpointCostsOneTileAndNotTheBytes() throws IOException {
        Path checkpoint = folder.resolve("job.ck");
        int all;
        IntFunction<byte[]> maker;
        try (EngineJob job = start(checkpoint)) {
            all = job.missing().length;
            maker = EngineJob.makers(job.contents()).get();
            for (int tile = 0; tile < all; tile++) {
                job.put(tile, maker.apply(tile), "a");
            }
        }
        byte[] whole = Files.readAllBytes(checkpoint);
        // CheckpointJournalTest has every byte.
        // Two headers of 116 bytes each come before the records, and what is said of render and plan, all of it twice.
        int middle = whole.length / 2;
        for (int at : new int[] {120, 241, middle, whole.length - 1}) {
            byte[] damaged = whole.clone();
            damaged[at] ^= 16;
            Files.write(checkpoint, damaged);
            try (EngineJob job = start(checkpoint)) {
                int[] missing = job.missing();
                assertEquals(at < middle ? 0 : 1, missing.length, "byte " + at);
                for (int tile : missing) {
                    job.put(tile, maker.apply(tile), "b");
                }
                assertSamePicture(job.result());
            }
            try (EngineJob job = start(checkpoint)) {
                assertEquals(0, job.missing().length, "what was made again is kept");
            }
        }
    }

    @Test
    void contentsThatChangedOnTheirWayAreRefused() throws IOException {
        try (EngineJob job = start(null)) {
            for (int i = 0; i < 3; i++) {
                List<byte[]> contents = new ArrayList<>(job.contents());
                byte[] changed = contents.get(i).clone();
                changed[changed.length - 1] ^= 1;
                contents.set(i, changed);
                assertThrows(IOException.class, () -> EngineJob.makers(contents));
            }
        }
    }

    @Test
    void aTileThatMakesNoSenseIsRefusedAndStaysMissing() throws IOException {
        try (EngineJob job = start(null)) {
            int before = job.missing().length;
            byte[] bytes = new byte[job.longest(3)];
            IllegalArgumentException e =
                    assertThrows(IllegalArgumentException.class, () -> job.put(3, bytes, "host-7"));
            assertTrue(e.getMessage().startsWith("tile 3 of host-7: "), e.getMessage());
            assertEquals(before, job.missing().length);
        }
    }

    @Test
    void aCheckpointOfWhatIsPlannedByTheClockIsRefused() {
        RenderSettings byTime = SETTINGS.withBudget(RenderSettings.Budget.NONE.withSeconds(1));
        assertThrows(
                IllegalArgumentException.class,
                () -> EngineJob.start(FIRE_AND_ICE, byTime, folder.resolve("t.ck"), s -> {}, () -> false));
    }

    private EngineJob start(Path checkpoint) throws IOException {
        return EngineJob.start(FIRE_AND_ICE, SETTINGS, checkpoint, s -> {}, () -> false);
    }

    private void assertSamePicture(RenderResult result) {
        assertTrue(result.complete());
        assertEquals(ONE.report().lightSamples(), result.report().lightSamples());
        assertArrayEquals(ONE.image().toArray(), result.image().toArray());
    }
}
