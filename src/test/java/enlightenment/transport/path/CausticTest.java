package enlightenment.transport.path;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.color.DisplayCurve;
import enlightenment.film.SplatBatch;
import enlightenment.film.SplatFilm;
import enlightenment.film.SplatScale;
import enlightenment.film.SplatSums;
import enlightenment.primitive.Ray;
import enlightenment.sampling.SobolSampler;
import enlightenment.scene.RenderSettings;
import enlightenment.scene.Scene;
import enlightenment.scene.json.SceneReader;
import enlightenment.transport.light.CausticTracer;
import enlightenment.world.CompiledScene;
import enlightenment.world.SceneCompiler;
import enlightenment.world.parts.RayCounters;
import java.nio.file.Path;
import java.util.Arrays;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Caustics by paths from lights, and those seen in mirrors by images, are what plain path tracing finds by chance. */
class CausticTest {
    private static final int SIDE = 8;
    private static final int PIXELS = SIDE * SIDE;
    private static final int SEEDS = 8;

    private static final String ABOVE =
            """
            "camera": { "type": "perspective", "eye": [0, 3, -4], "lookAt": [0, 0, 0], "up": [0, 1, 0], "fieldOfView": FOV },
            """;
    private static final String LAMP =
            """
            { "type": "sphere", "center": [-1.2, 2, 0.4], "radius": 0.7, "color": "#ffffff", "radiance": [3, 2, 1] }
            """;
    private static final String PANEL =
            """
            { "type": "rectangle", "corners": [[-0.8, 2.5, 0.8], [-0.8, 2.5, -0.8], [0.8, 2.5, -0.8], [0.8, 2.5, 0.8]],
              "color": "#ffffff", "radiance": [3, 2, 1], "twoSided": SIDES }
            """;
    private static final String FLOOR =
            """
            { "type": "rectangle", "corners": [[-3, 0, -3], [-3, 0, 3], [3, 0, 3], [3, 0, -3]],
              "material": { "type": "matte", "color": { "linear": [0.6, 0.5, 0.4] } } }
            """;
    private static final String MIRROR =
            """
            { "type": "sphere", "center": [0.6, 0.7, 0.3], "radius": 0.6,
              "material": { "type": "mirror", "color": { "linear": [0.9, 0.8, 0.7] } } }
            """;
    private static final String GLASS =
            """
            { "type": "sphere", "center": [-0.4, 0.8, 0], "radius": 0.5,
              "material": { "type": "glass", "color": { "linear": [0.9, 0.8, 1] }, "indexOfRefraction": 1.5, "absorption": [0.2, 0.1, 0] } }
            """;

    /** A mirror's, and one where light is seen. */
    static final String TWO_EVENTS = ", \"maxBounces\": 2";

    private static final String FROM_ABOVE =
            """
            "camera": { "type": "orthographic", "eye": [0, 5, 0], "lookAt": [0, 0, 0], "up": [0, 0, 1], "height": 1 },
            """;
    private static final String POINT =
            "{ \"type\": \"point\", \"position\": [0, 1, 0.5], \"color\": \"#ffffff\", \"intensity\": 2 }";
    private static final String MIRROR_WALL =
            """
            { "type": "rectangle", "corners": [[-9, 0, 1.5], [-9, 9, 1.5], [9, 9, 1.5], [9, 0, 1.5]],
              "material": { "type": "mirror", "color": { "linear": [0.9, 0.9, 0.9] } } }
            """;

    private static CompiledScene scene(String camera, String lights, String... objects) {
        return scene("", camera, lights, objects);
    }

    static CompiledScene scene(String limit, String camera, String lights, String[] objects) {
        String text = "{ \"image\": { \"width\": 8, \"height\": 8 }, \"shading\": { \"model\": \"physical\""
                + limit + " }, "
                + camera + "\"lights\": [" + lights + "], \"objects\": [" + String.join(", ", objects) + "] }";
        Scene scene = SceneReader.readString(text, Path.of(""), "");
        return SceneCompiler.compile(scene, RenderSettings.of(scene));
    }

    private static String fov(int degrees) {
        return ABOVE.replace("FOV", Integer.toString(degrees));
    }

