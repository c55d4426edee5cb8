package enlightenment.physical;

import static enlightenment.physical.PhysicalScenes.at;
import static enlightenment.physical.PhysicalScenes.matte;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.camera.Camera;
import enlightenment.geometry.Sphere;
import enlightenment.math.Vec3;
import enlightenment.render.RenderProgress;
import enlightenment.render.Renderer;
import enlightenment.scene.BuiltInMethod;
import enlightenment.scene.RenderSettings;
import enlightenment.scene.Scene;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

/** Pictures of a few pixels, as previews and crops are, have all that large ones have. */
class TinyPicturesTest {
    @ParameterizedTest
    @EnumSource(BuiltInMethod.class)
    void aSphereInAWhiteFurnaceIsAsBrightAsItsReflectance(BuiltInMethod method) {
        for (int[] size : new int[][] {{1, 1}, {2, 1}, {1, 2}, {1, 4}, {3, 1}, {4, 1}}) {
            Scene scene = PhysicalScenes.view(size[0], size[1])
                    .camera(new Camera.Perspective(at(0, 0, -3), at(0, 0, 0), Vec3.Y, 8))
                    .shading(PhysicalScenes.shading(1))
                    .object(new Sphere(at(0, 0, 0), 1, 0), matte(0.5, 0.5, 0.5))
                    .build();
            RenderSettings settings =
                    RenderSettings.of(scene).withMethod(method).withAntialias(16);
            assertEquals(0.5, Rendered.mean(scene, settings), noise(method), size[0] + " x " + size[1]);
        }
    }

    /** A screen shows nothing that is off by more than white is from black, however little is known of a pixel. */
    @ParameterizedTest
    @EnumSource(BuiltInMethod.class)
    void noneIsToldToErrByMoreThanAScreenCan(BuiltInMethod method) {
        for (int[] size : new int[][] {{1, 1}, {2, 1}, {3, 1}, {2, 2}}) {
            for (int samples : new int[] {1, 2, 4}) {
                Scene scene = PhysicalScenes.view(size[0], size[1])
                        .shading(PhysicalScenes.shading(1))
                        .object(new Sphere(at(0, 0, 0), 1, 0), matte(0.5, 0.5, 0.5))
                        .build();
                RenderSettings settings = RenderSettings.of(scene)
                        .withMethod(method)
                        .withBudget(RenderSettings.Budget.NONE.withSamples(samples));
                double high = Renderer.render(scene, settings, RenderProgress.NONE, () -> false)
                        .report()
                        .sampling()
                        .errorHigh();
                assertTrue(high <= 1, high + " of " + size[0] + " x " + size[1] + " pixels, " + samples + " samples");
            }
        }
    }

    /** The two that follow camera rays alone have none here. */
    private static double noise(BuiltInMethod method) {
        return switch (method) {
            case RAYTRACE, CLUSTER -> 1e-6;
            case BIDIRECTIONAL, BIDIRECTIONAL_CLUSTER, METROPOLIS -> 0.15;
            case LIGHT -> 1;
        };
    }
}
