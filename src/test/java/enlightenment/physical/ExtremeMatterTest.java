package enlightenment.physical;

import static enlightenment.physical.PhysicalScenes.ball;
import static enlightenment.physical.PhysicalScenes.linear;
import static enlightenment.physical.PhysicalScenes.sphereLight;
import static enlightenment.physical.PhysicalScenes.view;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.color.Rgb;
import enlightenment.image.Image;
import enlightenment.light.Emission;
import enlightenment.light.Light;
import enlightenment.material.Glass;
import enlightenment.material.Material;
import enlightenment.material.Medium;
import enlightenment.primitive.Ray;
import enlightenment.render.Renderer;
import enlightenment.render.TestScenes;
import enlightenment.sampling.SobolSampler;
import enlightenment.scene.BuiltInMethod;
import enlightenment.scene.Method;
import enlightenment.scene.RenderSettings;
import enlightenment.scene.Scene;
import enlightenment.scene.Shading;
import enlightenment.transport.path.PathIntegrator;
import enlightenment.world.CompiledScene;
import enlightenment.world.SceneCompiler;
import enlightenment.world.parts.RayCounters;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.TreeMap;
import java.util.stream.Stream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.MethodSource;

/**
 * Matter and surroundings with numbers at the ends of their ranges: every method makes a picture of numbers, in a bounded number of steps.
 */
class ExtremeMatterTest {
    private static final int SIDE = 8;

    /** Beyond the 65,536th event of a walk one in 131,072 ends at each: one path in a million lives as much longer. */
    private static final int MOST_EVENTS = (1 << 16) + 14 * (1 << 17);

    /** A path that can never leave has about 8,000 in the mean. */
    private static final long MEAN_EVENTS = 20_000;

    private static final Map<String, Scene> SCENES = scenes();

    private static Map<String, Scene> scenes() {
        Map<String, Scene.Builder> all = new TreeMap<>();
        media(all);
        fogs(all);
        glass(all);
        dyes(all);
        skies(all);
        Map<String, Scene> built = new TreeMap<>();
        all.forEach((name, scene) -> built.put(name, scene.name(name).build()));
        return built;
    }

    private static Scene.Builder lit(Material material) {
        return view(SIDE, SIDE)
                .shading(PhysicalScenes.shading(0.5))
                .light(sphereLight(0.3, 2.2, -0.6, 0.2, 9))
                .object(TestScenes.rectangle(-1, 0, -1, -1, 0, 1, 1, 0, 1, 1, 0, -1), PhysicalScenes.WHITE)
                .object(ball(0, 0.8, 0, 0.7), material);
    }

    private static Medium white(double meanFreePath, double anisotropy) {
        return new Medium.Coefficients(Rgb.gray(1 / meanFreePath), Rgb.BLACK, anisotropy);
    }

    private static void media(Map<String, Scene.Builder> all) {
        for (double path : new double[] {1e-300, 1e-9, 1e-3, 1e9, 1e300}) {
            for (double g : new double[] {-0.999, 0, 0.999}) {
                all.put("white, path " + path + ", g " + g, lit(Material.Scattering.of(white(path, g))));
            }
            Medium ink = new Medium.Colored(new Rgb(1, 0.5, 0), new Rgb(path, 1, Math.sqrt(path)), 0.999);
            all.put("colour, path " + path, lit(new Material.Scattering(ink, 1 + 1e-12, 0, 0)));
            all.put("interface, path " + path, lit(new Material.Scattering(white(path, 0.5), 1.5, 0.5, 0)));
        }
        all.put("index 1 + 1e-12", lit(new Material.Scattering(white(0.1, 0), 1 + 1e-12, 0, 0)));
        all.put("rough index 1 + 1e-12", lit(new Material.Scattering(white(0.1, 0), 1 + 1e-12, 0.5, 0)));
        all.put("index 1 - 1e-12", lit(new Material.Scattering(white(0.1, 0), 1 - 1e-12, 0, 0)));
        all.put("index 1e6", lit(new Material.Scattering(white(0.01, 0), 1e6, 0, 0)));
        all.put(
                "the largest coefficients",
                lit(Material.Scattering.of(
                        new Medium.Coefficients(Rgb.gray(Double.MAX_VALUE / 4), Rgb.gray(Double.MAX_VALUE / 2), 0))));
        all.put("no coefficients", lit(Material.Scattering.of(new Medium.Coefficients(Rgb.BLACK, Rgb.BLACK, 0))));
    }

