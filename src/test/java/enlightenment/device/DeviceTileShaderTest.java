package enlightenment.device;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.classic.shading.ClassicShader;
import enlightenment.film.FilmTile;
import enlightenment.primitive.Ray;
import enlightenment.render.TestScenes;
import enlightenment.sampling.SobolSampler;
import enlightenment.scene.BuiltInMethod;
import enlightenment.scene.RenderSettings;
import enlightenment.scene.Scene;
import enlightenment.world.CompiledScene;
import enlightenment.world.SceneCompiler;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.CancellationException;
import org.junit.jupiter.api.Test;

/** With devices that are made up: what they do not do, the processor does, and the picture is the same. */
class DeviceTileShaderTest {
    private final Scene scene = TestScenes.whiteFireAndIce().size(60, 40).build();
    private final RenderSettings settings =
            RenderSettings.of(scene).toBuilder().antialias(7).build();
    private final CompiledScene compiled = SceneCompiler.compile(scene, settings);
    private final List<String> failures = new ArrayList<>();
    private final ShadedSamples shaded = new ShadedSamples();

    private DeviceTileShader with(DeviceKernel kernel) {
        return new DeviceTileShader(
                compiled, settings, TilePair.counters(compiled), kernel, shaded, e -> failures.add(e.getMessage()));
    }

    /** Shades as the processor does, but for every n-th sample, which it spoils and leaves to the host; fails after some batches. */
    private final class MadeUp implements DeviceKernel {
        private final int every;
        private final int batches;
        private int done;
        private final ClassicShader shader = ClassicShader.ofColors(
                compiled, BuiltInMethod.RayTraceSettings.of(settings).shadowSamples(), TilePair.counters(compiled));

        MadeUp(int every, int batches) {
            this.every = every;
            this.batches = batches;
        }

        @Override
        public void shade(Batch batch, double[] rgb, int[] states, int[] counts) {
            if (done++ == batches) {
                throw new DeviceFailure("the cable is out");
            }
            SobolSampler sampler = new SobolSampler();
            Ray ray = new Ray();
            double[] color = new double[3];
            shader.beginTile(0, 0, 1, 1);
            int pixel = 0;
            for (int i = batch.begin(); i < batch.end(); i++) {
                while (batch.start()[pixel + 1] <= i) {
                    pixel++;
                }
                int x = batch.x() + pixel % batch.width();
                int y = batch.y() + pixel / batch.width();
                sampler.pixel(batch.seed(), x, y);
                sampler.sample(batch.first()[pixel] + i - batch.start()[pixel]);
                compiled.camera.ray(
                        (x + sampler.filmX()) / settings.width(),
                        (y + sampler.filmY()) / settings.height(),
                        sampler,
                        ray);
                shader.shade(ray, sampler, color);
                boolean isLeft = i % every == 0;
                states[i - batch.begin()] = isLeft ? 1 : 0;
                for (int c = 0; c < 3; c++) {
                    rgb[3 * (i - batch.begin()) + c] = isLeft ? Double.NaN : color[c];
                }
            }
        }

        @Override
        public void close() {}
    }

    @Test
    void whatTheDeviceLeavesIsShadedHere() {
        DeviceTileShader shader = with(new MadeUp(3, Integer.MAX_VALUE));
        assertEquals(
                0,
                TilePair.differences(
                        TilePair.onProcessor(compiled, settings), TilePair.by(shader, compiled, settings)));
        int samples = 60 * 40 * 49;
        assertEquals((samples + 2) / 3, shaded.host());
        assertEquals(samples, shaded.host() + shaded.device());
        assertEquals(List.of(), failures);
    }

    @Test
    void aDeviceThatFailsCostsNoPicture() {
        // There are two batches: the device fails at the second one.
        DeviceTileShader shader = with(new MadeUp(Integer.MAX_VALUE, 1));
        FilmTile first = TilePair.by(shader, compiled, settings);
        assertEquals(0, TilePair.differences(TilePair.onProcessor(compiled, settings), first));
        assertEquals(List.of("the cable is out"), failures);
        assertTrue(shaded.device() > 0 && shaded.host() > 0);
        FilmTile second = TilePair.by(shader, compiled, settings);
        assertEquals(0, TilePair.differences(first, second));
        assertEquals(1, failures.size(), "it is not asked again");
    }

    @Test
    void aRenderThatIsCancelledAsksNoDevice() {
        DeviceTileShader shader = with(new MadeUp(3, 0));
        shader.stopWhen(() -> true);
        assertThrows(CancellationException.class, () -> TilePair.by(shader, compiled, settings));
        assertEquals(List.of(), failures);
    }
}