    /** Adds a picture by paths from the eye, with or without what the pass makes. */
    private static void fromEye(CompiledScene scene, long seed, int samples, boolean leavesOut, double[] rgb) {
        PathIntegrator tracer = new PathIntegrator(scene, new RayCounters(scene.kindNames.size()), leavesOut);
        tracer.beginTile(0, 0, 1, 1);
        SobolSampler sampler = new SobolSampler();
        Ray ray = new Ray();
        double[] out = new double[3];
        for (int pixel = 0; pixel < PIXELS; pixel++) {
            sampler.pixel(seed, pixel % SIDE, pixel / SIDE);
            for (int s = 0; s < samples; s++) {
                sampler.sample(s);
                double x = (pixel % SIDE + sampler.filmX()) / SIDE;
                double y = (pixel / SIDE + sampler.filmY()) / SIDE;
                scene.camera.ray(x, y, ray);
                tracer.shade(ray, sampler, out);
                for (int c = 0; c < 3; c++) {
                    rgb[3 * pixel + c] += out[c] / samples;
                }
            }
        }
    }

    private static SplatSums batch(CausticTracer tracer, SplatScale scale, int first, int paths) {
        SplatBatch batch = new SplatBatch(0, 0, SIDE, SIDE, scale);
        batch.begin(paths);
        for (int i = 0; i < paths; i++) {
            tracer.trace(first + i, batch);
        }
        return batch.sums();
    }

    private static void fromLights(CompiledScene scene, long seed, int paths, double[] rgb) {
        CausticTracer tracer = new CausticTracer(scene, seed, SIDE, SIDE, new RayCounters(scene.kindNames.size()));
        SplatScale scale = SplatScale.of(tracer.meanContribution(256), paths, PIXELS);
        SplatFilm film = new SplatFilm(0, 0, SIDE, SIDE, PIXELS, scale, DisplayCurve.NONE);
        film.add(0, batch(tracer, scale, 0, paths));
        for (int k = 0; k < rgb.length; k++) {
            rgb[k] += film.component(k / 3 % SIDE, k / 3 / SIDE, k % 3);
        }
    }

    /** What the pass makes of red, in the mean of all pixels and of several pictures, and the standard error of that. */
    record Mean(double value, double error) {
        static Mean of(CompiledScene scene, int paths) {
            double sum = 0;
            double squares = 0;
            for (int i = 0; i < SEEDS; i++) {
                double[] rgb = new double[3 * PIXELS];
                fromLights(scene, i, paths, rgb);
                double mean = 0;
                for (int k = 0; k < rgb.length; k += 3) {
                    mean += rgb[k] / PIXELS;
                }
                sum += mean / SEEDS;
                squares += mean * mean / SEEDS;
            }
            return new Mean(sum, Math.sqrt((squares - sum * sum) / (SEEDS - 1)));
        }
    }

    /** Both ways with several seeds each: pixels by Welch's statistic, and the mean of the picture. */
    static void assertSame(CompiledScene scene, int samples, int paths) {
        assertTrue(scene.physical.hasCausticPass());
        double[][] plain = new double[SEEDS][3 * PIXELS];
        double[][] pass = new double[SEEDS][3 * PIXELS];
        double[][] splats = new double[SEEDS][3 * PIXELS];
        for (int i = 0; i < SEEDS; i++) {
            fromEye(scene, 100 + i, samples, false, plain[i]);
            fromEye(scene, 200 + i, samples, true, pass[i]);
            fromLights(scene, 300 + i, paths, splats[i]);
            for (int k = 0; k < 3 * PIXELS; k++) {
                pass[i][k] += splats[i][k];
            }
        }
        double difference = 0;
        double variance = 0;
        double squares = 0;
        double fourth = 0;
        for (int k = 0; k < 3 * PIXELS; k++) {
            double d = mean(plain, k) - mean(pass, k);
            double v = variance(plain, k) + variance(pass, k);
            difference += d;
            variance += v;
            squares += d * d;
            fourth += v * v;
        }
        // Bands of a pixel err together, pixels do not: of squares of normal numbers with the variances v, each of
        // three bands, the variance is 6 Σ v².
        assertTrue(Math.abs(difference) < 4 * Math.sqrt(3 * variance), difference + " of " + Math.sqrt(3 * variance));
        double most = variance + 4 * Math.sqrt(6 * fourth);
        assertTrue(squares < most, squares + " instead of " + variance);
    }

    private static double mean(double[][] runs, int k) {
        double sum = 0;
        for (double[] run : runs) {
            sum += run[k];
        }
        return sum / runs.length;
    }

