package enlightenment.physical;

import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.color.Rgb;
import enlightenment.colorimetry.BandSensitivities;
import enlightenment.colorimetry.CauchyFormula;
import enlightenment.image.Image;
import enlightenment.material.Glass;
import enlightenment.material.Material;
import enlightenment.material.Medium;
import enlightenment.render.Renderer;
import enlightenment.render.TestScenes;
import enlightenment.render.Welch;
import enlightenment.scene.BuiltInMethod;
import enlightenment.scene.RenderSettings;
import enlightenment.scene.Scene;
import enlightenment.scene.Shading;
import java.util.Arrays;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.SplittableRandom;
import java.util.function.Function;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.MethodSource;

/**
 * Pictures of glass that disperses are the sums of pictures of glass that does not, over the wavelengths: each with the indices of its own,
 * weighted by what the bands see of it.
 */
class DispersionTest {
    private static final double RANGE = BandSensitivities.LONGEST - BandSensitivities.SHORTEST;

    /** Parts of the picture, each way. */
    private static final int PARTS = 2;

    private static final int SIDE = 8;
    private static final int NUMBERS = 3 * PARTS * PARTS;

    /** What becomes of a glass that disperses. */
    private interface At extends Function<Glass, Material> {}

    private static final Map<String, Function<At, Scene>> SCENES = Map.of(
            "ball", DispersionTest::ball,
            "frosted ball", DispersionTest::frosted,
            "nested", DispersionTest::nested,
            "in water", DispersionTest::inWater,
            "in fog", DispersionTest::inFog);

    private static Glass glass(double index, double abbe) {
        return Glass.of(PhysicalScenes.linear(1, 0.9, 0.8), index).withDispersion(abbe);
    }

    private static Scene ball(At at) {
        return PhysicalScenes.view(SIDE, SIDE)
                .shading(PhysicalScenes.shading(0.2))
                .light(PhysicalScenes.sphereLight(-1, 2.5, -0.5, 0.3, 20))
                .object(TestScenes.rectangle(-2, 0, -2, -2, 0, 2, 2, 0, 2, 2, 0, -2), PhysicalScenes.WHITE)
                .object(PhysicalScenes.ball(0, 0.7, 0, 0.6), at.apply(glass(1.6, 5)))
                .build();
    }

    private static Scene frosted(At at) {
        return PhysicalScenes.view(SIDE, SIDE)
                .shading(PhysicalScenes.shading(0.1))
                .light(PhysicalScenes.sphereLight(-1, 2.5, -0.5, 0.5, 10))
                .object(TestScenes.rectangle(-2, 0, -2, -2, 0, 2, 2, 0, 2, 2, 0, -2), PhysicalScenes.RED)
                .object(
                        PhysicalScenes.ball(0, 0.8, 0, 0.7),
                        at.apply(glass(1.4, 2).withRoughness(0.5)))
                .build();
    }

    /** A bubble of a gas of little dispersion, in glass that absorbs. */
    private static Scene nested(At at) {
        Glass outer = glass(1.5, 6).withAbsorption(new Rgb(0.2, 0.8, 1.5));
        Glass inner = new Glass(PhysicalScenes.linear(1, 1, 1), 1.1, 1, 1, true).withDispersion(20);
        return PhysicalScenes.room()
                .light(PhysicalScenes.panel(0, 1.95, 0, 0.4, Rgb.gray(6), false))
                .object(PhysicalScenes.ball(0, 0.8, 0, 0.6), at.apply(outer))
                .object(PhysicalScenes.ball(0.1, 0.9, 0, 0.3), at.apply(inner))
                .build();
    }

    /** Glass in a liquid of the same index at one wavelength, as in a filter of C. Christiansen. */
    private static Scene inWater(At at) {
        return PhysicalScenes.view(SIDE, SIDE)
                .shading(PhysicalScenes.shading(0.3))
                .light(PhysicalScenes.sphereLight(-1, 3, -0.5, 0.3, 20))
                .object(TestScenes.rectangle(-2, 0, -2, -2, 0, 2, 2, 0, 2, 2, 0, -2), PhysicalScenes.GREEN)
                .object(PhysicalScenes.ball(0, 0.9, 0, 0.8), Glass.of(PhysicalScenes.linear(1, 1, 1), 1.5))
                .object(
                        PhysicalScenes.ball(0, 0.9, 0, 0.5),
                        at.apply(new Glass(PhysicalScenes.linear(1, 1, 1), 1.5, 1, 1, true).withDispersion(3)))
                .build();
    }

