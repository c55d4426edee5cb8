package enlightenment.world.check;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.camera.Camera;
import enlightenment.color.DisplayRgb;
import enlightenment.color.Rgb;
import enlightenment.geometry.Box;
import enlightenment.geometry.Cylinder;
import enlightenment.geometry.Rectangle;
import enlightenment.geometry.Sphere;
import enlightenment.light.Emission;
import enlightenment.light.Light;
import enlightenment.material.Glass;
import enlightenment.material.Material;
import enlightenment.material.Texture;
import enlightenment.math.ExactPoint;
import enlightenment.math.Vec3;
import enlightenment.scene.RenderSettings;
import enlightenment.scene.Scene;
import enlightenment.scene.SceneObject;
import enlightenment.scene.Shading;
import enlightenment.scene.json.SceneReader;
import enlightenment.world.SceneCompiler;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.function.Predicate;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;

class SceneHintsTest {
    private static final Material WHITE = Material.Matte.of(Texture.of(DisplayRgb.WHITE));
    private static final Material MIRROR = Material.Mirror.of(Texture.of(DisplayRgb.WHITE));
    private static final Material CLEAR = Glass.of(Texture.of(DisplayRgb.WHITE), 1.5);
    private static final Material MILKY = new Glass(Texture.of(DisplayRgb.WHITE), 1.5, 0, 0, true);
    private static final Light LAMP = new Light.Sphere(ExactPoint.of(3, 3, -3), 0.5, DisplayRgb.WHITE);
    private static final Sphere BALL = Sphere.of(ExactPoint.of(0, 0, 0), 1);
    private static final Predicate<String> DISTANT = hint -> hint.contains("cannot distinguish neighbouring pixels");
    private static final String NO_LIGHT =
            "/lights: there is no light; objects show 0.5 (/shading/ambient) of their colours, without shading";
    private static final String NARROW =
            "/camera: the angle of view is less than 1 degree, and nothing is seen whole through it";

    @Test
    void shippedScenesMakeSense() throws IOException {
        try (Stream<Path> files = Files.walk(Path.of(System.getProperty("project.directory"), "scenes"))) {
            List<Path> scenes =
                    files.filter(f -> f.toString().endsWith(".json")).sorted().toList();
            assertEquals(true, scenes.size() >= 14);
            for (Path file : scenes) {
                assertEquals(List.of(), hints(SceneReader.read(file)), file.toString());
            }
        }
    }

    @Test
    void anEyeExactlyOnASurfaceSeesNothingButThat() {
        for (Shading shading : List.of(Shading.Physical.DEFAULT, Shading.Classic.DEFAULT)) {
            List<String> on = hints(from(-1).object(BALL, WHITE).light(LAMP).shading(shading));
            assertEquals(List.of("/camera: lies on the surface of /objects/0, which fills the picture"), on);
            List<String> beside =
                    hints(from(-1.0000001).object(BALL, WHITE).light(LAMP).shading(shading));
            assertEquals(List.of(), beside);
        }
    }

    @Test
    void aLampInThePlaceOfAnotherIsNamedBecauseOnlyOneOfThemShines() {
        Light.Sphere lamp = (Light.Sphere) LAMP;
        Light fainter =
                new Light.Sphere(lamp.center(), lamp.radius(), DisplayRgb.WHITE, Emission.radiance(Rgb.gray(0.5)));
        Light point = new Light.Point(lamp.center(), DisplayRgb.WHITE);
        List<String> found = hints(from(-5).object(BALL, WHITE)
                .shading(Shading.Physical.DEFAULT)
                .light(point)
                .light(LAMP)
                .light(fainter));
        assertEquals(1, found.size());
        assertTrue(
                found.get(0).matches("/lights/[12]: is in exactly the same place .* it gives no light"), found.get(0));
        assertEquals(
                List.of(),
                hints(from(-5).object(BALL, WHITE)
                        .shading(Shading.Physical.DEFAULT)
                        .light(point)
                        .light(LAMP)));
    }

    @Test
    void anEmptySceneShowsNothing() {
        assertEquals(List.of("/objects: there is nothing to see"), hints(from(-5)));
        // A light can be seen; one of a single point cannot.
        assertEquals(List.of(), hints(from(-5).light(LAMP)));
        Light point = new Light.Point(ExactPoint.of(0, 0, 0), DisplayRgb.WHITE);
        assertEquals(List.of("/objects: there is nothing to see"), hints(from(-5).light(point)));
    }

    @Test
    void withoutLightMatteThingsAreFlat() {
        assertEquals(List.of(NO_LIGHT), hints(from(-5).object(BALL, WHITE)));
        assertEquals(List.of(NO_LIGHT), hints(from(-5).object(BALL, MILKY)));
        Light black = new Light.Sphere(ExactPoint.of(3, 3, -3), 0.5, DisplayRgb.BLACK);
        assertEquals(
                List.of("/lights: every light is black"),
                hints(from(-5).object(BALL, WHITE).light(black)));
    }