    private static void fogs(Map<String, Scene.Builder> all) {
        for (double path : new double[] {1e-300, 1e-9, 1e9, 1e300}) {
            for (double g : new double[] {-0.999, 0.999}) {
                all.put(
                        "fog, path " + path + ", g " + g,
                        lit(PhysicalScenes.RED)
                                .shading(new Shading.Physical(
                                        OptionalInt.empty(),
                                        new Shading.Background.Constant(Rgb.gray(0.5)),
                                        Optional.of(white(path, g)))));
            }
        }
    }

    private static void glass(Map<String, Scene.Builder> all) {
        for (double index : new double[] {1 - 1e-12, 1 + 1e-12, 1.5}) {
            for (double abbe : new double[] {0.6, 1e9, 1e300}) {
                Glass glass = Glass.of(linear(1, 1, 1), index).withDispersion(abbe);
                all.put("glass, index " + index + ", V " + abbe, lit(glass));
                all.put("frosted, index " + index + ", V " + abbe, lit(glass.withRoughness(0.5)));
            }
        }
        all.put("tiny V", lit(Glass.of(linear(1, 1, 1), 1 + 1e-12).withDispersion(1e-11)));
    }

    private static void dyes(Map<String, Scene.Builder> all) {
        Material.WavelengthBand[][] bands = {
            {new Material.WavelengthBand(300, 400), new Material.WavelengthBand(400, 780)},
            {new Material.WavelengthBand(300, 780), new Material.WavelengthBand(300, 780)},
            {new Material.WavelengthBand(490, 580), new Material.WavelengthBand(580, 780)},
            {new Material.WavelengthBand(400, Math.nextUp(400.0)), new Material.WavelengthBand(400, Math.nextUp(400.0))
            },
            {new Material.WavelengthBand(779, 780), new Material.WavelengthBand(779.5, 780)},
        };
        for (Material.WavelengthBand[] pair : bands) {
            Material dye = new Material.Fluorescent(linear(0, 0, 0), pair[0], pair[1], 1);
            all.put("dye " + pair[0].low() + " to " + pair[1].low(), inBlackLight(dye, 1e-3));
            all.put("bright dye " + pair[0].low() + " to " + pair[1].low(), inBlackLight(dye, 1e9));
        }
    }

    private static Scene.Builder inBlackLight(Material dye, double ultraviolet) {
        return lit(dye).light(new Light.Sphere(
                PhysicalScenes.at(-0.9, 1.5, -0.5),
                0.1,
                Rgb.WHITE,
                Emission.radiance(Rgb.BLACK).withUltraviolet(ultraviolet)));
    }

    private static void skies(Map<String, Scene.Builder> all) {
        for (double elevation : new double[] {0, 1e-9, 90}) {
            for (double turbidity : new double[] {2, 10}) {
                Shading.Background sky =
                        new Shading.Background.Sky(elevation, 1e9, turbidity, Rgb.WHITE, Rgb.gray(1e6), true);
                all.put(
                        "sky, elevation " + elevation + ", turbidity " + turbidity,
                        lit(PhysicalScenes.RED)
                                .shading(new Shading.Physical(OptionalInt.empty(), sky, Optional.empty())));
            }
        }
    }

    static Stream<Arguments> scenesAndMethods() {
        return methodsOf(SCENES.keySet().stream());
    }

