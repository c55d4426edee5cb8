package enlightenment.physical;

import static enlightenment.physical.PhysicalScenes.at;
import static enlightenment.physical.PhysicalScenes.ball;
import static enlightenment.physical.PhysicalScenes.matte;
import static enlightenment.physical.PhysicalScenes.panel;
import static enlightenment.physical.PhysicalScenes.room;
import static enlightenment.physical.PhysicalScenes.sphereLight;
import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.camera.Camera;
import enlightenment.color.Rgb;
import enlightenment.image.Image;
import enlightenment.light.Emission;
import enlightenment.light.Light;
import enlightenment.material.Glass;
import enlightenment.material.Medium;
import enlightenment.math.ExactPoint;
import enlightenment.math.Vec3;
import enlightenment.render.Renderer;
import enlightenment.scene.BuiltInMethod;
import enlightenment.scene.RenderSettings;
import enlightenment.scene.Scene;
import enlightenment.scene.Shading;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.SplittableRandom;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.MethodSource;

/** Lenses and panoramas: all methods make the same picture, and a lens makes the mean of pinhole pictures from its points. */
class CameraMethodsTest {
    private static final double RADIUS = 0.35;
    private static final double FOCUS = 2.6;
    private static final double DEGREES = 37;
    private static final Camera.Perspective PINHOLE =
            new Camera.Perspective(at(0, 1, -3.5), at(0, 1, 0), Vec3.Y, DEGREES);

    private static final Map<String, Camera> CAMERAS = Map.of(
            "round lens", PINHOLE.withLens(Camera.Lens.round(RADIUS, FOCUS)),
            "triangular lens", PINHOLE.withLens(new Camera.Lens(RADIUS, FOCUS, 3, 10)),
            "pupil", window(at(0, 1, -3.5), RADIUS, 0.5),
            "panorama", new Camera.Panorama(at(0.1, 1.1, -0.2), at(0, 0.9, 1), Vec3.Y),
            "stereo", new Camera.Panorama(at(0.1, 1.1, -0.2), at(0, 0.9, 1), Vec3.Y, 0.3, Camera.Handedness.RIGHT));

    private static final PathTracedReferences REFERENCES = new PathTracedReferences(12, 3);

    /** Looks through the square that the pinhole's picture is in the plane in focus, from a point beside the pinhole. */
    private static Camera.Window window(ExactPoint eye, double pupil, double share) {
        double half = FOCUS * StrictMath.tan(StrictMath.toRadians(DEGREES / 2));
        List<ExactPoint> corners = new ArrayList<>();
        for (int k = 0; k < 4; k++) {
            Vec3 corner = new Vec3(k < 2 ? -half : half, 1 + (k == 0 || k == 3 ? -half : half), FOCUS - 3.5);
            Vec3 from = eye.toVec3();
            corners.add(at(from.plus(corner.minus(from).times(share))));
        }
        return new Camera.Window(eye, corners.get(0), corners.get(1), corners.get(2), corners.get(3), pupil);
    }

    /** With a lamp that is in the picture; and a ball of glass, but for light paths alone, which miss what is seen through it. */
    private static Scene.Builder scene(BuiltInMethod method) {
        Scene.Builder scene = opaqueScene();
        return method == BuiltInMethod.LIGHT
                ? scene
                : scene.object(ball(0.45, 0.5, 0.5, 0.35), Glass.of(PhysicalScenes.linear(1, 1, 1), 1.5));
    }

    private static Scene.Builder opaqueScene() {
        return room().light(sphereLight(0.2, 1.5, -0.1, 0.3, 6))
                .light(panel(-0.4, 1.8, 0.2, 0.3, new Rgb(2, 4, 6), false))
                .object(ball(-0.35, 0.45, -0.7, 0.42), matte(0.8, 0.5, 0.3));
    }

    private static RenderSettings settings(Scene scene, BuiltInMethod method, int antialias) {
        return RenderSettings.of(scene).withMethod(method).withAntialias(antialias);
    }

    static Stream<Arguments> methodsAndCameras() {
        return CAMERAS.keySet().stream().sorted().flatMap(camera -> Stream.of(BuiltInMethod.values())
                .filter(method -> method != BuiltInMethod.RAYTRACE)
                .map(method -> Arguments.of(method, camera)));
    }

    @ParameterizedTest
    @MethodSource("methodsAndCameras")
    void everyMethodMakesThePictureOfSinglePaths(BuiltInMethod method, String camera) {
        Scene scene = scene(method).camera(CAMERAS.get(camera)).build();
        List<Image> traced = REFERENCES.of(camera + scene.objects().size(), scene);
        List<Image> others = Rendered.seeds(scene, settings(scene, method, 3), 1, 12);
        Rendered.assertPartsAgree(traced, others, 12 * 20);
    }

