package enlightenment.physical;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;

import enlightenment.camera.Camera;
import enlightenment.color.Rgb;
import enlightenment.geometry.Sphere;
import enlightenment.image.Image;
import enlightenment.light.Emission;
import enlightenment.light.Light;
import enlightenment.material.Material;
import enlightenment.material.Medium;
import enlightenment.math.ExactPoint;
import enlightenment.math.Vec3;
import enlightenment.render.Renderer;
import enlightenment.render.TestScenes;
import enlightenment.scene.BuiltInMethod;
import enlightenment.scene.RenderSettings;
import enlightenment.scene.RenderSettings.Crop;
import enlightenment.scene.Scene;
import enlightenment.scene.Shading;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalInt;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.EnumSource;

/** Methods that follow light in media make the same picture of it, and what must not matter changes no bit. */
class MediaMethodsTest {
    private static final Map<String, Scene> SCENES = PartnerScenes.all();

    /** A ball of wax in fog, 2^k times as large. */
    private static Scene foggy(int k) {
        double s = Math.scalb(1.0, k);
        Medium fog = new Medium.Coefficients(Rgb.gray(0.2 / s), new Rgb(0.01 / s, 0.02 / s, 0), 0.5);
        Medium wax =
                new Medium.Coefficients(new Rgb(6 / s, 5 / s, 3 / s), new Rgb(0.0625 / s, 0.25 / s, 0.5 / s), 0.25);
        return Scene.builder()
                .size(24, 16)
                .camera(new Camera.Perspective(ExactPoint.of(0, s, -3 * s), ExactPoint.of(0, 0.5 * s, 0), Vec3.Y, 45))
                .shading(new Shading.Physical(
                        OptionalInt.empty(), new Shading.Background.Constant(Rgb.gray(0.5)), Optional.of(fog)))
                .object(Sphere.of(ExactPoint.of(-0.6 * s, 0.5 * s, 0), 0.5 * s), Material.Scattering.of(wax))
                .object(
                        Sphere.of(ExactPoint.of(0.6 * s, 0.5 * s, 0), 0.5 * s),
                        new Material.Scattering(wax, 1.4, 0.25, 0))
                .object(
                        TestScenes.rectangle(-2 * s, 0, -2 * s, -2 * s, 0, 2 * s, 2 * s, 0, 2 * s, 2 * s, 0, -2 * s),
                        PhysicalScenes.WHITE)
                .light(new Light.Sphere(
                        ExactPoint.of(0.5 * s, 2 * s, -s), 0.25 * s, Rgb.WHITE, Emission.radiance(Rgb.gray(9))))
                .build();
    }

    private static RenderSettings settings(Scene scene, BuiltInMethod method) {
        return RenderSettings.of(scene).withMethod(method).withAntialias(2).withThreads(1);
    }

    @ParameterizedTest
    @CsvSource({
        "CLUSTER, ball of wax",
        "CLUSTER, fog with a mirror and glass",
        "METROPOLIS, fog",
        "METROPOLIS, milk in glass"
    })
    void othersMakeThePictureOfSinglePaths(BuiltInMethod method, String name) {
        Scene scene = SCENES.get(name);
        List<Image> traced =
                Rendered.seeds(scene, settings(scene, BuiltInMethod.RAYTRACE).withAntialias(5), 100, 12);
        List<Image> others = Rendered.seeds(scene, settings(scene, method).withAntialias(5), 1, 12);
        Rendered.assertPartsAgree(traced, others, 48);
    }

    @ParameterizedTest
    @EnumSource(
            value = BuiltInMethod.class,
            names = {"RAYTRACE", "CLUSTER", "METROPOLIS", "BIDIRECTIONAL"})
    void threadsTilesAndScaleChangeNoBitNorDoesACrop(BuiltInMethod method) {
        Scene scene = foggy(0);
        RenderSettings settings = settings(scene, method);
        Image whole = Renderer.render(scene, settings);
        float[] expected = whole.toArray();
        assertArrayEquals(
                expected,
                Renderer.render(scene, settings.withThreads(3).withTileSize(7)).toArray());
        for (int k : new int[] {5, -300}) {
            Scene scaled = foggy(k);
            assertArrayEquals(
                    expected, Renderer.render(scaled, settings(scaled, method)).toArray(), "2^" + k);
        }
        Crop crop = new Crop(9, 5, 10, 8);
        Image part = Renderer.render(scene, settings.withCrop(crop));
        for (int i = 0; i < crop.width() * crop.height() * 3; i++) {
            int x = i / 3 % crop.width();
            int y = i / 3 / crop.width();
            assertEquals(whole.component(crop.x() + x, crop.y() + y, i % 3), part.component(x, y, i % 3));
        }
    }
}