    /** One of each kind. */
    static Stream<Arguments> someScenesAndMethods() {
        return methodsOf(Stream.of(
                "white, path 1.0E-9, g -0.999",
                "white, path 1.0E9, g 0.999",
                "colour, path 1.0E-300",
                "rough index 1 + 1e-12",
                "fog, path 1.0E9, g 0.999",
                "glass, index 1.5, V 0.6",
                "bright dye 300.0 to 400.0",
                "sky, elevation 0.0, turbidity 10.0"));
    }

    private static Stream<Arguments> methodsOf(Stream<String> names) {
        return names.flatMap(name -> Stream.of(BuiltInMethod.values())
                .filter(method -> Method.supports(method, SCENES.get(name)))
                .map(method -> Arguments.of(name, method)));
    }

    @ParameterizedTest
    @MethodSource("someScenesAndMethods")
    void picturesOfSomeAreNumbers(String name, BuiltInMethod method) {
        picturesAreNumbers(name, method);
    }

    @Tag("full")
    @ParameterizedTest
    @MethodSource("scenesAndMethods")
    void picturesAreNumbers(String name, BuiltInMethod method) {
        Scene scene = SCENES.get(name);
        RenderSettings settings =
                RenderSettings.of(scene).withMethod(method).withAntialias(2).withThreads(1);
        Image image = Renderer.render(scene, settings);
        double sum = 0;
        for (float v : image.toArray()) {
            assertTrue(Math.abs(v) < Float.POSITIVE_INFINITY, () -> name + ": " + v);
            sum += v;
        }
        // No light comes through a fog that is as dense as stone.
        assertTrue(sum > 0 || name.startsWith("fog, path 1.0E-"), name + " is black");
    }

    static Stream<String> names() {
        return SCENES.keySet().stream();
    }

    /** Steps are counted, since times are not asserted. */
    @ParameterizedTest
    @MethodSource("names")
    void pathsEnd(String name) {
        CompiledScene scene = SceneCompiler.compile(SCENES.get(name), RenderSettings.of(SCENES.get(name)));
        PathIntegrator tracer = new PathIntegrator(scene, new RayCounters(scene.kindNames.size()));
        SobolSampler sampler = new SobolSampler();
        Ray ray = new Ray();
        double[] color = new double[3];
        tracer.beginTile(0, 0, 1, 1);
        long events = 0;
        for (int pixel = 0; pixel < SIDE * SIDE; pixel++) {
            sampler.pixel(3, pixel % SIDE, pixel / SIDE);
            sampler.sample(0);
            double x = (pixel % SIDE + sampler.filmX()) / SIDE;
            scene.camera.ray(x, (pixel / SIDE + sampler.filmY()) / SIDE, ray);
            tracer.shade(ray, sampler, color);
            assertTrue(tracer.events() <= MOST_EVENTS, name);
            events += tracer.events();
            for (double v : color) {
                assertTrue(Math.abs(v) < Double.POSITIVE_INFINITY, () -> name + ": " + v);
            }
        }
        long all = events;
        assertTrue(all <= MEAN_EVENTS * SIDE * SIDE, () -> name + ": " + all);
    }

    /** In light that is the same from everywhere a cloud that loses none cannot be seen, however thick or thin it is. */
    @ParameterizedTest
    @CsvSource({"1e-9, -0.999", "1e-9, 0.999", "1e-3, -0.999", "0.1, 0.999", "1e9, 0.999"})
    void noThicknessOfAWhiteCloudChangesAFurnace(double path, double g) {
        Scene scene = view(SIDE, SIDE)
                .shading(PhysicalScenes.shading(1))
                .object(ball(0, 0.8, 0, 0.7), new Material.Scattering(white(path, g), 1 + 1e-12, 0, 0))
                .build();
        List<Image> pictures = Rendered.seeds(scene, RenderSettings.of(scene).withAntialias(3), 1, 12);
        for (int band = 0; band < 3; band++) {
            Statistics s = Statistics.of(Rendered.means(pictures, 0, 0, SIDE, SIDE, band));
            assertEquals(1, s.mean(), 6 * s.error() + 1e-6, s::toString);
            assertTrue(s.error() < 0.05, s::toString);
        }
    }
}
