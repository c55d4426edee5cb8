package enlightenment.physical;

import static enlightenment.physical.PhysicalScenes.at;
import static enlightenment.physical.PhysicalScenes.atMost;
import static enlightenment.physical.PhysicalScenes.ball;
import static enlightenment.physical.PhysicalScenes.matte;
import static enlightenment.physical.PhysicalScenes.shading;
import static enlightenment.physical.PhysicalScenes.sphereLight;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.camera.Camera;
import enlightenment.color.DisplayCurve;
import enlightenment.color.Rgb;
import enlightenment.geometry.Box;
import enlightenment.geometry.Cone;
import enlightenment.geometry.Cube;
import enlightenment.geometry.Cylinder;
import enlightenment.geometry.Disk;
import enlightenment.geometry.Torus;
import enlightenment.geometry.Triangle;
import enlightenment.image.Image;
import enlightenment.light.Emission;
import enlightenment.light.Light;
import enlightenment.material.Glass;
import enlightenment.material.Material;
import enlightenment.math.Vec3;
import enlightenment.render.Renderer;
import enlightenment.render.TestScenes;
import enlightenment.scene.BuiltInMethod;
import enlightenment.scene.RenderSettings;
import enlightenment.scene.Scene;
import java.util.Map;
import java.util.TreeMap;
import java.util.function.DoubleFunction;
import java.util.stream.Stream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Pixels of which lights larger than a pixel cover slivers: bright ones are sampled apart there, and shown as they are. */
class EdgesOfLightsTest {
    private static final int SIDE = 16;

    private static final double RADIANCE = 400;

    /** Of a lamp in a black box: beside a brighter one, others are left to camera rays. */
    private static final double NONE = 1;

    private static final double BRIGHTER = 64 * RADIANCE;

    private static final Camera EYE = new Camera.Perspective(at(0.1, 0.2, 0), at(0, 0, 10), Vec3.Y, 50);
    private static final Camera FAR = new Camera.Orthographic(at(0.1, 0.2, 0), at(0, 0, 10), Vec3.Y, 9);
    private static final Camera OBLIQUE =
            new Camera.Window(at(0.1, 0.2, 0), at(-2, -1.5, 3), at(-1.5, 2.5, 5), at(2.5, 2.5, 4), at(2, -1.5, 2), 0);
    private static final Map<String, DoubleFunction<Scene>> SCENES = scenes();

    private static Map<String, DoubleFunction<Scene>> scenes() {
        Map<String, DoubleFunction<Scene>> all = new TreeMap<>();
        all.put("flat and round", l -> flat(EYE, l).build());
        all.put("flat and round from far", l -> flat(FAR, l).build());
        all.put("flat and round through an oblique window", l -> flat(OBLIQUE, l)
                .build());
        all.put("solids", l -> solids(EYE, l).build());
        all.put("solids from far", l -> solids(FAR, l).build());
        all.put("in a flat mirror", l -> inMirror(EYE, l).build());
        all.put("in a flat mirror from far", l -> inMirror(FAR, l).build());
        all.put("in balls", l -> inBalls(l).build());
        all.put("around the eye", l -> aroundTheEye(l).build());
        return all;
    }

    private static Scene.Builder view(Camera camera, double hidden) {
        return Scene.builder()
                .size(8, 8)
                .camera(camera)
                .shading(atMost(1, 0))
                .object(new Box(at(-1, -1, -201), at(1, 1, -199)), matte(0, 0, 0))
                .light(sphereLight(0, 0, -200, 0.01, hidden));
    }

    private static Material lamp(double radiance) {
        return matte(0.5, 0.3, 0.2).withRadiance(new Rgb(radiance, radiance / 2, radiance / 4));
    }

    /** Half of the ball is hidden, and two of them overlap. */
    private static Scene.Builder flat(Camera camera, double hidden) {
        return view(camera, hidden)
                .object(ball(-1.7, 1.3, 7, 1), lamp(RADIANCE))
                .object(TestScenes.rectangle(-4, 1.2, 4, -4, 4, 4, -0.9, 4, 4, -0.9, 1.2, 4), matte(0.7, 0.7, 0.7))
                .object(TestScenes.rectangle(0.2, -2, 7, 0.4, 1, 8, 2.4, 0.6, 9, 2.2, -2.4, 8), lamp(RADIANCE))
                .object(new Disk(at(-1.5, -1.6, 8), new Vec3(0.5, 0.4, -1), 1.1), lamp(RADIANCE / 2))
                .object(new Triangle(at(-1, -0.4, 7.5), at(0.1, 3, 9), at(1.9, 2, 7)), lamp(RADIANCE))
                .light(new Light.Rectangle(
                        at(-4, -3, 8),
                        at(-4, 0, 8),
                        at(-2.5, 0, 8),
                        at(-2.5, -3, 8),
                        Rgb.WHITE,
                        false,
                        Emission.radiance(Rgb.gray(RADIANCE))))
                .object(TestScenes.rectangle(-9, -9, 12, -9, 9, 12, 9, 9, 12, 9, -9, 12), matte(0.7, 0.7, 0.7));
    }

