package enlightenment.physical;

import static enlightenment.physical.PhysicalScenes.at;
import static enlightenment.physical.PhysicalScenes.ball;
import static enlightenment.physical.PhysicalScenes.linear;

import enlightenment.camera.Camera;
import enlightenment.color.Rgb;
import enlightenment.light.Emission;
import enlightenment.light.Light;
import enlightenment.material.Glass;
import enlightenment.material.Material;
import enlightenment.material.Medium;
import enlightenment.scene.BuiltInMethod;
import enlightenment.scene.RenderSettings;
import enlightenment.scene.Scene;
import enlightenment.scene.Shading;
import java.util.Optional;
import java.util.OptionalInt;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

/** What is seen through a window begins there: the medium between the eye and the window takes nothing. */
class WindowInMediumTest {
    /** A tiny window, 2 before the eye and 1 before a panel of radiance 1. */
    private static Scene.Builder view() {
        Light panel = new Light.Rectangle(
                at(-5, -5, 0), at(-5, 5, 0), at(5, 5, 0), at(5, -5, 0), Rgb.WHITE, true, Emission.RADIANCE_1);
        return PhysicalScenes.view(4, 4)
                .camera(new Camera.Window(
                        at(0, 0, -3),
                        at(-1e-5, -1e-5, -1),
                        at(-1e-5, 1e-5, -1),
                        at(1e-5, 1e-5, -1),
                        at(1e-5, -1e-5, -1),
                        0))
                .light(panel);
    }

    private static void assertShown(Scene scene, BuiltInMethod method, double radiance) {
        RenderSettings settings = RenderSettings.of(scene).withMethod(method).withAntialias(4);
        new ClosedForms.Known(method.word(), scene, new double[] {radiance, radiance, radiance}).assertShown(settings);
    }

    @ParameterizedTest
    @EnumSource(BuiltInMethod.class)
    void aMediumThatFillsTheSceneTakesLightFromTheWindowOn(BuiltInMethod method) {
        Medium medium = Medium.Coefficients.of(Rgb.BLACK, Rgb.gray(1));
        Scene scene = view().shading(new Shading.Physical(
                        OptionalInt.empty(), new Shading.Background.Constant(Rgb.BLACK), Optional.of(medium)))
                .build();
        assertShown(scene, method, Math.exp(-1));
    }

    @ParameterizedTest
    @EnumSource(BuiltInMethod.class)
    void soDoesASolidThatEyeAndWindowAreIn(BuiltInMethod method) {
        Material dark = Glass.of(linear(1, 1, 1), 1).withAbsorption(Rgb.gray(1));
        assertShown(view().object(ball(0, 0, -1.5, 10), dark).build(), method, Math.exp(-1));
    }
}
