package enlightenment.physical;

import static enlightenment.physical.PhysicalScenes.at;
import static enlightenment.physical.PhysicalScenes.ball;
import static enlightenment.physical.PhysicalScenes.linear;
import static enlightenment.physical.PhysicalScenes.matte;
import static enlightenment.physical.PhysicalScenes.sphereLight;
import static enlightenment.physical.PhysicalScenes.view;
import static enlightenment.surroundings.Pictures.grey;
import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.camera.Camera;
import enlightenment.color.Rgb;
import enlightenment.geometry.Box;
import enlightenment.image.Image;
import enlightenment.material.Glass;
import enlightenment.material.Glossy;
import enlightenment.material.Material;
import enlightenment.material.Medium;
import enlightenment.material.Texture;
import enlightenment.math.Vec3;
import enlightenment.render.Renderer;
import enlightenment.render.TestScenes;
import enlightenment.scene.BuiltInMethod;
import enlightenment.scene.RenderSettings;
import enlightenment.scene.Scene;
import enlightenment.scene.SceneException;
import enlightenment.scene.Shading;
import enlightenment.surroundings.Daylight;
import enlightenment.surroundings.Pictures;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.OptionalInt;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

/** Light from pictures and skies in finished pictures: closed forms, the naive tracer, and all methods. */
class SurroundingsTest {
    private static final Material MIRROR = Material.Mirror.of(linear(0.8, 0.8, 0.8));

    @TempDir
    static Path folder;

    private static Shading.Background.Picture picture(
            String name, int width, int height, double turn, Pictures.Texel texels) {
        return picture(name, width, height, turn, Texture.Filter.BILINEAR, texels);
    }

