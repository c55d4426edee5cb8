package enlightenment.render;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.report.RenderReport;
import enlightenment.scene.Budget;
import enlightenment.scene.BuiltInMethod;
import enlightenment.scene.Method;
import enlightenment.scene.RenderSettings;
import enlightenment.scene.RenderSettings.Crop;
import enlightenment.scene.Scene;
import enlightenment.scene.json.SceneReader;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

/**
 * Light that is left to chance, in the scene of caustics: what the tumbler and the ball do to light that is seen in them lies in a few
 * pixels of the upper half, and none of it on the table in front.
 */
class ChanceOfCropTest {
    private static final Crop WHOLE = new Crop(0, 0, 32, 16);
    private static final Crop TABLE = new Crop(0, 12, 32, 4);
    private static final Crop TUMBLER = new Crop(18, 0, 4, 5);

    private static RenderReport.Sampling render(Method method, Crop crop) throws Exception {
        Scene scene = SceneReader.read(Path.of("scenes/caustics.json"));
        RenderSettings settings = RenderSettings.of(scene)
                .withSize(WHOLE.width(), WHOLE.height())
                .withCrop(crop)
                .withMethod(method)
                .withThreads(2)
                .withBudget(Budget.NONE.withSamples(64));
        return Renderer.render(scene, settings, RenderProgress.NONE, () -> false)
                .report()
                .sampling();
    }

    private static double left(RenderReport.Sampling sampling) {
        return sampling.light().orElseThrow().leftToChance();
    }

    @Test
    void theErrorOfACropIsThatOfLightWithinIt() throws Exception {
        assertEquals(0, left(render(BuiltInMethod.RAYTRACE, TABLE)));
        double inAll = left(render(BuiltInMethod.RAYTRACE, WHOLE));
        double within = left(render(BuiltInMethod.RAYTRACE, TUMBLER));
        // As much as all of its square, which the crop's pixels are a 26th of.
        double most = inAll * Math.sqrt(WHOLE.width() * WHOLE.height() / (double) (TUMBLER.width() * TUMBLER.height()));
        assertTrue(within > 1.5 * inAll && within <= most, within + " of " + inAll);
    }

    /** All of these have the same paths from the eye, and leave the rest to the same pass of caustics. */
    @ParameterizedTest
    @EnumSource(
            value = BuiltInMethod.class,
            names = {"CLUSTER", "METROPOLIS"})
    void methodsWithTheSamePathsTellOfIt(BuiltInMethod method) throws Exception {
        RenderReport.Sampling sampling = render(method, WHOLE);
        assertTrue(left(sampling) > 0);
        assertTrue(sampling.estimatedError() >= left(sampling));
    }
}
