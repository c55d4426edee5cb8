package enlightenment.physical;

import static enlightenment.physical.PhysicalScenes.at;
import static enlightenment.physical.PhysicalScenes.ball;
import static enlightenment.physical.PhysicalScenes.linear;
import static enlightenment.physical.PhysicalScenes.matte;
import static enlightenment.physical.PhysicalScenes.shading;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.color.Rgb;
import enlightenment.geometry.Box;
import enlightenment.image.Image;
import enlightenment.light.Emission;
import enlightenment.light.Light;
import enlightenment.material.Glass;
import enlightenment.material.Material;
import enlightenment.material.Texture;
import enlightenment.render.TestScenes;
import enlightenment.render.Welch;
import enlightenment.scene.BuiltInMethod;
import enlightenment.scene.RenderSettings;
import enlightenment.scene.Scene;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.stream.Stream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;

/**
 * Every method makes of fluorescent surfaces what paths of single wavelengths make of them: Welch's test of the four quarters in each band,
 * at 1 % for all comparisons together by Šidák's formula. That paths from the eye and from lights agree is reciprocity: the one
 * multiply by the matrix from one side, the others from the other.
 */
class SpectralPartnerTest {
    private static final int HALF = 8;
    private static final Texture CHECKS =
            new Texture.Checker(List.of(new Rgb(0.1, 0.7, 0.5), new Rgb(0.8, 0.3, 0.05)), 4);
    private static final Material YELLOW = dye(linear(0.6, 0.5, 0.2), 320, 450, 500, 600, 0.9);
    private static final Material RED = dye(linear(0.7, 0.05, 0.1), 350, 550, 590, 700, 0.95);

    /** What it absorbs and what it emits overlap, within bands as well. */
    private static final Material WIDE = dye(CHECKS, 330, 620, 410, 760, 1);

    private static final Map<String, Scene> SCENES = scenes();

    private static Material dye(
            Texture color, double fromLow, double fromHigh, double toLow, double toHigh, double yield) {
        return new Material.Fluorescent(
                color,
                new Material.WavelengthBand(fromLow, fromHigh),
                new Material.WavelengthBand(toLow, toHigh),
                yield);
    }

    private static Emission light(double r, double g, double b, double ultraviolet) {
        return Emission.radiance(new Rgb(r, g, b)).withUltraviolet(ultraviolet);
    }

    private static Light panel(double y, Emission emission) {
        return new Light.Rectangle(
                at(-0.6, y, 0.6), at(-0.6, y, -0.6), at(0.7, y, -0.6), at(0.7, y, 0.6), Rgb.WHITE, false, emission);
    }

