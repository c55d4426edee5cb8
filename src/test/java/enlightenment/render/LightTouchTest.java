package enlightenment.render;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.camera.Camera;
import enlightenment.color.DisplayRgb;
import enlightenment.geometry.Box;
import enlightenment.geometry.Rectangle;
import enlightenment.geometry.Sphere;
import enlightenment.light.Light;
import enlightenment.math.ExactPoint;
import enlightenment.math.Vec3;
import enlightenment.scene.Scene;
import enlightenment.scene.Shading;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Lights that touch, cut or enclose what they light (numerics, N32). */
class LightTouchTest {
    private static final Rectangle FLOOR = TestScenes.rectangle(-9, 0, -9, -9, 0, 9, 9, 0, 9, 9, 0, -9);

    private static Scene.Builder floor(Camera camera) {
        return Scene.builder()
                .size(32, 32)
                .camera(camera)
                .shading(new Shading.Classic(0, 0.5, DisplayRgb.BLACK, 10))
                .object(FLOOR, TestScenes.matte(1, 1, 1));
    }

    private static Light ball(double height, double radius) {
        return new Light.Sphere(ExactPoint.of(0, height, 0), radius, DisplayRgb.WHITE);
    }

    @ParameterizedTest
    @ValueSource(doubles = {0.5, 0.4999999999999999, 0.5000000000000001, 0.3, 0, -0.3, -0.4999999999999999, -0.5})
    void aBallOfLightAtAnyHeightGivesNothingNegativeOrInfinite(double height) {
        Camera[] cameras = {
            new Camera.Perspective(ExactPoint.of(0.5, 3, -4), ExactPoint.of(0, 0, 0), Vec3.Y, 40),
            // Within the light, and within a hair of the place where it touches the floor.
            new Camera.Perspective(ExactPoint.of(0.01, 0.2, 0.02), ExactPoint.of(0, 0, 0), Vec3.Z, 120),
            new Camera.Perspective(ExactPoint.of(-1e-6, 1e-13, 0), ExactPoint.of(1e-6, 0, 0), Vec3.Y, 90),
            // From below the floor.
            new Camera.Perspective(ExactPoint.of(0.5, -3, -4), ExactPoint.of(0, 0, 0), Vec3.Y, 40)
        };
        for (Camera camera : cameras) {
            for (double shadow : new double[] {0, 0.5, 1}) {
                Scene scene = floor(camera)
                        .shading(new Shading.Classic(0, shadow, DisplayRgb.BLACK, 10))
                        .object(Sphere.of(ExactPoint.of(0.9, 0.2, 0.1), 0.2), TestScenes.matte(1, 1, 1))
                        .light(ball(height, 0.5))
                        .build();
                DoublePicture p = DoublePicture.of(scene, 2, 16);
                assertTrue(p.isFinite(), height + " " + camera);
                assertTrue(p.least() >= 0 && p.greatest() <= 1 + 1e-12, height + " " + camera + " " + p.least());
            }
        }
    }

    @Test
    void aHalfSunkBallLightsTheFloorByTheClosedForm() {
        // The cone of half angle θ around the horizon: the mean of max(cos, 0) over it is
        // (θ − sinθ cosθ)/(2π(1 − cosθ)); its standard deviation is less than sinθ/2.
        int samples = 4096;
        for (double distance : new double[] {0.50001, 0.51, 0.7, 1.5, 5}) {
            double sine = 0.5 / distance;
            double cosine = Math.sqrt((1 - sine) * (1 + sine));
            double expected = (Math.asin(sine) - sine * cosine) / (2 * Math.PI * (1 - cosine));
            Camera above =
                    new Camera.Orthographic(ExactPoint.of(distance, 4, 0), ExactPoint.of(distance, 0, 0), Vec3.Z, 1e-9);
            DoublePicture p =
                    DoublePicture.of(floor(above).size(1, 1).light(ball(0, 0.5)).build(), 1, samples);
            assertEquals(expected, p.at(0, 0, 0), 4 * sine / 2 / Math.sqrt(samples), "distance " + distance);
        }
    }

    @Test
    void aBallThatTouchesTheFloorLightsItByTheClosedForm() {
        // Wholly above the horizon: (n·w)(1 + cosθ)/2, exactly.
        for (double x : new double[] {1e-3, 0.1, 0.5, 2, 8}) {
            double distance = Math.hypot(x, 0.5);
            double cosine = x / distance;
            double expected = 0.5 / distance * (1 + cosine) / 2;
            // From below the light's middle, so that the light does not stand in the way.
            Camera camera = new Camera.Orthographic(
                    ExactPoint.of(x + 0.25 * x, 0.25 * x * x, 0), ExactPoint.of(x, 0, 0), Vec3.Y, 1e-12);
            DoublePicture p = DoublePicture.of(
                    floor(camera).size(1, 1).light(ball(0.5, 0.5)).build(), 1, 4096);
            // Rounding may put the light's edge below the horizon; then the mean is sampled.
            assertEquals(expected, p.at(0, 0, 0), 4 * 0.5 / 64, "x = " + x);
        }
    }