    private static double variance(double[][] runs, int k) {
        double mean = mean(runs, k);
        double sum = 0;
        for (double[] run : runs) {
            sum += (run[k] - mean) * (run[k] - mean);
        }
        return sum / (runs.length - 1) / runs.length;
    }

    @ParameterizedTest
    @ValueSource(ints = {50, 20})
    void aLampOverAMirrorBallAtAnyZoom(int degrees) {
        assertSame(scene(fov(degrees), LAMP, FLOOR, MIRROR), 256, 8_192);
    }

    @Test
    void aPanelOverGlassThatAbsorbs() {
        assertSame(scene(fov(50), PANEL.replace("SIDES", "false"), FLOOR, GLASS), 256, 8_192);
    }

    /** Light that comes to rough glass first is found by light samples there, and is no matter of the pass. */
    @Test
    void roughGlassAndGlassThatIsOpaqueInPart() {
        String rough = GLASS.replace("1.5, ", "1.5, \"roughness\": 0.4, ");
        assertSame(scene(fov(50), LAMP, FLOOR, rough), 256, 8_192);
        String partial = GLASS.replace("1.5, ", "1.5, \"transparency\": 0.5, ");
        assertSame(scene(fov(50), LAMP, FLOOR, partial), 256, 8_192);
    }

    @Test
    void aPaneBelowALamp() {
        String pane =
                """
                { "type": "rectangle", "corners": [[-2, 0.9, -1], [-2, 1, 1], [1, 1, 1], [1, 0.9, -1]],
                  "material": { "type": "glass", "color": { "linear": [0.9, 0.8, 1] }, "indexOfRefraction": 1.5 } }
                """;
        assertSame(scene(fov(50), LAMP, FLOOR, pane), 256, 8_192);
    }

    @Test
    void severalLightsAndThingsWhoseConesOverlap() {
        String lights = LAMP + ", " + PANEL.replace("SIDES", "true");
        assertSame(scene(fov(50), lights, FLOOR, MIRROR, GLASS), 256, 16_384);
    }

    @Test
    void parallelRaysAndAWindow() {
        String parallel =
                """
                "camera": { "type": "orthographic", "eye": [0, 5, -1], "lookAt": [0.2, 0, 0], "up": [0, 0, 1], "height": 4 },
                """;
        assertSame(scene(parallel, LAMP, FLOOR, MIRROR), 256, 8_192);
        String window =
                """
                "camera": { "type": "window", "eye": [0, 3, -4], "lowerLeft": [-1, 1.5, -2.6], "upperLeft": [-1, 2.2, -2.2],
                            "upperRight": [1.2, 2.3, -2.3], "lowerRight": [1.2, 1.6, -2.7] },
                """;
        assertSame(scene(window, LAMP, FLOOR, MIRROR), 256, 8_192);
    }

    @Test
    void causticsSeenInAMirror() {
        String wall =
                """
                { "type": "rectangle", "corners": [[-3, 0, 1.5], [-3, 3, 1.5], [3, 3, 1.5], [3, 0, 1.5]],
                  "material": { "type": "mirror", "color": { "linear": [0.9, 0.9, 0.9] } } }
                """;
        String camera =
                """
                "camera": { "type": "perspective", "eye": [0.5, 0.6, 0.9], "lookAt": [0.5, 0.1, 1.5], "up": [0, 1, 0], "fieldOfView": 60 },
                """;
        String ball = MIRROR.replace("[0.6, 0.7, 0.3]", "[0.3, 0.7, -0.2]");
        assertSame(scene(camera, LAMP, FLOOR, ball, wall), 512, 8_192);
    }

    /** What a flat mirror sends of a point light is that of its mirror image; no path from the eye finds it. */
    @Test
    void aPointLightInAFlatMirrorIsASecondOne() {
        // By the middles of pixels: off by less than a five-hundredth.
        double expected = 0;
        for (int pixel = 0; pixel < PIXELS; pixel++) {
            double x = (pixel % SIDE + 0.5) / SIDE - 0.5;
            double z = (pixel / SIDE + 0.5) / SIDE - 0.5;
            double dd = x * x + 1 + (z - 2.5) * (z - 2.5);
            expected += 0.6 / Math.PI * 2 * 0.9 / (dd * Math.sqrt(dd)) / PIXELS;
        }
        CompiledScene scene = scene(TWO_EVENTS, FROM_ABOVE, POINT, new String[] {FLOOR, MIRROR_WALL});
        Mean found = Mean.of(scene, 65_536);
        assertTrue(Math.abs(found.value - expected) < 5 * found.error + 0.002 * expected, found + ", not " + expected);
    }

