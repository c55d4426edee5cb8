package enlightenment.physical;

import static enlightenment.physical.PhysicalScenes.at;
import static enlightenment.physical.PhysicalScenes.matte;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.camera.Camera;
import enlightenment.color.Rgb;
import enlightenment.light.Emission;
import enlightenment.light.Light;
import enlightenment.math.Vec3;
import enlightenment.render.TestScenes;
import enlightenment.scene.Scene;
import enlightenment.scene.Shading;

/** A floor that reflects half of its light, a small part of which is all that is seen, and what it shows under a point light. */
final class GreyFloor {
    private static final double HALF = 0.5;

    /** Of the part that is seen. */
    private static final double SIDE = 0.6;

    private static final double INTENSITY = 5;
    private static final double HEIGHT = 2;

    private GreyFloor() {}

    /**
     * @param eye height above the floor from which it is seen
     * @param extent from the middle to the edges
     */
    static Scene.Builder scene(double eye, double extent, Shading.Physical shading) {
        double e = extent;
        return Scene.builder()
                .size(4, 4)
                .camera(new Camera.Orthographic(at(0, eye, 0), at(0, 0, 0), Vec3.Z, SIDE))
                .shading(shading)
                .object(TestScenes.rectangle(-e, 0, -e, -e, 0, e, e, 0, e, e, 0, -e), matte(HALF, HALF, HALF));
    }

    /** Above the middle. */
    static Light point() {
        return new Light.Point(at(0, HEIGHT, 0), Rgb.WHITE, Emission.intensity(Rgb.gray(INTENSITY)));
    }

    /** What the floor shows under that light alone, in the mean over the picture: E = I cos³/h², of which it shows a share over π. */
    static double belowPoint() {
        int n = 100;
        double sum = 0;
        for (int i = 0; i < n * n; i++) {
            double x = SIDE * ((i / n + 0.5) / n - 0.5);
            double z = SIDE * ((i % n + 0.5) / n - 0.5);
            sum += Math.pow(1 + (x * x + z * z) / (HEIGHT * HEIGHT), -1.5);
        }
        return HALF / Math.PI * INTENSITY / (HEIGHT * HEIGHT) * sum / (n * n);
    }

    /** @param noise the most that the standard error may be of what is expected */
    static void assertSame(String what, Statistics found, Statistics expected, double noise) {
        double error = Math.hypot(found.error(), expected.error());
        assertTrue(error < noise * expected.mean(), what + ": too noisy to tell, " + error + " of " + expected.mean());
        assertEquals(expected.mean(), found.mean(), 6 * error + 0.002 * expected.mean(), what);
    }
}
