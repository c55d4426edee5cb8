package enlightenment.physical;

import static enlightenment.physical.PhysicalScenes.at;
import static enlightenment.physical.PhysicalScenes.ball;
import static enlightenment.physical.PhysicalScenes.linear;
import static enlightenment.physical.PhysicalScenes.panel;
import static enlightenment.physical.PhysicalScenes.sphereLight;

import enlightenment.color.Rgb;
import enlightenment.geometry.Box;
import enlightenment.light.Emission;
import enlightenment.light.Light;
import enlightenment.material.Glass;
import enlightenment.material.Material;
import enlightenment.material.Medium;
import enlightenment.material.Texture;
import enlightenment.render.TestScenes;
import enlightenment.scene.Scene;
import enlightenment.scene.Shading;
import enlightenment.surroundings.Pictures;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalInt;

/** Scenes with everything that is not a surface of one colour in empty space, several of them in each. */
public final class MatterScenes {
    public static final List<String> NAMES =
            List.of("sky and wax", "picture and dyes", "fog and prism", "picture and milk");

    private MatterScenes() {}

    /** @param folder where their picture is written */
    public static Map<String, Scene> all(Path folder) {
        Shading.Background picture = picture(folder);
        return Map.of(
                NAMES.get(0), skyAndWax(),
                NAMES.get(1), pictureAndDyes(picture),
                NAMES.get(2), fogAndPrism(),
                NAMES.get(3), pictureAndMilk(picture));
    }

    private static Scene.Builder floor(Shading.Background background, Optional<Medium> medium) {
        return PhysicalScenes.view(24, 16)
                .shading(new Shading.Physical(OptionalInt.empty(), background, medium))
                .object(TestScenes.rectangle(-1, 0, -1, -1, 0, 1, 1, 0, 1, 1, 0, -1), PhysicalScenes.WHITE);
    }

    private static Shading.Background picture(Path folder) {
        Path file = folder.resolve("around.pfm");
        try {
            Files.write(file, Pictures.pfm(16, 8, (x, y) -> new double[] {x == 5 && y == 2 ? 40 : 0.2, 0.3, 0.05 * x}));
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
        Texture.File texture = new Texture.File(file, Texture.Filter.BILINEAR, Texture.Encoding.SRGB);
        return new Shading.Background.Picture(texture, Rgb.WHITE, 30);
    }

    private static Glass prism() {
        return Glass.of(linear(1, 0.95, 0.9), 1.6).withDispersion(9);
    }

    private static Material wax(double index, double roughness) {
        Medium inside = new Medium.Coefficients(new Rgb(6, 5, 3), new Rgb(0.06, 0.2, 0.6), 0.3);
        return new Material.Scattering(inside, index, roughness, 1);
    }

    private static Scene skyAndWax() {
        return floor(Shading.Background.Sky.of(35, -120), Optional.empty())
                .object(ball(-0.4, 0.45, -0.1, 0.42), wax(1, 0))
                .object(ball(0.45, 0.5, 0.1, 0.4), prism())
                .build();
    }

    private static Scene pictureAndDyes(Shading.Background picture) {
        Material ink = new Material.Fluorescent(
                linear(0.1, 0.5, 0.1),
                new Material.WavelengthBand(320, 480),
                new Material.WavelengthBand(500, 640),
                0.9);
        return floor(picture, Optional.empty())
                .object(ball(-0.4, 0.45, -0.1, 0.42), ink)
                .object(new Box(at(0.15, 0.02, -0.6), at(0.7, 0.8, 0.1)), ink)
                .object(ball(0.3, 1.1, 0.3, 0.25), Glass.of(linear(1, 1, 1), 1.5))
                .light(new Light.Sphere(
                        at(-0.3, 1.7, -0.4),
                        0.15,
                        Rgb.WHITE,
                        Emission.radiance(Rgb.gray(3)).withUltraviolet(30)))
                .build();
    }

    private static Scene fogAndPrism() {
        Medium fog = new Medium.Coefficients(new Rgb(0.2, 0.25, 0.3), Rgb.gray(0.02), 0.6);
        return floor(new Shading.Background.Constant(Rgb.gray(0.5)), Optional.of(fog))
                .object(ball(-0.4, 0.45, -0.1, 0.42), wax(1.4, 0.5))
                .object(ball(0.45, 0.5, 0.1, 0.4), prism())
                .light(sphereLight(0.1, 1.7, -0.3, 0.2, 9))
                .build();
    }

    private static Scene pictureAndMilk(Shading.Background picture) {
        return floor(picture, Optional.empty())
                .object(ball(0, 0.7, -0.1, 0.6), Glass.of(linear(0.95, 1, 0.9), 1.5))
                .object(ball(0.02, 0.7, -0.1, 0.5), wax(1.33, 0))
                .light(panel(0, 1.95, 0, 0.4, Rgb.gray(6), false))
                .build();
    }
}