    private static Scene.Builder solids(Camera camera, double hidden) {
        return view(camera, hidden)
                .object(new Box(at(-3, 0.5, 7), at(-1.4, 2.2, 8.5)), lamp(RADIANCE))
                .object(new Cylinder(at(-0.6, 0.4, 7), at(0.4, 2.3, 8), 0.6, true), lamp(RADIANCE))
                .object(new Cylinder(at(1.4, 0.3, 9), at(2.6, 2.3, 6), 0.5, false), lamp(RADIANCE / 2))
                .object(new Cube(at(-2.1, -1.8, 8), 1.4, new Vec3(0.3, 0.5, 0.7)), lamp(RADIANCE))
                .object(new Cone(at(-0.2, -2.6, 8), at(0.6, -0.4, 7), 0.8, 0, true), lamp(RADIANCE))
                .object(new Torus(at(2.4, -1.4, 8), new Vec3(0.3, 1, -0.8), 0.8, 0.3), lamp(RADIANCE))
                .object(TestScenes.rectangle(-9, -9, 12, -9, 9, 12, 9, 9, 12, 9, -9, 12), matte(0.7, 0.7, 0.7));
    }

    private static Scene.Builder inMirror(Camera camera, double hidden) {
        return view(camera, hidden)
                .object(TestScenes.rectangle(-5, -5, 9, -5, 5, 10, 5, 5, 9.5, 5, -5, 8.5), TestScenes.mirror(0.8))
                .object(ball(-1.2, 1.5, 4, 0.6), lamp(RADIANCE))
                .object(ball(1.2, 2.9, -3, 1), lamp(RADIANCE))
                .object(TestScenes.rectangle(0.2, -2, -2, 0.4, 0.8, -1, 2.4, 0.6, 0, 2.2, -2.2, -1), lamp(RADIANCE))
                .object(new Disk(at(-2.5, -1.6, -1), new Vec3(0.5, 0.4, 1), 1.1), lamp(RADIANCE / 2));
    }

    /** Large images in a mirror and in glass. */
    private static Scene.Builder inBalls(double hidden) {
        return view(EYE, hidden)
                .object(ball(-1.5, 0.3, 7, 1.8), TestScenes.mirror(0.8))
                .object(ball(2.4, -1, 7, 1.6), Glass.of(PhysicalScenes.linear(1, 1, 1), 1.5))
                .object(ball(-6, 5, 2, 3), lamp(RADIANCE))
                .object(TestScenes.rectangle(4, -4, -2, 4, 4, -2, 9, 4, -1, 9, -4, -1), lamp(RADIANCE));
    }

    /** One reaches from before to behind the eye, one is around it, one covers all of the picture, and one is behind that. */
    private static Scene.Builder aroundTheEye(double hidden) {
        return view(EYE, hidden)
                .object(TestScenes.rectangle(-1, 1.5, -6, -1, 1.5, 6, 1.4, 1.5, 6, 1.4, 1.5, -6), lamp(RADIANCE))
                .object(
                        TestScenes.rectangle(-1, -1.5, 3, -1, -1.2, 6, 1.4, -1.2, 6, 1.4, -1.5, 3),
                        matte(0.5, 0.5, 0.5))
                .object(ball(0, 0, 30, 9), lamp(RADIANCE))
                .light(sphereLight(0, 0, 80, 60, RADIANCE));
    }

    private static Image render(Scene scene, BuiltInMethod method, double samples, long seed) {
        return Renderer.render(
                scene,
                RenderSettings.of(scene)
                        .withMethod(method)
                        .withSeed(seed)
                        .withBudget(RenderSettings.Budget.NONE.withSamples(samples)));
    }

    private static Image[] pictures(Scene scene, BuiltInMethod method, double samples, int count, long seed) {
        Image[] pictures = new Image[count];
        for (int k = 0; k < count; k++) {
            pictures[k] = render(scene, method, samples, seed + k);
        }
        return pictures;
    }

