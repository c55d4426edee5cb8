package enlightenment.physical;

import static enlightenment.physical.PhysicalScenes.linear;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.color.Rgb;
import enlightenment.image.Image;
import enlightenment.image.ImageFiles;
import enlightenment.image.PngOptions;
import enlightenment.material.Amount;
import enlightenment.material.Glossy;
import enlightenment.material.Material;
import enlightenment.material.Principled;
import enlightenment.material.Texture;
import enlightenment.render.TestScenes;
import enlightenment.render.Welch;
import enlightenment.scene.BuiltInMethod;
import enlightenment.scene.RenderSettings;
import enlightenment.scene.Scene;
import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

/** Images say how rough surfaces are, and where they are of metal. */
class RoughnessMapTest {
    private static final int SEEDS = 12;

    @TempDir
    private static Path folder;

    /** A linear image of 16 bits: green grows from left to right, blue is 0 or 1 in four stripes. */
    private static Texture image(String name, double least, double most) throws IOException {
        int n = 32;
        float[] rgb = new float[3 * n * n];
        for (int k = 0; k < n * n; k++) {
            rgb[3 * k + 1] = (float) (least + (most - least) * (k % n) / (n - 1));
            rgb[3 * k + 2] = k / n / 8 % 2;
        }
        Path file = folder.resolve(name + ".png");
        ImageFiles.writePng(new Image(n, n, rgb), file, PngOptions.DEFAULT.withDepth(16));
        return new Texture.File(file, Texture.Filter.BILINEAR, Texture.Encoding.LINEAR);
    }

    private static Scene scene(Material sheet) {
        return PhysicalScenes.room()
                .object(TestScenes.rectangle(-0.7, 0.2, -0.3, -0.7, 1.2, 0.3, 0.7, 1.2, 0.3, 0.7, 0.2, -0.3), sheet)
                .light(PhysicalScenes.panel(0, 1.95, 0, 0.3, Rgb.gray(20), false))
                .build();
    }

    private static List<Image> pictures(Scene scene, BuiltInMethod method, int seed) {
        return Rendered.seeds(scene, RenderSettings.of(scene).withMethod(method).withAntialias(7), seed, SEEDS);
    }

    private static void assertAlike(List<Image> expected, List<Image> found) {
        for (int part = 0; part < 4; part++) {
            int x = part % 2 * 8;
            int y = part / 2 * 8;
            for (int band = 0; band < 3; band++) {
                double[] a = Rendered.means(expected, x, y, x + 8, y + 8, band);
                double[] b = Rendered.means(found, x, y, x + 8, y + 8, band);
                String told =
                        "part " + part + ", band " + band + ": " + Statistics.of(b) + " instead of " + Statistics.of(a);
                assertTrue(Welch.of(a, b).probability() >= Welch.sidak(0.01, 60), told);
            }
        }
    }

    /** 0.4 is between two of 63 steps, a fifth beyond the 25th. */
    @Test
    void anImageOfOneRoughnessIsThatRoughness() throws IOException {
        Glossy metal = Glossy.of(linear(0.9, 0.6, 0.3), 0.4);
        Amount map = new Amount.Textured(image("even", 0.8, 0.8), Amount.Channel.GREEN, 0.5);
        assertAlike(
                pictures(scene(metal), BuiltInMethod.RAYTRACE, 101),
                pictures(scene(metal.withRoughness(map)), BuiltInMethod.RAYTRACE, 1));
    }

    @Test
    void theSameImageOfAnotherFactorIsAnotherRoughness() throws IOException {
        Glossy metal = Glossy.of(linear(0.9, 0.6, 0.3), 0.4);
        Amount map = new Amount.Textured(image("other", 0.8, 0.8), Amount.Channel.GREEN, 0.75);
        double[] a = whole(pictures(scene(metal), BuiltInMethod.RAYTRACE, 101));
        double[] b = whole(pictures(scene(metal.withRoughness(map)), BuiltInMethod.RAYTRACE, 1));
        assertTrue(Welch.of(a, b).probability() < 1e-6, Statistics.of(a) + " and " + Statistics.of(b));
    }

    private static double[] whole(List<Image> pictures) {
        return Rendered.means(pictures, 4, 4, 12, 12, 0);
    }

    @ParameterizedTest
    @EnumSource(
            value = BuiltInMethod.class,
            names = {"CLUSTER", "LIGHT", "BIDIRECTIONAL", "METROPOLIS"})
    void allMethodsMakeOnePictureOfRoughnessAndMetalByAnImage(BuiltInMethod method) throws IOException {
        Texture image = image("both", 0.3, 1);
        Scene scene = scene(Principled.of(linear(0.9, 0.6, 0.3), 0, 0)
                .withRoughness(new Amount.Textured(image, Amount.Channel.GREEN, 1))
                .withMetallic(new Amount.Textured(image, Amount.Channel.BLUE, 0.75))
                .withClearcoat(0.5, 0.5));
        assertAlike(pictures(scene, BuiltInMethod.RAYTRACE, 101), pictures(scene, method, 1));
    }
}