    /** What stands between eye and caustic turns no ray: the pass sees through it, so that even the light of points is found. */
    @Test
    void anInterfaceOfIndexOneBeforeTheEyeDimsACausticByItsAbsorption() {
        String smoke =
                """
                { "type": "box", "min": [-1, 3, -1], "max": [1, 4, 1],
                  "material": { "type": "glass", "color": "#ffffff", "indexOfRefraction": 1, "absorption": [0.5, 0, 2] } }
                """;
        double[] clear = causticOfAPoint(MIRROR_WALL);
        double[] dimmed = causticOfAPoint(MIRROR_WALL, smoke);
        double[] factors = {Math.exp(-0.5), 1, Math.exp(-2)};
        for (int c = 0; c < factors.length; c++) {
            assertTrue(clear[c] > 0.01, clear[c] + " in band " + c);
            assertEquals(factors[c], dimmed[c] / clear[c], 0.02, "band " + c);
        }
    }

    private static double[] causticOfAPoint(String... things) {
        String[] objects = Arrays.copyOf(things, things.length + 1);
        objects[things.length] = FLOOR;
        double[] rgb = new double[3 * PIXELS];
        fromLights(scene(TWO_EVENTS, FROM_ABOVE, POINT, objects), 1, 1 << 19, rgb);
        double[] sums = new double[3];
        for (int k = 0; k < rgb.length; k++) {
            sums[k % 3] += rgb[k] / PIXELS;
        }
        return sums;
    }

    @Test
    void aPaneAndFogBeforeTheEye() {
        String pane =
                """
                { "type": "rectangle", "corners": [[-2, 1.8, -3], [-2, 2.8, -2], [2, 2.8, -2], [2, 1.8, -3]],
                  "material": { "type": "glass", "color": { "linear": [0.9, 0.8, 1] }, "indexOfRefraction": 1.5 } }
                """;
        assertSame(scene(fov(50), LAMP, FLOOR, MIRROR, pane), 256, 8_192);
        String fog =
                """
                { "type": "box", "min": [-3, -1, -3], "max": [3, 1.5, 3],
                  "material": { "type": "scattering", "scatteringCoefficient": [0.2, 0.1, 0.3], "absorptionCoefficient": [0.1, 0.2, 0] } }
                """;
        assertSame(scene(fov(50), LAMP, FLOOR, MIRROR, fog), 256, 8_192);
    }

    @Test
    void pathsMayBeFollowedInBatchesOfAnySize() {
        CompiledScene scene = scene(fov(50), LAMP, FLOOR, MIRROR, GLASS);
        SplatScale scale = new SplatScale(30);
        CausticTracer tracer = new CausticTracer(scene, 1, SIDE, SIDE, new RayCounters(scene.kindNames.size()));
        SplatFilm whole = new SplatFilm(0, 0, SIDE, SIDE, PIXELS, scale, DisplayCurve.NONE);
        whole.add(0, batch(tracer, scale, 0, 1_000));
        SplatFilm parts = new SplatFilm(0, 0, SIDE, SIDE, PIXELS, scale, DisplayCurve.NONE);
        CausticTracer other = new CausticTracer(scene, 1, SIDE, SIDE, new RayCounters(scene.kindNames.size()));
        parts.add(1, batch(other, scale, 300, 700));
        parts.add(0, batch(other, scale, 0, 300));
        assertArrayEquals(whole.toImage().toArray(), parts.toImage().toArray());
        assertTrue(whole.component(4, 4, 0) > 0);
    }

    @Test
    void thereIsNoPassWithoutMirrorsLightsOrBounces() {
        assertFalse(scene(fov(50), LAMP, FLOOR).physical.hasCausticPass());
        assertFalse(scene(fov(50), "", FLOOR, MIRROR).physical.hasCausticPass());
        String behind = PANEL.replace("SIDES", "false").replace("2.5", "-2.5");
        assertEquals(false, scene(fov(50), behind, FLOOR, MIRROR).physical.hasCausticPass());
    }
}