    /** Fog between lens and scene: points of light's flights are connected to the lens, too. */
    @ParameterizedTest
    @EnumSource(
            value = BuiltInMethod.class,
            names = {"LIGHT", "BIDIRECTIONAL"})
    void lightInFogIsCarriedToAllPointsOfALens(BuiltInMethod method) {
        Medium fog = Medium.Coefficients.of(Rgb.gray(0.15), Rgb.gray(0.02));
        Scene scene = scene(method)
                .shading(new Shading.Physical(
                        OptionalInt.of(4), new Shading.Background.Constant(Rgb.BLACK), Optional.of(fog)))
                .camera(CAMERAS.get("triangular lens"))
                .build();
        List<Image> traced = Rendered.seeds(scene, settings(scene, BuiltInMethod.RAYTRACE, 6), 100, 12);
        List<Image> others = Rendered.seeds(scene, settings(scene, method, 6), 1, 12);
        Rendered.assertPartsAgree(traced, others, 24);
    }

    /** Each pinhole is an eye behind a window that is a hundredth as far away as the plane in focus. */
    @ParameterizedTest
    @EnumSource(
            value = BuiltInMethod.class,
            names = {"RAYTRACE", "LIGHT"})
    void aLensMakesTheMeanOfPinholePicturesFromItsPoints(BuiltInMethod method) {
        Scene lens = scene(method).camera(CAMERAS.get("round lens")).build();
        List<Image> pictures = Rendered.seeds(lens, settings(lens, method, 4), 1, 12);
        SplittableRandom random = new SplittableRandom(7);
        List<Image> pinholes = new ArrayList<>();
        for (int k = 0; k < 120; k++) {
            double r = RADIUS * Math.sqrt(random.nextDouble());
            double angle = 2 * Math.PI * random.nextDouble();
            ExactPoint eye = at(r * StrictMath.cos(angle), 1 + r * StrictMath.sin(angle), -3.5);
            Scene scene = scene(method).camera(window(eye, 0, 0.01)).build();
            RenderSettings settings = settings(scene, BuiltInMethod.RAYTRACE, 2);
            pinholes.add(Renderer.render(scene, settings.withSeed(k)));
        }
        Rendered.assertPartsAgree(pinholes, pictures, 24);
    }

    /** What lies in the plane in focus is seen as by a pinhole: a wall that is painted with light, and no other. */
    @Test
    void thePlaneInFocusIsSeenAsByAPinhole() {
        double z = FOCUS - 3.5;
        Scene.Builder wall =
                PhysicalScenes.view(16, 16).light(square(-0.4, 1.2, z, 0.3, 2)).light(square(0.5, 0.7, z, 0.2, 5));
        Scene sharp = wall.camera(PINHOLE).build();
        Scene inFocus = wall.camera(CAMERAS.get("round lens")).build();
        Scene blurred = wall.camera(PINHOLE.withLens(Camera.Lens.round(RADIUS, 2 * FOCUS)))
                .build();
        Image expected = Renderer.render(sharp, settings(sharp, BuiltInMethod.RAYTRACE, 32));
        Image found = Renderer.render(inFocus, settings(inFocus, BuiltInMethod.RAYTRACE, 32));
        Image other = Renderer.render(blurred, settings(blurred, BuiltInMethod.RAYTRACE, 32));
        // 1024 samples of a pixel of 5 or 0: the largest standard deviation is 0.08, stratified far less.
        assertTrue(difference(expected, found) < 0.08, "in focus: " + difference(expected, found));
        assertTrue(difference(expected, other) > 1, "out of focus: " + difference(expected, other));
    }

    private static Light square(double x, double y, double z, double half, double radiance) {
        return new Light.Rectangle(
                at(x - half, y - half, z),
                at(x - half, y + half, z),
                at(x + half, y + half, z),
                at(x + half, y - half, z),
                Rgb.WHITE,
                true,
                Emission.radiance(Rgb.gray(radiance)));
    }

    private static double difference(Image a, Image b) {
        float[] p = a.toArray();
        float[] q = b.toArray();
        double most = 0;
        for (int k = 0; k < p.length; k++) {
            most = Math.max(most, Math.abs(p[k] - q[k]));
        }
        return most;
    }

    /**
     * A lamp that is a point beside the blur becomes the image of the aperture: at depth z, seen in units of the picture at distance 1, a disk of
     * radius r |z − f| / (z f), evenly lit, with the light that a pinhole sees.
     */
    @Test
    void aTinyLampBecomesADiskOfTheFormulasDiameter() {
        double z = 2 * FOCUS;
        double radius = 0.02;
        int side = 96;
        Scene.Builder lamp = PhysicalScenes.view(side, side).light(sphereLight(0, 1, z - 3.5, radius, 1000));
        Scene scene = lamp.camera(CAMERAS.get("round lens")).build();
        Image image = Renderer.render(scene, settings(scene, BuiltInMethod.RAYTRACE, 32));
        double perPixel = 2 * StrictMath.tan(StrictMath.toRadians(DEGREES / 2)) / side;
        double disk = RADIUS * Math.abs(z - FOCUS) / (z * FOCUS) / perPixel;
        double smear = radius / z / perPixel;
        double light = 1000 * Math.PI * smear * smear;
        double sum = 0;
        double moment = 0;
        for (int y = 0; y < side; y++) {
            for (int x = 0; x < side; x++) {
                double r = Math.hypot(x + 0.5 - side / 2.0, y + 0.5 - side / 2.0);
                double v = image.component(x, y, 0);
                assertTrue(v == 0 || r < disk + smear + 1, "light at " + r + " of " + disk);
                sum += v;
                moment += v * r * r;
            }
        }
        assertTrue(Math.abs(sum / light - 1) < 0.02, sum + " of " + light);
        // The mean square of the distance is half the square of the radius, and each pixel's is 1/6 more than its
        // middle's.
        double expected = (disk * disk + smear * smear) / 2;
        assertTrue(Math.abs(moment / sum / expected - 1) < 0.02, moment / sum + " instead of " + expected);
    }