    @Test
    void withoutLightTheRestMakesSense() {
        assertEquals(List.of(), hints(from(-5).object(BALL, MIRROR)));
        assertEquals(List.of(), hints(from(-5).object(BALL, CLEAR)));
        Shading.Classic allAmbient = new Shading.Classic(1, 0.5, DisplayRgb.BLACK, 100);
        assertEquals(List.of(), hints(from(-5).object(BALL, WHITE).shading(allAmbient)));
    }

    @Test
    void aCameraInsideAnOpaqueSolidSeesADarkWall() {
        List<String> expected = List.of("/camera: is inside /objects/1 (\"hull\"), which is opaque and holds no light");
        for (Material material : List.of(WHITE, MIRROR, MILKY)) {
            SceneObject hull = new SceneObject("hull", Sphere.of(ExactPoint.of(0, 0, -5), 2), material, List.of());
            assertEquals(
                    expected, hints(from(-5).object(BALL, WHITE).object(hull).light(LAMP)));
        }
    }

    @Test
    void aRoomMakesSense() {
        Box room = new Box(ExactPoint.of(-9, -9, -9), ExactPoint.of(9, 9, 9));
        assertEquals(
                List.of(),
                hints(from(-5).object(BALL, WHITE).object(room, WHITE).light(LAMP)));
        // In the water.
        assertEquals(
                List.of(),
                hints(from(-5).object(BALL, WHITE).object(room, CLEAR).light(LAMP)));
        // A pipe is no solid.
        Cylinder pipe = new Cylinder(ExactPoint.of(0, 0, -7), ExactPoint.of(0, 0, -3), 1, false);
        assertEquals(
                List.of(),
                hints(from(-5).object(BALL, WHITE).object(pipe, WHITE).light(LAMP)));
        // The sky may shine by itself.
        Shading.Classic allAmbient = new Shading.Classic(1, 0.5, DisplayRgb.BLACK, 100);
        Sphere sky = Sphere.of(ExactPoint.of(0, 0, 0), 100);
        assertEquals(List.of(), hints(from(-5).object(sky, WHITE).shading(allAmbient)));
    }

    @Test
    void aCameraOnASurfaceIsNotInside() {
        // The eye stands on the box; 0.1 is no double, and its rounding must not put the eye inside.
        Box ground = new Box(ExactPoint.of("-9", "-9", "-9"), ExactPoint.of("9", "0.1", "9"));
        Camera standing = new Camera.Perspective(ExactPoint.of("0", "0.1", "-5"), ExactPoint.of(0, 1, 0), Vec3.Y, 40);
        assertEquals(
                List.of("/camera: lies on the surface of /objects/0, which fills the picture"),
                hints(Scene.builder()
                        .size(8, 8)
                        .camera(standing)
                        .object(ground, WHITE)
                        .light(LAMP)));
    }

    @Test
    void whatStandsBetweenEyeAndWindowIsNoMistake() {
        Camera window = new Camera.Window(
                ExactPoint.of(0, 0, -5),
                ExactPoint.of(-1, -1, -3),
                ExactPoint.of(-1, 1, -3),
                ExactPoint.of(1, 1, -3),
                ExactPoint.of(1, -1, -3),
                0);
        Sphere aroundTheEye = Sphere.of(ExactPoint.of(0, 0, -5), 1);
        assertEquals(
                List.of(),
                hints(Scene.builder()
                        .size(8, 8)
                        .camera(window)
                        .object(aroundTheEye, WHITE)
                        .light(LAMP)));
    }

    @Test
    void aLightInsideAnOpaqueSolidGivesNoLight() {
        String expected = "/lights/1: is inside /objects/0, which is opaque: no light comes out";
        List<Light> lights = List.of(
                new Light.Sphere(ExactPoint.of(0, 0, 0), 0.9, DisplayRgb.WHITE),
                new Light.Point(ExactPoint.of(0, 0.5, 0), DisplayRgb.WHITE),
                rectangle(0.5));
        for (Light light : lights) {
            assertEquals(List.of(expected), hints(withBallAnd(WHITE, light)), light.type());
            assertEquals(List.of(), hints(withBallAnd(CLEAR, light)), light.type());
        }
    }

    @Test
    void aLightThatLooksOutOfASolidMakesSense() {
        List<Light> lights = List.of(
                // Their middles are inside.
                new Light.Sphere(ExactPoint.of(0, 0, 0), 1.1, DisplayRgb.WHITE),
                new Light.Sphere(ExactPoint.of(0.5, 0, 0), 0.6, DisplayRgb.WHITE),
                // A lamp on the ball.
                new Light.Point(ExactPoint.of(0, 1, 0), DisplayRgb.WHITE),
                rectangle(0.8));
        for (Light light : lights) {
            assertEquals(List.of(), hints(withBallAnd(WHITE, light)), light.toString());
        }
    }

