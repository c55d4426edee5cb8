package enlightenment.physical;

import static enlightenment.physical.PhysicalScenes.linear;
import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.camera.Camera;
import enlightenment.color.Rgb;
import enlightenment.geometry.Box;
import enlightenment.image.Image;
import enlightenment.image.ImageFiles;
import enlightenment.material.Glass;
import enlightenment.material.Glossy;
import enlightenment.material.Material;
import enlightenment.material.Principled;
import enlightenment.material.Texture;
import enlightenment.math.Vec3;
import enlightenment.render.TestScenes;
import enlightenment.render.Welch;
import enlightenment.scene.BuiltInMethod;
import enlightenment.scene.RenderSettings;
import enlightenment.scene.Scene;
import java.io.IOException;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.function.Function;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

/** Images say how rough surfaces are, and where they are of metal. */
class RoughnessMapTest {
    private static final int SEEDS = 12;
    private static final int ANTIALIAS = 7;
    private static final PathTracedReferences REFERENCES = new PathTracedReferences(SEEDS, ANTIALIAS);

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
        ImageFiles.writePng(new Image(n, n, rgb), file, ImageFiles.PngOptions.DEFAULT.withDepth(16));
        return new Texture.File(file, Texture.Filter.BILINEAR, Texture.Encoding.LINEAR);
    }

    private static Scene scene(Material sheet) {
        return PhysicalScenes.room()
                .object(TestScenes.rectangle(-0.7, 0.2, -0.3, -0.7, 1.2, 0.3, 0.7, 1.2, 0.3, 0.7, 0.2, -0.3), sheet)
                .light(PhysicalScenes.panel(0, 1.95, 0, 0.3, Rgb.gray(20), false))
                .build();
    }

    private static List<Image> pictures(Scene scene, BuiltInMethod method, int seed) {
        return Rendered.seeds(scene, RenderSettings.of(scene).withMethod(method).withAntialias(ANTIALIAS), seed, SEEDS);
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
        Texture.Amount map = new Texture.Amount.Textured(image("even", 0.8, 0.8), Texture.Amount.Channel.GREEN, 0.5);
        assertAlike(
                pictures(scene(metal), BuiltInMethod.RAYTRACE, 101),
                pictures(scene(metal.withRoughness(map)), BuiltInMethod.RAYTRACE, 1));
    }

    @Test
    void theSameImageOfAnotherFactorIsAnotherRoughness() throws IOException {
        Glossy metal = Glossy.of(linear(0.9, 0.6, 0.3), 0.4);
        Texture.Amount map = new Texture.Amount.Textured(image("other", 0.8, 0.8), Texture.Amount.Channel.GREEN, 0.75);
        double[] a = whole(pictures(scene(metal), BuiltInMethod.RAYTRACE, 101));
        double[] b = whole(pictures(scene(metal.withRoughness(map)), BuiltInMethod.RAYTRACE, 1));
        assertTrue(Welch.of(a, b).probability() < 1e-6, Statistics.of(a) + " and " + Statistics.of(b));
    }

    private static double[] whole(List<Image> pictures) {
        return Rendered.means(pictures, 4, 4, 12, 12, 0);
    }

    /** A block, since rough glass has two faces, or a sheet of what is opaque. */
    private static Scene stand(Material material) {
        return material instanceof Glass
                ? PhysicalScenes.room()
                        .object(new Box(PhysicalScenes.at(-0.6, 0.2, -0.3), PhysicalScenes.at(0.6, 1.2, 0.3)), material)
                        .light(PhysicalScenes.panel(0, 1.95, 0, 0.3, Rgb.gray(20), false))
                        .build()
                : scene(material);
    }

    private static Material glass(Texture.Amount roughness) {
        return Glass.of(linear(0.9, 1, 0.8), 1.5).withRoughness(roughness);
    }

    private static Material varnished(Texture.Amount roughness) {
        return Principled.of(linear(0.9, 0.6, 0.3), 0.5, 0.25).withClearcoat(new Principled.Clearcoat(0.75, roughness));
    }

    private static Image picture(Scene scene) {
        return pictures(scene, BuiltInMethod.RAYTRACE, 1).get(0);
    }

    @Test
    void aTextureOfOneValueIsThatNumberToTheBit() {
        Texture.Amount half = Texture.Amount.of(0.5);
        Texture.Amount texture =
                new Texture.Amount.Textured(Texture.of(new Rgb(1, 0.625, 0)), Texture.Amount.Channel.GREEN, 0.8);
        assertArrayEquals(
                picture(stand(glass(half))).toArray(),
                picture(stand(glass(texture))).toArray());
        assertArrayEquals(
                picture(stand(varnished(half))).toArray(),
                picture(stand(varnished(texture))).toArray());
    }

    /** One bounce, so that a pixel's paths depend on nothing but the place that it sees. */
    private static float[] lit(Material material) {
        Scene scene = PhysicalScenes.view(16, 16)
                .camera(new Camera.Orthographic(PhysicalScenes.at(0, 0, -5), PhysicalScenes.at(0, 0, 0), Vec3.Y, 1))
                .shading(PhysicalScenes.atMost(1, 0.5))
                .object(
                        material instanceof Glass
                                ? new Box(PhysicalScenes.at(-0.5, -0.5, 0), PhysicalScenes.at(0.5, 0.5, 1))
                                : TestScenes.rectangle(-0.5, -0.5, 0, -0.5, 0.5, 0, 0.5, 0.5, 0, 0.5, -0.5, 0),
                        material)
                .light(PhysicalScenes.sphereLight(1, 1, -3, 0.5, 20))
                .build();
        return picture(scene).toArray();
    }

    @Test
    void aCheckerboardIsTheOneNumberOrTheOtherAtEachPlace() {
        Texture.Amount checks = Texture.Amount.of(new Texture.Checker(List.of(Rgb.gray(0.25), Rgb.gray(0.75)), 2));
        for (Function<Texture.Amount, Material> of :
                List.<Function<Texture.Amount, Material>>of(RoughnessMapTest::glass, RoughnessMapTest::varnished)) {
            float[] both = lit(of.apply(checks));
            float[] smooth = lit(of.apply(Texture.Amount.of(0.25)));
            float[] rough = lit(of.apply(Texture.Amount.of(0.75)));
            boolean isFirstSmooth = both[0] == smooth[0];
            for (int k = 0; k < both.length; k++) {
                int pixel = k / 3;
                boolean isSmooth = pixel % 16 < 8 == pixel / 16 < 8 == isFirstSmooth;
                assertEquals(isSmooth ? smooth[k] : rough[k], both[k], "component " + k);
            }
            assertFalse(Arrays.equals(smooth, rough), "roughness shows");
        }
    }

    @ParameterizedTest
    @EnumSource(
            value = BuiltInMethod.class,
            names = {"CLUSTER", "LIGHT", "BIDIRECTIONAL", "METROPOLIS"})
    void allMethodsMakeOnePictureOfFrostedGlassByAnImage(BuiltInMethod method) throws IOException {
        Texture.Amount frost =
                new Texture.Amount.Textured(image("frost", 0.25, 0.5), Texture.Amount.Channel.GREEN, 0.8);
        // Each level would make tables of lost light, again for each picture.
        Scene scene =
                stand(Glass.of(linear(0.9, 1, 0.8), 1.5).withRoughness(frost).withMultipleScattering(false));
        assertAlike(REFERENCES.of("frost", scene), pictures(scene, method, 1));
    }

    @ParameterizedTest
    @EnumSource(
            value = BuiltInMethod.class,
            names = {"CLUSTER", "LIGHT", "BIDIRECTIONAL", "METROPOLIS"})
    void allMethodsMakeOnePictureOfAClearCoatByAnImage(BuiltInMethod method) throws IOException {
        Scene scene = scene(
                varnished(new Texture.Amount.Textured(image("varnish", 0.4, 1), Texture.Amount.Channel.GREEN, 1)));
        assertAlike(REFERENCES.of("clear coat", scene), pictures(scene, method, 1));
    }

    @ParameterizedTest
    @EnumSource(
            value = BuiltInMethod.class,
            names = {"CLUSTER", "LIGHT", "BIDIRECTIONAL", "METROPOLIS"})
    void allMethodsMakeOnePictureOfRoughnessAndMetalByAnImage(BuiltInMethod method) throws IOException {
        Texture image = image("both", 0.3, 1);
        Scene scene = scene(Principled.of(linear(0.9, 0.6, 0.3), 0, 0)
                .withRoughness(new Texture.Amount.Textured(image, Texture.Amount.Channel.GREEN, 1))
                .withMetallic(new Texture.Amount.Textured(image, Texture.Amount.Channel.BLUE, 0.75))
                .withClearcoat(0.5, 0.5));
        assertAlike(REFERENCES.of("roughness and metal", scene), pictures(scene, method, 1));
    }
}