    @ParameterizedTest
    @EnumSource(BuiltInMethod.class)
    void aLensOfNoSizeGivesTheBytesOfAPinhole(BuiltInMethod method) {
        Scene without = scene(method).camera(PINHOLE).build();
        Scene with = scene(method)
                .camera(PINHOLE.withLens(Camera.Lens.round(0, FOCUS)))
                .build();
        assertArrayEquals(
                Renderer.render(without, settings(without, method, 2)).toArray(),
                Renderer.render(with, settings(with, method, 2)).toArray());
    }

    /** A lens that is as good as a point gives the bytes of a pinhole where no lamp is in the picture, whose image a pinhole samples. */
    @Test
    void aLensAsGoodAsAPointGivesTheBytesOfAPinhole() {
        Scene.Builder unlit =
                room().light(sphereLight(0, 1, -8, 0.5, 20)).object(ball(0, 0.5, 0, 0.5), matte(0.5, 0.5, 0.5));
        Scene without = unlit.camera(PINHOLE).build();
        Scene with =
                unlit.camera(PINHOLE.withLens(Camera.Lens.round(1e-30, FOCUS))).build();
        assertArrayEquals(
                Renderer.render(without, settings(without, BuiltInMethod.RAYTRACE, 3))
                        .toArray(),
                Renderer.render(with, settings(with, BuiltInMethod.RAYTRACE, 3)).toArray());
    }

    /** A lamp in a known direction is seen in the pixel of the formula, for each eye where that sees it. */
    @Test
    void aLampIsSeenAtItsLongitudeAndLatitude() {
        int width = 64;
        int height = 64;
        double separation = 0.4;
        ExactPoint eye = at(0.5, 1, -0.5);
        for (double longitude : new double[] {-2.9, -1.3, 0.2, 2}) {
            double latitude = 0.6;
            double distance = 3;
            double level = distance * StrictMath.cos(latitude);
            Vec3 to = new Vec3(
                    level * StrictMath.sin(longitude),
                    distance * StrictMath.sin(latitude),
                    level * StrictMath.cos(longitude));
            Vec3 lamp = eye.toVec3().plus(to);
            Scene.Builder scene =
                    PhysicalScenes.view(width, height).light(sphereLight(lamp.x(), lamp.y(), lamp.z(), 0.1, 10));
            Scene mono = scene.camera(new Camera.Panorama(eye, eye.plus(Vec3.Z), Vec3.Y))
                    .build();
            double x = width * (0.5 + longitude / (2 * Math.PI));
            assertBrightest(mono, x, height * (0.5 - latitude / Math.PI), 0, height);
            Scene pair = scene.camera(
                            new Camera.Panorama(eye, eye.plus(Vec3.Z), Vec3.Y, separation, Camera.Handedness.LEFT))
                    .build();
            // The left eye, to the left of the middle, sees the lamp further to the right.
            double turn = StrictMath.asin(separation / 2 / level);
            double along = Math.sqrt(level * level - separation * separation / 4);
            double y = height / 2.0 * (0.5 - StrictMath.atan2(to.y(), along) / Math.PI);
            double shift = width * turn / (2 * Math.PI);
            assertBrightest(pair, (x + shift) % width, y, 0, height / 2);
            assertBrightest(pair, (x - shift + width) % width, y + height / 2.0, height / 2, height);
        }
    }

    /** The centre of gravity of a part's light lies within half a pixel of a place. */
    private static void assertBrightest(Scene scene, double x, double y, int top, int bottom) {
        Image image = Renderer.render(scene, settings(scene, BuiltInMethod.RAYTRACE, 8));
        double sum = 0;
        double sumX = 0;
        double sumY = 0;
        for (int j = top; j < bottom; j++) {
            for (int i = 0; i < image.width(); i++) {
                double v = image.component(i, j, 0);
                sum += v;
                sumX += v * (i + 0.5);
                sumY += v * (j + 0.5);
            }
        }
        assertTrue(sum > 0, "no light");
        assertTrue(Math.abs(sumX / sum - x) <= 0.55, sumX / sum + " instead of column " + x);
        assertTrue(Math.abs(sumY / sum - y) <= 0.55, sumY / sum + " instead of row " + y);
    }
}