    /** Bands that are negative after the glass, in a medium of three extinctions. */
    private static Scene inFog(At at) {
        Medium fog = new Medium.Coefficients(new Rgb(0.1, 0.2, 0.3), new Rgb(0, 0.02, 0.05), 0.3);
        return PhysicalScenes.view(SIDE, SIDE)
                .shading(new Shading.Physical(
                        OptionalInt.empty(), new Shading.Background.Constant(Rgb.gray(0.3)), Optional.of(fog)))
                .light(PhysicalScenes.sphereLight(-1, 2.5, -0.5, 0.4, 10))
                .object(TestScenes.rectangle(-2, 0, -2, -2, 0, 2, 2, 0, 2, 2, 0, -2), PhysicalScenes.WHITE)
                .object(PhysicalScenes.ball(0, 0.7, 0, 0.6), at.apply(glass(1.6, 5)))
                .build();
    }

    private static Material single(Glass glass, double wavelength) {
        double slope = CauchyFormula.slope(
                glass.indexOfRefraction(), glass.dispersion().getAsDouble());
        double index = CauchyFormula.index(glass.indexOfRefraction(), slope, CauchyFormula.place(wavelength));
        return new Glass(glass.color(), index, glass.transparency(), glass.priority(), glass.receivesShadows())
                .withRoughness(glass.roughness())
                .withAbsorption(glass.absorption())
                .withMultipleScattering(glass.multipleScattering());
    }

    private static double[] means(Scene scene, BuiltInMethod method, int antialias, int seed) {
        RenderSettings settings = RenderSettings.of(scene)
                .withMethod(method)
                .withAntialias(antialias)
                .withThreads(1)
                .withSeed(seed);
        Image image = Renderer.render(scene, settings);
        double[] means = new double[NUMBERS];
        int size = image.width() / PARTS;
        for (int y = 0; y < image.height(); y++) {
            for (int x = 0; x < image.width(); x++) {
                int part = y / size * PARTS + x / size;
                for (int c = 0; c < 3; c++) {
                    means[3 * part + c] += image.component(x, y, c) / (size * size);
                }
            }
        }
        return means;
    }

    /** The sum over wavelengths, one of each of some ranges. */
    private static double[] spectral(
            Function<At, Scene> scene, BuiltInMethod method, int antialias, int ranges, int seed) {
        SplittableRandom random = new SplittableRandom(seed);
        double[] sum = new double[NUMBERS];
        for (int k = 0; k < ranges; k++) {
            double wavelength = BandSensitivities.SHORTEST + (k + random.nextDouble()) * RANGE / ranges;
            double[] own = means(scene.apply(g -> single(g, wavelength)), method, antialias, random.nextInt(1 << 30));
            for (int i = 0; i < NUMBERS; i++) {
                sum[i] += own[i] * BandSensitivities.DAYLIGHT.sensitivity(wavelength, i % 3) * RANGE / ranges;
            }
        }
        return sum;
    }

    /** Welch's test on the means of parts of the picture, at 1 % for all of so many cases together. */
    private static void compare(
            String name, BuiltInMethod method, int antialias, int ranges, int seeds, int antialiasOfAll, int cases) {
        Function<At, Scene> scene = SCENES.get(name);
        double[][] sums = IntStream.range(0, seeds)
                .parallel()
                .mapToObj(seed -> spectral(scene, method, antialias, ranges, seed))
                .toArray(double[][]::new);
        double[][] dispersed = IntStream.range(0, seeds)
                .parallel()
                .mapToObj(seed -> means(scene.apply(g -> g), method, antialiasOfAll, seed))
                .toArray(double[][]::new);
        for (int i = 0; i < NUMBERS; i++) {
            double[] a = column(sums, i);
            double[] b = column(dispersed, i);
            String told = "number " + i + ": " + Statistics.of(a) + " and " + Statistics.of(b);
            assertTrue(Welch.of(a, b).probability() >= Welch.sidak(0.01, NUMBERS * cases), told);
        }
    }

    private static double[] column(double[][] rows, int i) {
        return Arrays.stream(rows).mapToDouble(row -> row[i]).toArray();
    }

    @ParameterizedTest
    @CsvSource({
        "ball, RAYTRACE",
        "frosted ball, CLUSTER",
        "ball, LIGHT",
        "nested, BIDIRECTIONAL",
        "in water, METROPOLIS",
        "in fog, RAYTRACE"
    })
    void theyAreSumsOverWavelengths(String name, BuiltInMethod method) {
        // Most of the time goes into the beginning of each picture: so there are few, of many samples.
        compare(name, method, 3, 8, 8, 9, 6);
    }

    static Stream<Arguments> all() {
        return SCENES.keySet().stream().flatMap(name -> BuiltInMethod.rendering(Shading.Model.PHYSICAL).stream()
                .filter(method -> !name.equals("in fog") || method.canRender(Shading.LightFeature.SCATTERING))
                .map(method -> Arguments.of(name, method)));
    }

    @Tag("full")
    @ParameterizedTest
    @MethodSource("all")
    void theyAreSumsOverWavelengthsWithManyPaths(String name, BuiltInMethod method) {
        compare(name, method, 4, 50, 48, 24, (int) all().count());
    }
}