    private static Light rectangle(double half) {
        return new Light.Rectangle(
                ExactPoint.of(-half, -half, 0),
                ExactPoint.of(-half, half, 0),
                ExactPoint.of(half, half, 0),
                ExactPoint.of(half, -half, 0),
                DisplayRgb.WHITE);
    }

    private static Scene.Builder withBallAnd(Material material, Light light) {
        return from(-5).object(BALL, material).light(LAMP).light(light);
    }

    @Test
    void anAngleInRadiansIsTooNarrow() {
        Rectangle wall = new Rectangle(
                ExactPoint.of(-9, -9, 2), ExactPoint.of(-9, 9, 2), ExactPoint.of(9, 9, 2), ExactPoint.of(9, -9, 2));
        for (double angle : new double[] {0.6, 0.999, 1e-9, 1e-300}) {
            Scene.Builder narrow =
                    view(new Camera.Perspective(ExactPoint.of(0, 0, -5), ExactPoint.of(0, 0, 0), Vec3.Y, angle));
            assertEquals(List.of(NARROW), hints(narrow.object(wall, WHITE)), "" + angle);
        }
        Scene.Builder wide =
                view(new Camera.Perspective(ExactPoint.of(0, 0, -5), ExactPoint.of(0, 0, 0), Vec3.Y, 1.001));
        assertEquals(List.of(), hints(wide.object(wall, WHITE)));
    }

    @Test
    void aTelescopeMakesSense() {
        // 2 arctan(1.1 / 1000) is 0.126 degrees: the ball of radius 1 just fits.
        Camera telescope = new Camera.Perspective(ExactPoint.of(0, 0, -1000), ExactPoint.of(0, 0, 0), Vec3.Y, 0.14);
        assertEquals(List.of(), hints(view(telescope)));
        Camera tooNear = new Camera.Perspective(ExactPoint.of(0, 0, -1000), ExactPoint.of(0, 0, 0), Vec3.Y, 0.10);
        assertEquals(List.of(NARROW), hints(view(tooNear)));
        // Seen past the ball, and away from it.
        Camera past = new Camera.Perspective(ExactPoint.of(0, 0, -1000), ExactPoint.of(9, 0, 0), Vec3.Y, 0.14);
        assertEquals(List.of(NARROW), hints(view(past)));
        Camera away = new Camera.Perspective(ExactPoint.of(0, 0, -1000), ExactPoint.of(0, 0, -2000), Vec3.Y, 0.14);
        assertEquals(List.of(NARROW), hints(view(away)));
    }

    @Test
    void parallelRaysHaveNoAngle() {
        Camera flat = new Camera.Orthographic(ExactPoint.of(0, 0, -5), ExactPoint.of(0, 0, 0), Vec3.Y, 0.001);
        assertEquals(List.of(), hints(view(flat)));
        assertEquals(List.of(), hints(view(new Camera.Isometric(ExactPoint.of(0, 0, 0), 0.001))));
    }

    /** The ball fills three quarters of the picture's height each time; only the distance grows. */
    @Test
    void viewsThatDirectionsAreTooCoarseForGetAHint() {
        for (int e : new int[] {3, 6, 9, 11, 13, 16, 20}) {
            double distance = Double.parseDouble("1e" + e);
            double degrees = 2 * 180 / Math.PI * 1.33 / distance;
            ExactPoint oblique = ExactPoint.of(0.3 * distance, 0.5 * distance, -distance);
            ExactPoint straight = ExactPoint.of(0, 0, -distance);
            boolean coarse = e > 14;
            for (ExactPoint eye : new ExactPoint[] {oblique, straight}) {
                boolean expected = coarse && eye == oblique;
                List<String> seen = hints(view(new Camera.Perspective(eye, ExactPoint.of(0, 0, 0), Vec3.Y, degrees)));
                assertEquals(expected, seen.stream().anyMatch(DISTANT), "1e" + e + " from " + eye + ": " + seen);
                List<String> flat = hints(view(new Camera.Orthographic(eye, ExactPoint.of(0, 0, 0), Vec3.Y, 2.67)));
                assertEquals(expected, flat.stream().anyMatch(DISTANT), "1e" + e + " flat from " + eye + ": " + flat);
            }
        }
    }

    private static Scene.Builder view(Camera camera) {
        return Scene.builder().size(8, 8).camera(camera).object(BALL, WHITE).light(LAMP);
    }

    private static Scene.Builder from(double z) {
        return Scene.builder()
                .size(8, 8)
                .camera(new Camera.Perspective(ExactPoint.of(0, 0, z), ExactPoint.of(0, 0, 0), Vec3.Y, 40));
    }

    private static List<String> hints(Scene.Builder scene) {
        return hints(scene.build());
    }

    private static List<String> hints(Scene scene) {
        return SceneHints.of(scene, SceneCompiler.compile(scene, RenderSettings.of(scene)));
    }
}
