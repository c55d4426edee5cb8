package enlightenment.render;

import static org.junit.jupiter.api.Assertions.assertEquals;

import enlightenment.camera.Camera;
import enlightenment.color.DisplayRgb;
import enlightenment.geometry.Rectangle;
import enlightenment.light.Light;
import enlightenment.material.Glass;
import enlightenment.material.Material;
import enlightenment.material.Texture;
import enlightenment.math.ExactPoint;
import enlightenment.math.Vec3;
import enlightenment.scene.Scene;
import enlightenment.scene.Shading;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Two mirrors that face each other (numerics, N28). */
class MirrorHallTest {
    private static Rectangle panel(double z, double half) {
        return TestScenes.rectangle(-half, -half, z, -half, half, z, half, half, z, half, -half, z);
    }

    private static Camera straightAhead(double fieldOfView) {
        return new Camera.Perspective(ExactPoint.of(0, 0, 0), ExactPoint.of(0, 0, 1), Vec3.Y, fieldOfView);
    }

    @ParameterizedTest
    @CsvSource({
        "1, 0.5, 0.25",
        "10, 0.5, 0.25",
        "1000, 0.5, 0.25",
        "1000000, 0.5, 0.25",
        "1, 1, 0.25",
        "10, 1, 0.25",
        "1000, 1, 0.0009765625",
        "1000000, 1, 0.00000095367431640625"
    })
    void aPaneBetweenThemAddsAGeometricSeries(int limit, double reflectance, double opaque) {
        // The path meets pane, mirror, pane, mirror, ...: pane k (from 0) adds opaque · q^k, q = (1 - opaque) · r.
        // Panes are no bounces: after `limit` mirrors one more pane is seen.
        Material pane = new Glass(Texture.of(DisplayRgb.WHITE), 1.5, 1 - opaque, 0, true);
        Scene scene = Scene.builder()
                .size(2, 2)
                .camera(straightAhead(1e-7))
                .shading(new Shading.Classic(1, 1, DisplayRgb.BLACK, limit))
                .object(panel(2, 9), pane)
                .object(panel(4, 9), TestScenes.mirror(reflectance))
                .object(panel(-4, 9), TestScenes.mirror(reflectance))
                .build();
        double q = (1 - opaque) * reflectance;
        int panes = limit + 1;
        double expected = opaque * -StrictMath.expm1(panes * StrictMath.log(q)) / (1 - q);
        DoublePicture p = DoublePicture.of(scene, 1, 1);
        assertEquals(expected, p.least(), 1e-12);
        assertEquals(expected, p.greatest(), 1e-12);
    }

    @ParameterizedTest
    @ValueSource(ints = {1, 10, 1000, 100_001, 999_999})
    void perfectMirrorsShowTheEmitterAtTheEndOfTheHallUndimmed(int bounces) {
        // The ray rises by slope per unit and the mirrors are 8 apart, so after n bounces it is at (8n - 4)·slope: over
        // the top of mirrors that end half a step above that, and into a ceiling of light beyond.
        double slope = 1e-4;
        double top = 8 * bounces * slope;
        double beyond = 8 * (bounces + 3) * slope;
        Light emitter = new Light.Rectangle(
                ExactPoint.of(-9, top, -5),
                ExactPoint.of(-9, top, 5),
                ExactPoint.of(9, top, 5),
                ExactPoint.of(9, top, -5),
                DisplayRgb.WHITE);
        for (int limit : new int[] {bounces - 1, bounces, 1_000_000}) {
            Scene scene = Scene.builder()
                    .size(1, 1)
                    .camera(new Camera.Perspective(ExactPoint.of(0, 0, 0), ExactPoint.of(0, slope, 1), Vec3.Y, 1e-12))
                    .shading(new Shading.Classic(0, 1, DisplayRgb.BLACK, limit))
                    .object(
                            TestScenes.rectangle(-9, -9, 4, -9, beyond, 4, 9, beyond, 4, 9, -9, 4),
                            TestScenes.mirror(1))
                    .object(
                            TestScenes.rectangle(-9, -9, -4, -9, beyond, -4, 9, beyond, -4, 9, -9, -4),
                            TestScenes.mirror(1))
                    .light(emitter)
                    .build();
            DoublePicture p = DoublePicture.of(scene, 1, 1);
            assertEquals(limit < bounces ? 0 : 1, p.at(0, 0, 0), 0, "limit " + limit);
        }
    }

    @Test
    void halfMirrorsDimTheEmitterByThePowerOfTheirReflectance() {
        double slope = 0x1p-7;
        for (int bounces = 1; bounces < 60; bounces++) {
            double top = 8 * bounces * slope;
            Scene scene = Scene.builder()
                    .size(1, 1)
                    .camera(new Camera.Perspective(ExactPoint.of(0, 0, 0), ExactPoint.of(0, slope, 1), Vec3.Y, 1e-9))
                    .shading(new Shading.Classic(0, 1, DisplayRgb.BLACK, 100))
                    .object(panel(4, 9), TestScenes.mirror(0.5))
                    .object(panel(-4, 9), TestScenes.mirror(0.5))
                    .light(new Light.Rectangle(
                            ExactPoint.of(-8, top, -5),
                            ExactPoint.of(-8, top, 5),
                            ExactPoint.of(8, top, 5),
                            ExactPoint.of(8, top, -5),
                            DisplayRgb.WHITE))
                    .build();
            assertEquals(
                    Math.scalb(1.0, -bounces), DoublePicture.of(scene, 1, 1).at(0, 0, 0), 0);
        }
    }
}