    private static Map<String, Scene> scenes() {
        Map<String, Scene> scenes = new TreeMap<>();
        scenes.put(
                "inks under a black light",
                PhysicalScenes.room()
                        .object(ball(-0.35, 0.45, -0.1, 0.42), YELLOW)
                        .object(new Box(at(0.15, 0.02, -0.6), at(0.7, 0.8, 0.1)), RED)
                        .light(panel(1.9, light(0, 0, 0.2, 6)))
                        .build());
        scenes.put(
                "walls that shine on each other",
                PhysicalScenes.view(16, 16)
                        .object(TestScenes.rectangle(-1, 0, -1, -1, 0, 1, 1, 0, 1, 1, 0, -1), YELLOW)
                        .object(TestScenes.rectangle(-1, 0, 1, -1, 2, 1, 1, 2, 1, 1, 0, 1), WIDE)
                        .object(TestScenes.rectangle(-1, 0, -1, -1, 2, -1, -1, 2, 1, -1, 0, 1), RED)
                        .object(ball(0.4, 0.5, 0, 0.4), PhysicalScenes.WHITE)
                        .light(new Light.Sphere(at(0.2, 1.5, -0.1), 0.4, Rgb.WHITE, light(1, 2, 3, 3)))
                        .shading(shading(0.3))
                        .build());
        scenes.put(
                "black light through glass and from a mirror",
                PhysicalScenes.room()
                        .object(ball(-0.4, 1.0, -0.1, 0.35), Glass.of(linear(0.95, 0.9, 0.85), 1.5))
                        .object(ball(0.5, 0.9, 0.2, 0.3), Material.Mirror.of(linear(0.9, 0.9, 0.8)))
                        .object(
                                TestScenes.rectangle(-0.9, 0.1, -0.9, -0.9, 0.2, 0.9, 0.9, 0.1, 0.9, 0.9, 0, -0.9),
                                WIDE)
                        .light(panel(1.9, light(0.5, 0, 0.5, 6)))
                        .build());
        scenes.put(
                "a thing that glows in ultraviolet",
                PhysicalScenes.room()
                        .object(
                                ball(-0.35, 0.45, -0.1, 0.42),
                                new Material.Matte(linear(0.2, 0.2, 0.2), true, 0, new Rgb(0.5, 0.1, 0.1), 8))
                        .object(ball(0.4, 1.1, 0.3, 0.35), YELLOW)
                        .object(new Box(at(0.15, 0.02, -0.6), at(0.7, 0.5, 0.1)), RED)
                        .light(panel(1.9, light(0.5, 0.5, 0.5, 0)))
                        .build());
        scenes.put(
                "green light of more than white",
                PhysicalScenes.room()
                        .object(ball(-0.35, 0.45, -0.1, 0.42), dye(linear(0.9, 0.9, 0.1), 400, 490, 490, 580, 1))
                        .object(ball(0.45, 0.5, 0.1, 0.4), matte(0.1, 0.9, 0.9))
                        .light(panel(1.9, light(0.2, 0.3, 6, 0)))
                        .build());
        return scenes;
    }

    static Stream<Arguments> cases() {
        return SCENES.keySet().stream()
                .flatMap(name -> Stream.of(BuiltInMethod.values()).map(method -> Arguments.of(name, method)));
    }

    static Stream<Arguments> someCases() {
        return cases().filter(c -> {
            String name = (String) c.get()[0];
            return name.startsWith("walls") || name.startsWith("black") && c.get()[1] != BuiltInMethod.BIDIRECTIONAL;
        });
    }

    @ParameterizedTest
    @MethodSource("someCases")
    void singleWavelengthsMakeTheSamePicture(String name, BuiltInMethod method) {
        compare(name, method, 3, 8, 6_000);
    }

    @Tag("full")
    @ParameterizedTest
    @MethodSource("cases")
    void singleWavelengthsMakeTheSamePictureWithManyPaths(String name, BuiltInMethod method) {
        compare(name, method, 8, 16, 60_000);
    }

    private static void compare(String name, BuiltInMethod method, int antialias, int seeds, int pathsOfQuarter) {
        Scene scene = SCENES.get(name);
        RenderSettings settings = RenderSettings.of(scene).withMethod(method).withAntialias(antialias);
        List<Image> pictures = Rendered.seeds(scene, settings, 1, seeds);
        NaiveSpectralTracer tracer = new NaiveSpectralTracer(scene, method == BuiltInMethod.LIGHT);
        double level = Welch.sidak(0.01, 12 * SCENES.size() * BuiltInMethod.values().length);
        List<String> different = new ArrayList<>();
        for (int quarter = 0; quarter < 4; quarter++) {
            int x = quarter % 2 * HALF;
            int y = quarter / 2 * HALF;
            double[][] naive = tracer.means(x, y, x + HALF, y + HALF, pathsOfQuarter, 7919L * quarter);
            for (int band = 0; band < 3; band++) {
                double[] ours = Rendered.means(pictures, x, y, x + HALF, y + HALF, band);
                Statistics a = Statistics.of(ours);
                Statistics b = Statistics.of(naive[band]);
                boolean rounded = Math.abs(a.mean() - b.mean()) <= 1e-6 * b.mean();
                if (!rounded && Welch.of(ours, naive[band]).probability() < level) {
                    different.add("quarter " + quarter + ", band " + band + ": " + a + " instead of " + b);
                }
            }
        }
        assertTrue(different.isEmpty(), () -> String.join("\n", different));
    }
}