    private static Shading.Background.Picture picture(
            String name, int width, int height, double turn, Texture.Filter filter, Pictures.Texel texels) {
        Path file = folder.resolve(name + ".pfm");
        try {
            Files.write(file, Pictures.pfm(width, height, texels));
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
        Texture.File texture = new Texture.File(file, filter, Texture.Encoding.SRGB);
        return new Shading.Background.Picture(texture, Rgb.WHITE, turn);
    }

    private static Shading.Physical shading(int bounces, Shading.Background background) {
        return new Shading.Physical(
                bounces < 0 ? OptionalInt.empty() : OptionalInt.of(bounces), background, Optional.empty());
    }

    private static Scene.Builder floor(Material material) {
        return view(8, 8)
                .camera(new Camera.Perspective(at(0, 3, 0), at(0, 0, 0), Vec3.Z, 20))
                .object(TestScenes.rectangle(-1, 0, -1, -1, 0, 1, 1, 0, 1, 1, 0, -1), material);
    }

    private static void assertShown(Scene scene, BuiltInMethod method, int antialias, double... radiance) {
        RenderSettings settings = RenderSettings.of(scene).withMethod(method).withAntialias(antialias);
        new ClosedForms.Known(method.word(), scene, radiance).assertShown(settings);
    }

    /** A medium without end leaves nothing of the bands that it scatters, and all of those that it does not. */
    @ParameterizedTest
    @EnumSource(BuiltInMethod.class)
    void aMediumThatIsClearInOneBandLeavesOnlyThatOfAPicture(BuiltInMethod method) {
        Shading.Background even = picture("even", 8, 8, 0, (x, y) -> grey(1));
        Medium medium = Medium.Coefficients.of(new Rgb(0, 0.1, 0.2), Rgb.BLACK);
        Scene scene = floor(matte(0.5, 0.5, 0.5))
                .shading(new Shading.Physical(OptionalInt.empty(), even, Optional.of(medium)))
                .build();
        assertShown(scene, method, 3, new double[] {0.5, 0, 0});
    }

    /** Half of all directions are bright: a matte floor sends back its albedo. */
    @ParameterizedTest
    @EnumSource(BuiltInMethod.class)
    void aFloorUnderABrightHalfOfTheSkyReflectsItsAlbedo(BuiltInMethod method) {
        // Texels are interpolated: 64 rows blur the horizon over a sixty-fourth of the angle, symmetrically to 1/2.
        Shading.Background half =
                picture("half", 64, 64, 0, (x, y) -> new double[] {y < 32 ? 1 : 0, 1, y < 32 ? 2 : 2});
        Scene scene = floor(matte(0.5, 0.25, 0.75)).shading(shading(1, half)).build();
        assertShown(scene, method, 8, new double[] {0.5 * rowsAbove(64), 0.25, 1.5});
    }

    /** Two texels that are not interpolated are the upper and the lower half of all directions. */
    @ParameterizedTest
    @EnumSource(BuiltInMethod.class)
    void aPictureThatIsNotInterpolatedLightsByItsTexels(BuiltInMethod method) {
        Shading.Background half = picture(
                "halves", 1, 2, 30, Texture.Filter.NEAREST, (x, y) -> new double[] {y == 0 ? 1 : 0, y, 2 - 2 * y});
        Scene scene = floor(matte(0.5, 0.25, 0.75)).shading(shading(1, half)).build();
        assertShown(scene, method, 8, new double[] {0.5, 0, 1.5});
    }

    /** The irradiance of the interpolated rows over π, by quadrature. */
    private static double rowsAbove(int rows) {
        double sum = 0;
        int n = 100_000;
        for (int i = 0; i < n; i++) {
            double theta = (i + 0.5) / n * Math.PI / 2;
            double y = theta / Math.PI * rows - 0.5;
            double value = Math.max(0, Math.min(1, rows / 2.0 - y));
            sum += 2 * value * Math.cos(theta) * Math.sin(theta) * Math.PI / 2 / n;
        }
        return sum;
    }

    @ParameterizedTest
    @EnumSource(BuiltInMethod.class)
    void whatReflectsAllLightCannotBeToldFromSurroundingsOfOneColour(BuiltInMethod method) {
        Shading.Background even = picture("even", 5, 3, 17, (x, y) -> new double[] {0.3, 0.7, 1});
        Scene scene = view(8, 8)
                .shading(shading(-1, even))
                .object(ball(0, 1, 0, 0.9), matte(1, 1, 1))
                .object(ball(-1.2, 1, 0.3, 0.4), Material.Mirror.of(linear(1, 1, 1)))
                .build();
        boolean seesMirrored = method != BuiltInMethod.LIGHT;
        assertShown(seesMirrored ? scene : withoutMirror(even), method, 8, 0.3, 0.7, 1);
    }

    private static Scene withoutMirror(Shading.Background even) {
        return view(8, 8)
                .shading(shading(-1, even))
                .object(ball(0, 1, 0, 0.9), matte(1, 1, 1))
                .build();
    }

    private static double[] meanOf(Scene scene, BuiltInMethod method, int antialias) {
        List<Image> pictures = Rendered.seeds(
                scene, RenderSettings.of(scene).withMethod(method).withAntialias(antialias), 1, 12);
        Statistics s = Statistics.of(Rendered.means(pictures, 0, 0, scene.width(), scene.height(), 1));
        return new double[] {s.mean(), s.error()};
    }

    /** What the sun's disk adds, by the same sky without it. */
    private static void assertSunAdds(
            BuiltInMethod method, Scene.Builder builder, int bounces, double expected, int antialias) {
        double[] with = meanOf(builder.shading(shading(bounces, sky(true))).build(), method, antialias);
        double[] without = meanOf(builder.shading(shading(bounces, sky(false))).build(), method, antialias);
        double error = Math.hypot(with[1], without[1]);
        double adds = with[0] - without[0];
        assertTrue(Math.abs(adds - expected) < 6 * error + 1e-4 * expected, adds + " ± " + error + ", not " + expected);
        assertTrue(error < 0.1 * expected, "says nothing: " + error);
    }

    private static Shading.Background sky(boolean sun) {
        return new Shading.Background.Sky(30, 180, 3, Rgb.BLACK, Rgb.WHITE, sun);
    }

    /** Of the middle band: the sun's irradiance straight across its light. */
    private static double ofSun() {
        double sine = Math.sin(Math.toRadians(Daylight.SUN_RADIUS));
        return Math.PI * sine * sine * new Daylight(30, 3).sun().g();
    }

    @ParameterizedTest
    @EnumSource(BuiltInMethod.class)
    void theSunAddsItsIrradianceToAFloor(BuiltInMethod method) {
        double expected = 0.5 / Math.PI * ofSun() * Math.sin(Math.toRadians(30));
        assertSunAdds(method, floor(matte(0.5, 0.5, 0.5)), 1, expected, 4);
    }

    /** The sun stands behind the viewer, over a wide mirror: a wall takes its light twice, straight and from below. */
    @ParameterizedTest
    @EnumSource(
            value = BuiltInMethod.class,
            names = {"RAYTRACE", "CLUSTER", "LIGHT"})
    void aMirrorThrowsTheSunOntoAWall(BuiltInMethod method) {
        Scene.Builder scene = view(8, 8)
                .camera(new Camera.Perspective(at(0, 1, -3.5), at(0, 1, 0), Vec3.Y, 10))
                .object(TestScenes.rectangle(-2, 0, -4, -2, 0, 0, 2, 0, 0, 2, 0, -4), MIRROR)
                .object(TestScenes.rectangle(-1, 0.1, 0, -1, 2, 0, 1, 2, 0, 1, 0.1, 0), matte(0.5, 0.5, 0.5));
        double straight = 0.5 / Math.PI * ofSun() * Math.cos(Math.toRadians(30));
        assertSunAdds(method, scene, 2, 1.8 * straight, 16);
    }

    private static Pictures.Texel rough() {
        return (x, y) -> {
            double lamp = (x - 3) * (x - 3) + (y - 2) * (y - 2) < 4 ? 12 : 0.2;
            return new double[] {lamp + 0.02 * x, lamp + 0.05 * y, y > 4 ? 0.1 : lamp};
        };
    }

    private static Scene partner() {
        return view(16, 16)
                .shading(shading(-1, picture("rough", 16, 8, 130, rough())))
                .object(TestScenes.rectangle(-1, 0, -1, -1, 0, 1, 1, 0, 1, 1, 0, -1), PhysicalScenes.RED)
                .object(new Box(at(0.15, 0.02, -0.6), at(0.7, 0.8, 0.1)), Glossy.of(linear(0.9, 0.8, 0.7), 0.5))
                .object(ball(-0.35, 0.45, -0.1, 0.42), PhysicalScenes.WHITE)
                .object(ball(0.3, 1.3, 0.2, 0.3), Glass.of(linear(0.95, 1, 0.9), 1.5))
                .object(ball(-0.5, 1.4, 0.2, 0.25), rough(1.4))
                .object(TestScenes.rectangle(-0.9, 0.2, -0.8, -0.9, 1, -0.8, -0.2, 1, -0.8, -0.2, 0.2, -0.8), GLASS)
                .light(sphereLight(-0.2, 1.8, -0.3, 0.1, 20))
                .name("surroundings")
                .build();
    }

    private static final Material GLASS = Glass.of(linear(0.9, 0.7, 0.9), 1.5);

    private static Material rough(double index) {
        return Glass.of(linear(1, 1, 1), index).withRoughness(0.5);
    }

    private static void compare(BuiltInMethod method, int antialias, int seeds, int paths) {
        Scene scene = partner();
        RenderSettings settings = RenderSettings.of(scene).withMethod(method).withAntialias(antialias);
        NaivePartnerTest.compare(scene, settings, new NaiveTracer(scene, method == BuiltInMethod.LIGHT), seeds, paths);
    }

    @ParameterizedTest
    @EnumSource(BuiltInMethod.class)
    void naivePathsMakeTheSamePicture(BuiltInMethod method) {
        compare(method, 4, 8, 3_000);
    }

    @Tag("full")
    @ParameterizedTest
    @EnumSource(BuiltInMethod.class)
    void manyNaivePathsMakeTheSamePicture(BuiltInMethod method) {
        compare(method, 12, 32, 1_000_000);
    }

    /** One texel of 512 is a million times as bright as the others: variance is bounded, since it is aimed at. */
    @ParameterizedTest
    @EnumSource(
            value = BuiltInMethod.class,
            names = {"RAYTRACE", "CLUSTER", "BIDIRECTIONAL", "METROPOLIS"})
    void oneBrightTexelIsNoNoise(BuiltInMethod method) {
        Shading.Background spot = picture("spot", 32, 16, 0, (x, y) -> grey(x == 20 && y == 4 ? 1e6 : 1));
        Scene scene = floor(matte(0.5, 0.5, 0.5)).shading(shading(1, spot)).build();
        double[] s = meanOf(scene, method, 8);
        assertTrue(s[0] > 100 && s[1] < 0.02 * s[0], s[0] + " ± " + s[1]);
    }

    @ParameterizedTest
    @EnumSource(BuiltInMethod.class)
    void thePictureIsTheSameWithAnyNumberOfThreads(BuiltInMethod method) {
        Scene scene = partner();
        RenderSettings settings = RenderSettings.of(scene).withMethod(method).withAntialias(4);
        assertArrayEquals(
                Renderer.render(scene, settings.withThreads(1)).toArray(),
                Renderer.render(scene, settings.withThreads(3)).toArray());
    }

    /** Nothing is in the way: each pixel shows the mean of its directions, whatever it is sampled with. */
    @ParameterizedTest
    @EnumSource(BuiltInMethod.class)
    void anEmptyViewShowsThePictureItself(BuiltInMethod method) {
        Shading.Background wave = picture("wave", 64, 32, 0, (x, y) -> grey(1 + Math.cos(x / 4.0) + y / 8.0));
        Scene scene = view(16, 16)
                .shading(shading(-1, wave))
                .object(ball(0, 1, -40, 0.5), PhysicalScenes.WHITE)
                .build();
        NaiveSky sky = NaiveSky.of(wave);
        NaiveScene naive = new NaiveScene(scene);
        List<Image> pictures = Rendered.seeds(
                scene, RenderSettings.of(scene).withMethod(method).withAntialias(6), 1, 4);
        for (int y = 0; y < 16; y++) {
            for (int x = 0; x < 16; x++) {
                double expected = 0;
                for (int k = 0; k < 64; k++) {
                    Vec3 ray = naive.ray((x + (k % 8 + 0.5) / 8) / 16, (y + (k / 8 + 0.5) / 8) / 16)[1];
                    expected += sky.radiance(ray)[0] / 64;
                }
                double mean = Statistics.of(Rendered.means(pictures, x, y, x + 1, y + 1, 0))
                        .mean();
                assertEquals(expected, mean, 0.02 * expected, x + ", " + y);
            }
        }
    }

    @Test
    void aScaledPictureIsAsManyTimesAsBright() {
        Shading.Background.Picture one = picture("scaled", 16, 8, 0, rough());
        Shading.Background twice = new Shading.Background.Picture(one.picture(), new Rgb(2, 4, 8), 0);
        RenderSettings settings = RenderSettings.of(partner()).withAntialias(2);
        Scene plain = floor(MIRROR).shading(shading(-1, one)).build();
        Scene bright = floor(MIRROR).shading(shading(-1, twice)).build();
        float[] a = Renderer.render(plain, settings.withSize(8, 8)).toArray();
        float[] b = Renderer.render(bright, settings.withSize(8, 8)).toArray();
        for (int i = 0; i < a.length; i++) {
            assertEquals(a[i] * (2 << i % 3), b[i], 1e-6 * b[i]);
        }
    }

    @Test
    void aDamagedPictureIsToldWithItsPlaceInTheSceneAndOnce() throws IOException {
        Shading.Background.Picture picture = picture("damaged", 4, 2, 0, (x, y) -> grey(1));
        Path file = picture.picture().file();
        byte[] content = Files.readAllBytes(file);
        Files.write(file, Arrays.copyOf(content, content.length - 5));
        Scene scene = floor(MIRROR).shading(shading(-1, picture)).build();
        SceneException e = assertThrows(SceneException.class, () -> Renderer.render(scene));
        assertEquals("/shading/background/texture", e.problems().get(0).pointer());
        String message = e.getMessage();
        assertTrue(message.contains("cannot read " + file + ": "), message);
        assertEquals(message.indexOf(file.toString()), message.lastIndexOf(file.toString()), message);
        assertEquals(1, message.lines().count());
    }
}
