package enlightenment.render;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.camera.Camera;
import enlightenment.color.DisplayRgb;
import enlightenment.geometry.Box;
import enlightenment.geometry.Cone;
import enlightenment.geometry.Cylinder;
import enlightenment.geometry.Shape;
import enlightenment.geometry.Sphere;
import enlightenment.light.Light;
import enlightenment.material.Glass;
import enlightenment.material.Material;
import enlightenment.material.Texture;
import enlightenment.math.ExactPoint;
import enlightenment.math.Vec3;
import enlightenment.scene.Scene;
import enlightenment.scene.Shading;
import org.junit.jupiter.api.Test;

/** No light leaks in where things touch the floor (numerics, N21). */
class ContactTest {
    private static final double AMBIENT = 0.125;
    private static final Shape FLOOR = TestScenes.rectangle(-9, 0, -9, -9, 0, 9, 9, 0, 9, 9, 0, -9);

    /** A thing on the floor y = 0, lit from right above, and what a camera sees at its contact near the origin. */
    private static DoublePicture picture(Shape thing, Camera camera, Light light) {
        Scene scene = Scene.builder()
                .size(48, 32)
                .camera(camera)
                .shading(new Shading.Classic(AMBIENT, 0, DisplayRgb.BLACK, 10))
                .object(thing, TestScenes.matte(1, 1, 1))
                .object(FLOOR, TestScenes.matte(1, 1, 1))
                .light(light)
                .build();
        return DoublePicture.of(scene, 2, 16);
    }

    @Test
    void underASphereThatTouchesTheFloorThereIsAmbientLightOnly() {
        Light point = new Light.Point(ExactPoint.of(0, 8, 0), DisplayRgb.WHITE);
        for (double h : new double[] {1e-1, 1e-2, 1e-4, 1e-6, 1e-9, 1e-12}) {
            // Within the wedge between floor and sphere, four times h from the contact, where it is 8h² high.
            Camera camera = new Camera.Perspective(
                    ExactPoint.of(-4 * h, 4 * h * h, 0), ExactPoint.of(0, 4 * h * h, 0), Vec3.Y, 50);
            DoublePicture p = picture(Sphere.of(ExactPoint.of(0, 1, 0), 1), camera, point);
            assertEquals(AMBIENT, p.least(), "h = " + h);
            assertEquals(AMBIENT, p.greatest(), "h = " + h);
        }
    }

    @Test
    void theContactHasNoLightPixelsUnderAWideLightEither() {
        Light ball = new Light.Sphere(ExactPoint.of(0, 8, 0), 1, DisplayRgb.WHITE);
        for (double h : new double[] {1e-1, 1e-3, 1e-6, 1e-9}) {
            Camera camera = new Camera.Perspective(
                    ExactPoint.of(-4 * h, 4 * h * h, 0), ExactPoint.of(0, 4 * h * h, 0), Vec3.Y, 50);
            DoublePicture p = picture(Sphere.of(ExactPoint.of(0, 1.0, 0), 1), camera, ball);
            assertTrue(p.greatest() <= AMBIENT + 1e-12, "h = " + h + ": " + p.greatest());
        }
    }

    @Test
    void theFloorUnderAGlassSolidThatStandsOnItIsDark() {
        // Classic glass throws full shadows; seen through it, the floor below shows ambient light and nothing else.
        Shape[] things = {
            new Box(ExactPoint.of(-1, 0, -1), ExactPoint.of(1, 0.5, 1)),
            new Cylinder(ExactPoint.of(0, 0, 0), ExactPoint.of(0, 0.5, 0), 1, true),
            new Cylinder(ExactPoint.of(0, 0.5, 0), ExactPoint.of(0, 0, 0), 1, true),
            new Cone(ExactPoint.of(0, 0, 0), ExactPoint.of(0, 0.5, 0), 1, 0.9, true),
            new Cone(ExactPoint.of(0, 0.5, 0), ExactPoint.of(0, 0, 0), 1, 0.9, true)
        };
        Camera above = new Camera.Perspective(ExactPoint.of(0.03, 6, -0.07), ExactPoint.of(0, 0, 0), Vec3.Z, 9);
        Material glass = Glass.of(Texture.of(DisplayRgb.WHITE), 1.5);
        for (Shape thing : things) {
            Scene scene = Scene.builder()
                    .size(64, 64)
                    .camera(above)
                    .shading(new Shading.Classic(AMBIENT, 0, DisplayRgb.BLACK, 10))
                    .object(thing, glass)
                    .object(FLOOR, TestScenes.matte(1, 1, 1))
                    .light(new Light.Point(ExactPoint.of(0, 8, 0), DisplayRgb.WHITE))
                    .build();
            DoublePicture p = DoublePicture.of(scene, 2, 1);
            assertEquals(AMBIENT, p.least(), thing.toString());
            assertEquals(AMBIENT, p.greatest(), thing.toString());
        }
    }
}
