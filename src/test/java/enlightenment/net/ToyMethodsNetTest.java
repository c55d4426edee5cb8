package enlightenment.net;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.render.RenderResult;
import enlightenment.render.Renderer;
import enlightenment.scene.Method;
import enlightenment.scene.RenderSettings;
import enlightenment.scene.Scene;
import enlightenment.toy.AmbientOcclusion;
import enlightenment.toy.EyeVisibility;
import enlightenment.toy.HalfAndHalf;
import enlightenment.toy.ToyScene;
import java.io.IOException;
import java.nio.file.Path;
import java.util.function.IntFunction;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/**
 * Methods that only the tests have, one of either kind and one of both, make the same bytes on many machines, and where they were
 * interrupted.
 */
class ToyMethodsNetTest {
    private static final Scene SCENE = ToyScene.scene();

    @TempDir
    Path folder;

    private static RenderSettings settings(String method) {
        return RenderSettings.of(SCENE)
                .withThreads(1)
                .withMethod(Method.named(method))
                .withCrop(new RenderSettings.Crop(9, 3, 25, 20))
                .withBudget(RenderSettings.Budget.NONE.withSamples(150));
    }

    @ParameterizedTest
    @ValueSource(strings = {AmbientOcclusion.WORD, EyeVisibility.WORD, HalfAndHalf.WORD})
    void serverAndWorkersMakeThePictureOfOneProcess(String method) throws Exception {
        RenderSettings settings = settings(method);
        try (Farm farm = new Farm(SCENE, settings, Farm.options()).begin()) {
            farm.join(Farm.worker(2));
            farm.join(Farm.worker(1));
            assertSame(Renderer.render(SCENE, settings).toArray(), farm.result());
        }
    }

    @ParameterizedTest
    @ValueSource(strings = {AmbientOcclusion.WORD, EyeVisibility.WORD, HalfAndHalf.WORD})
    void aJobGoesOnFromItsCheckpoint(String method) throws IOException {
        RenderSettings settings = settings(method);
        Path checkpoint = folder.resolve("job.ck");
        int all;
        try (EngineJob job = EngineJob.start(SCENE, settings, checkpoint, s -> {}, () -> false)) {
            all = job.missing().length;
            assertTrue(all > 1);
            make(job, 2);
        }
        try (EngineJob job = EngineJob.start(SCENE, settings, checkpoint, s -> {}, () -> false)) {
            assertEquals(all / 2, job.missing().length);
            make(job, 1);
            assertSame(Renderer.render(SCENE, settings).toArray(), job.result());
        }
    }

    /** Makes every n-th unit of those that are missing, the last first. */
    private static void make(EngineJob job, int n) throws IOException {
        IntFunction<byte[]> maker = EngineJob.makers(job.contents()).get();
        int[] missing = job.missing();
        for (int i = (missing.length - 1) / n * n; i >= 0; i -= n) {
            job.put(missing[i], maker.apply(missing[i]), "a");
        }
    }

    private static void assertSame(float[] alone, RenderResult result) {
        assertTrue(result.complete());
        assertArrayEquals(alone, result.image().toArray());
    }
}