    @Test
    void aRectangleOfLightInTheLitPlaneGivesExactlyNothing() {
        Rectangle[] planes = {
            FLOOR,
            TestScenes.rectangle(-9, -9, 0.1, -9, 9, 0.1, 9, 9, 0.1, 9, -9, 0.1),
            TestScenes.rectangle(0.7, -9, -9, 0.7, 9, -9, 0.7, 9, 9, 0.7, -9, 9)
        };
        double[][] lights = {
            {2, 0, 1, 2, 0, 2, 3, 0, 2, 3, 0, 1},
            {2, 1, 0.1, 2, 2, 0.1, 3, 2, 0.1, 3, 1, 0.1},
            {0.7, 2, 1, 0.7, 2, 2, 0.7, 3, 2, 0.7, 3, 1}
        };
        for (int i = 0; i < planes.length; i++) {
            Rectangle l = TestScenes.rectangle(lights[i]);
            Scene scene = Scene.builder()
                    .size(32, 32)
                    .camera(new Camera.Perspective(ExactPoint.of(-5.1, 4.3, -6.7), ExactPoint.of(0, 0, 0), Vec3.Y, 30))
                    .shading(new Shading.Classic(0, 0.5, DisplayRgb.BLACK, 10))
                    .object(planes[i], TestScenes.matte(1, 1, 1))
                    .light(new Light.Rectangle(
                            l.lowerLeft(), l.upperLeft(), l.upperRight(), l.lowerRight(), DisplayRgb.WHITE))
                    .build();
            DoublePicture p = DoublePicture.of(scene, 2, 16);
            assertEquals(0, p.least(), "plane " + i);
            // The light itself is seen: by none, some or all of the four rays of a pixel.
            for (double v : p.toArray()) {
                assertEquals(Math.rint(4 * v), 4 * v, "plane " + i);
            }
        }
    }

    @Test
    void aRectangleOfLightInALeaningPlaneGivesRoundingErrorAtMost() {
        Vec3 right = new Vec3(0.9, 0.1, 0.3);
        Vec3 up = new Vec3(-0.2, 0.7, 0.4);
        ExactPoint corner = ExactPoint.of(-0.4, -0.3, 0.2);
        ExactPoint far = corner.plus(right.times(2.5));
        Scene scene = Scene.builder()
                .size(32, 32)
                .camera(new Camera.Perspective(ExactPoint.of(0.1, 0.3, -6.7), ExactPoint.of(0, 0, 0), Vec3.Y, 10))
                .shading(new Shading.Classic(0, 0.5, DisplayRgb.BLACK, 10))
                .object(
                        new Rectangle(corner, corner.plus(up), corner.plus(up).plus(right), corner.plus(right)),
                        TestScenes.matte(1, 1, 1))
                .light(new Light.Rectangle(
                        far, far.plus(up), far.plus(up).plus(right), far.plus(right), DisplayRgb.WHITE))
                .build();
        DoublePicture p = DoublePicture.of(scene, 2, 16);
        assertTrue(p.least() >= 0 && p.greatest() <= 1e-14, p.greatest() + "");
    }

    @Test
    void aLightAroundEverythingGivesAQuarterToTheOpenFloor() {
        Camera camera = new Camera.Perspective(ExactPoint.of(0.5, 3, -4), ExactPoint.of(0, 0, 0), Vec3.Y, 40);
        Light around = new Light.Sphere(ExactPoint.of(0.3, 0.7, -0.2), 40, DisplayRgb.WHITE);
        DoublePicture open = DoublePicture.of(floor(camera).light(around).build(), 1, 256);
        double sum = 0;
        for (int i = 0; i < 32 * 32; i++) {
            sum += open.at(i % 32, i / 32, 0);
        }
        double deviation = Math.sqrt(1.0 / 6 - 1.0 / 16);
        assertEquals(0.25, sum / 1024, 4 * deviation / Math.sqrt(1024 * 256));
        Scene withBox = floor(camera)
                .object(new Box(ExactPoint.of(-0.5, 0, -0.5), ExactPoint.of(0.5, 1, 0.5)), TestScenes.matte(1, 1, 1))
                .light(around)
                .build();
        DoublePicture shaded = DoublePicture.of(withBox, 1, 256);
        assertTrue(shaded.isFinite() && shaded.least() >= 0 && shaded.greatest() <= 1);
    }

    @Test
    void aPointOfLightOnTheSurfaceGivesAFinitePicture() {
        Camera camera = new Camera.Perspective(ExactPoint.of(0.5, 3, -4), ExactPoint.of(0, 0, 0), Vec3.Y, 40);
        for (double height : new double[] {0, Double.MIN_VALUE, 1e-300, 1e-17, -1e-17}) {
            Scene scene = floor(camera)
                    .light(new Light.Point(ExactPoint.of(0, height, 0), DisplayRgb.WHITE))
                    .build();
            DoublePicture p = DoublePicture.of(scene, 2, 1);
            assertTrue(p.isFinite() && p.least() >= 0 && p.greatest() <= 1);
        }
    }
}
