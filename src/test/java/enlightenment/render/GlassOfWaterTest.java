package enlightenment.render;

import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.camera.Camera;
import enlightenment.color.DisplayRgb;
import enlightenment.geometry.Cylinder;
import enlightenment.geometry.Sphere;
import enlightenment.light.Light;
import enlightenment.material.Glass;
import enlightenment.material.Material;
import enlightenment.material.Texture;
import enlightenment.math.ExactPoint;
import enlightenment.math.Vec3;
import enlightenment.scene.Scene;
import enlightenment.scene.Shading;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Water in a glass, whose wall is the same surface up to an ulp (numerics, N23). */
class GlassOfWaterTest {
    private static final double INNER = 0.9;

    /** How the glass stands: where its bottom's middle is, and the vector from there to the middle of its rim. */
    private enum Stand {
        UPRIGHT(new Vec3(0, 2, 0)),
        LEANING(new Vec3(0.5, 1.8, -0.4));

        final Vec3 axis;

        Stand(Vec3 axis) {
            this.axis = axis;
        }

        ExactPoint at(double height) {
            return ExactPoint.of(0.1, -1, 0.2).plus(axis.times(height));
        }
    }

    private static Material glass(double ior, int priority, DisplayRgb color) {
        return new Glass(Texture.of(color), ior, 1, priority, true);
    }

    /** Smooth light without shadows from outside and a room without edges but for one ball. */
    private static Scene.Builder room(double eyeHeight, int size) {
        return Scene.builder()
                .size(size, size)
                .camera(new Camera.Perspective(
                        ExactPoint.of(0.31, eyeHeight, -5.13), ExactPoint.of(0.12, 0.01, 0.2), Vec3.Y, 32))
                .shading(new Shading.Classic(0.25, 1, DisplayRgb.BLACK, 100_000))
                .object(Sphere.of(ExactPoint.of(0.2, -0.1, 0.3), 12), TestScenes.matte(0.9, 0.8, 0.7))
                .object(Sphere.of(ExactPoint.of(0.3, 0.4, 3.5), 0.9), TestScenes.matte(0.3, 0.9, 0.5))
                .light(new Light.Point(ExactPoint.of(2.5, 4.5, -4.5), DisplayRgb.WHITE))
                .light(new Light.Point(ExactPoint.of(-3.5, -2.5, 1.5), new DisplayRgb(0.9, 0.5, 0.7)));
    }

    /** A solid glass, in it the air that it holds, and in that the water: 80 % of the height of the air. */
    private static Scene full(Stand stand, double waterRadius, double eyeHeight, int size) {
        return room(eyeHeight, size)
                .object(new Cylinder(stand.at(0), stand.at(1), 1, true), glass(1.5, 0, new DisplayRgb(0.95, 1, 0.95)))
                .object(new Cylinder(stand.at(0.1), stand.at(1.05), INNER, true), glass(1, 1, DisplayRgb.WHITE))
                .object(
                        new Cylinder(stand.at(0.1), stand.at(0.8), waterRadius, true),
                        glass(1.33, 2, new DisplayRgb(0.9, 0.95, 1)))
                .build();
    }

    private static void compare(Stand stand, double eyeHeight, int size) {
        DoublePicture same = DoublePicture.of(full(stand, INNER, eyeHeight, size), 1, 1);
        DoublePicture larger = DoublePicture.of(full(stand, Math.nextUp(INNER), eyeHeight, size), 1, 1);
        DoublePicture smaller = DoublePicture.of(full(stand, Math.nextDown(INNER), eyeHeight, size), 1, 1);
        assertTrue(same.isFinite() && same.least() >= 0);
        String where = stand + " from " + eyeHeight;
        assertTrue(same.shareBeyond(larger, 1e-6) <= 0.001, where + ": " + same.shareBeyond(larger, 1e-6));
        assertTrue(same.shareBeyond(smaller, 1e-6) <= 0.001, where + ": " + same.shareBeyond(smaller, 1e-6));
        // With a radius that is larger by far more than an ulp no surfaces coincide: that is the true picture.
        DoublePicture clear = DoublePicture.of(full(stand, INNER * (1 + 1e-9), eyeHeight, size), 1, 1);
        assertTrue(same.shareBeyond(clear, 1e-5) <= 0.002, where + ": " + same.shareBeyond(clear, 1e-5));
        DoublePicture dry = DoublePicture.of(full(stand, INNER / 2, eyeHeight, size), 1, 1);
        assertTrue(same.shareBeyond(dry, 1e-2) > 0.05, "the water is seen");
    }

    @ParameterizedTest
    @ValueSource(doubles = {0.47, 3.1})
    void anUlpOfWaterRadiusDoesNotMatter(double eyeHeight) {
        for (Stand stand : Stand.values()) {
            compare(stand, eyeHeight, 96);
        }
    }

    @ParameterizedTest
    @ValueSource(doubles = {0.47, 1.3, 3.1, -0.9})
    @org.junit.jupiter.api.Tag("full")
    void anUlpOfWaterRadiusDoesNotMatterInLargePictures(double eyeHeight) {
        for (Stand stand : Stand.values()) {
            compare(stand, eyeHeight, 512);
        }
    }
}
