package enlightenment.physical;

import static enlightenment.physical.PhysicalScenes.at;
import static enlightenment.physical.PhysicalScenes.ball;
import static enlightenment.physical.PhysicalScenes.linear;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.color.Rgb;
import enlightenment.geometry.Shape;
import enlightenment.image.Image;
import enlightenment.light.Emission;
import enlightenment.light.Light;
import enlightenment.material.Glass;
import enlightenment.material.Material;
import enlightenment.math.ExactPoint;
import enlightenment.render.RenderProgress;
import enlightenment.render.RenderResult;
import enlightenment.render.Renderer;
import enlightenment.scene.BuiltInMethod;
import enlightenment.scene.RenderSettings;
import enlightenment.scene.Scene;
import enlightenment.scene.SceneException;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

/** At the end of the range of numbers: light that is refused by its place, and light that is rendered. */
class BrightestLightsTest {
    private static final Shape BALL = ball(0, 0.5, 0, 0.5);

    private static RenderResult render(Light light, Material material, BuiltInMethod method) {
        Scene scene =
                PhysicalScenes.view(8, 8).object(BALL, material).light(light).build();
        RenderSettings settings = RenderSettings.of(scene).withMethod(method).withAntialias(2);
        return Renderer.render(scene, settings, RenderProgress.NONE, () -> false);
    }

    private static void assertRefused(String key, Light light) {
        SceneException e =
                assertThrows(SceneException.class, () -> render(light, PhysicalScenes.WHITE, BuiltInMethod.RAYTRACE));
        assertEquals(1, e.problems().size(), e.getMessage());
        assertEquals("/" + key, e.problems().get(0).pointer());
        assertTrue(e.getMessage().contains("of this size"), e.getMessage());
    }

    @Test
    void allLightsThatAreTooMuchAreToldAtOnce() {
        Emission much = Emission.power(Rgb.gray(1e308));
        Scene scene = PhysicalScenes.view(8, 8)
                .light(new Light.Sphere(at(0, 2, 0), 1, Rgb.WHITE, much))
                .light(new Light.Sphere(at(0, 3, 0), 1, Rgb.WHITE, Emission.power(Rgb.gray(10))))
                .light(new Light.Point(at(0, 4, 0), Rgb.WHITE, Emission.intensity(Rgb.gray(1e308))))
                .light(new Light.Sphere(at(0, 5, 0), 1e-60, Rgb.WHITE, much))
                .build();
        SceneException e = assertThrows(SceneException.class, () -> Renderer.render(scene));
        assertEquals(
                List.of("/lights/0/power", "/lights/2/intensity", "/lights/3/power"),
                e.problems().stream().map(SceneException.Problem::pointer).toList());
    }

    @Test
    void powerThatATinyLightCannotHaveIsRefusedAtItsPlace() {
        Emission ten = Emission.power(Rgb.gray(10));
        assertRefused("lights/0/power", new Light.Sphere(at(0, 2, 0), 1e-160, Rgb.WHITE, ten));
        assertRefused("lights/0/power", new Light.Sphere(at(0, 2, 0), 1, Rgb.WHITE, Emission.power(Rgb.gray(1e308))));
        assertRefused(
                "lights/0/intensity", new Light.Point(at(0, 2, 0), Rgb.WHITE, Emission.intensity(Rgb.gray(1e308))));
    }

    /** Ultraviolet is a key of its own, and the number that is wrong may stand there alone. */
    @Test
    void ultravioletThatIsTooMuchIsRefusedAtItsOwnPlace() {
        assertRefused(
                "lights/0/ultraviolet",
                new Light.Sphere(
                        at(0, 2, 0),
                        1e-140,
                        Rgb.WHITE,
                        Emission.power(Rgb.gray(1e-300)).withUltraviolet(10)));
        assertRefused(
                "lights/0/ultraviolet",
                new Light.Point(
                        at(0, 2, 0), Rgb.WHITE, Emission.intensity(Rgb.gray(1)).withUltraviolet(1e308)));
    }

    /** The corners lie 1e-44 apart and 3 from the eye, which are the same doubles: there is no area that could give the power. */
    @Test
    void powerOfARectangleWithoutAreaInDoublesIsRefusedAtItsPlace() {
        Emission ten = Emission.power(Rgb.gray(10));
        ExactPoint a = ExactPoint.of("0", "2", "0");
        ExactPoint b = ExactPoint.of("0", "2", "1e-44");
        ExactPoint c = ExactPoint.of("1e-44", "2", "1e-44");
        ExactPoint d = ExactPoint.of("1e-44", "2", "0");
        assertRefused("lights/0/power", new Light.Rectangle(a, b, c, d, Rgb.WHITE, false, ten));
    }

    @ParameterizedTest
    @EnumSource(BuiltInMethod.class)
    void theBrightestLightThatIsAllowedLosesNoSample(BuiltInMethod method) {
        Light light = new Light.Sphere(at(0, 2, 0), 0.3, Rgb.WHITE, Emission.radiance(Rgb.gray(1e100)));
        assertEquals(0, render(light, PhysicalScenes.WHITE, method).report().lostSamples());
    }

    /** Absorption over the largest length of a scene is beyond all numbers: nothing comes through, as with much less of it. */
    @Test
    void glassThatAbsorbsWithoutBoundsIsLikeGlassThatAbsorbsMuch() {
        Light light = PhysicalScenes.sphereLight(0, 2, -1, 0.3, 10);
        Image boundless =
                render(light, glass(Double.MAX_VALUE), BuiltInMethod.RAYTRACE).image();
        Image much = render(light, glass(1e30), BuiltInMethod.RAYTRACE).image();
        for (int k = 0; k < 64; k++) {
            assertEquals(much.component(k % 8, k / 8, 1), boundless.component(k % 8, k / 8, 1), 0.0);
        }
    }

    private static Material glass(double absorption) {
        return Glass.of(linear(1, 1, 1), 1.5).withAbsorption(Rgb.gray(absorption));
    }
}