    /** What lights show at their edges is what they do where those are left to camera rays. */
    private static void assertSame(String name, BuiltInMethod method, double samples, int count) {
        DoubleFunction<Scene> scene = SCENES.get(name);
        Image[] apart = pictures(scene.apply(NONE), method, samples, count, 1);
        Image[] plain = pictures(scene.apply(BRIGHTER), BuiltInMethod.RAYTRACE, 4 * samples, count, 1000);
        int width = apart[0].width();
        double sumApart = 0;
        double sumPlain = 0;
        double variance = 0;
        for (int k = 0; k < width * apart[0].height(); k++) {
            int pixel = k;
            Statistics b = Statistics.of(Stream.of(apart)
                    .mapToDouble(i -> i.component(pixel % width, pixel / width, 1))
                    .toArray());
            Statistics d = Statistics.of(Stream.of(plain)
                    .mapToDouble(i -> i.component(pixel % width, pixel / width, 1))
                    .toArray());
            // What is seldom found may never have been.
            double found = RADIANCE / (4 * samples * count);
            double error = Math.hypot(found, Math.hypot(b.error(), d.error()));
            assertEquals(d.mean(), b.mean(), 6 * error + 1e-3 * d.mean(), name + ", pixel " + k + ": ± " + error);
            sumApart += b.mean();
            sumPlain += d.mean();
            variance += error * error;
        }
        assertEquals(sumPlain, sumApart, 4 * Math.sqrt(variance), name);
    }

    static Stream<String> names() {
        return SCENES.keySet().stream();
    }

    @ParameterizedTest
    @MethodSource("names")
    void edgesAreWhatCameraRaysAloneShow(String name) {
        assertSame(name, BuiltInMethod.RAYTRACE, 16, 8);
    }

    @ParameterizedTest
    @ValueSource(strings = {"CLUSTER", "BIDIRECTIONAL", "METROPOLIS", "LIGHT"})
    void theyHaveThemByAllMethods(BuiltInMethod method) {
        assertSame("flat and round", method, 16, 8);
    }

    @Tag("full")
    @ParameterizedTest
    @MethodSource("names")
    void theyHaveThemWithManySamples(String name) {
        assertSame(name, BuiltInMethod.RAYTRACE, 64, 24);
        assertSame(name, BuiltInMethod.CLUSTER, 64, 24);
        assertSame(name, BuiltInMethod.BIDIRECTIONAL, 32, 24);
    }

    /** The share of a pixel that a disk covers, the pixel's upper left corner seen from the disk's centre, y upwards. */
    private static double coverage(double x, double y, double radius) {
        int strips = 1 << 12;
        double sum = 0;
        for (int k = 0; k < strips; k++) {
            double at = x + (k + 0.5) / strips;
            double half = Math.sqrt(Math.max(radius * radius - at * at, 0));
            sum += Math.max(Math.min(y, half) - Math.max(y - 1, -half), 0);
        }
        return sum / strips;
    }

    /** Seen by parallel rays, one unit is a pixel. Four samples of a pixel seldom find the sliver that makes it grey. */
    @Test
    void fewSamplesShowTheShareOfEachPixelThatALampCovers() {
        double x = 0.31;
        double y = -0.17;
        double radius = 5.838;
        double radiance = 200;
        Scene scene = Scene.builder()
                .size(SIDE, SIDE)
                .shading(shading(0))
                .camera(new Camera.Orthographic(at(0, 0, 0), at(0, 0, 1), Vec3.Y, SIDE))
                .light(sphereLight(x, y, 20, radius, radiance))
                .build();
        double squares = 0;
        int slivers = 0;
        for (int seed = 1; seed <= 3; seed++) {
            Image picture = render(scene, BuiltInMethod.RAYTRACE, 4, seed);
            for (int k = 0; k < SIDE * SIDE; k++) {
                double left = k % SIDE - SIDE / 2.0 - x;
                double top = SIDE / 2.0 - k / SIDE - y;
                double expected = radiance * coverage(left, top, radius);
                double actual = picture.component(k % SIDE, k / SIDE, 0);
                assertEquals(expected, actual, 0.3 * expected + 0.01, "pixel " + k);
                double off = DisplayCurve.SRGB.of(actual) - DisplayCurve.SRGB.of(expected);
                squares += off * off;
                slivers += expected > 0 && expected < 1 ? 1 : 0;
            }
        }
        assertTrue(slivers >= 3, "of " + slivers);
        double error = Math.sqrt(squares / (3 * SIDE * SIDE));
        assertTrue(error < 0.006, "displayed error " + error);
    }

    /** Where a lamp is no brighter than what is behind it, nothing is treated apart, and so nothing becomes noisier. */
    @Test
    void aLampBeforeASkyThatIsAsBrightCannotBeSeen() {
        Scene scene = Scene.builder()
                .size(SIDE, SIDE)
                .shading(shading(1))
                .camera(EYE)
                .light(sphereLight(0, 0, 20, 4, 1))
                .build();
        Image picture = render(scene, BuiltInMethod.RAYTRACE, 4, 1);
        for (int k = 0; k < SIDE * SIDE; k++) {
            assertEquals(1, picture.component(k % SIDE, k / SIDE, 0), 1e-6);
        }
    }
}
