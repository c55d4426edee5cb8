package enlightenment.render;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.camera.Camera;
import enlightenment.color.DisplayRgb;
import enlightenment.geometry.Cube;
import enlightenment.geometry.Shape;
import enlightenment.geometry.Sphere;
import enlightenment.geometry.Torus;
import enlightenment.light.Light;
import enlightenment.material.Glass;
import enlightenment.material.Material;
import enlightenment.material.Texture;
import enlightenment.math.ExactPoint;
import enlightenment.math.Vec3;
import enlightenment.scene.Scene;
import enlightenment.scene.Shading;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Interfaces that bend nothing are no bounces: glass may be cut up as one likes. */
class StraightGlassTest {
    private static Material glass(double ior, int priority) {
        return new Glass(Texture.of(DisplayRgb.WHITE), ior, 1, priority, true);
    }

    private static Scene.Builder room(int maxBounces) {
        return Scene.builder()
                .size(20, 16)
                .camera(new Camera.Perspective(ExactPoint.of(0.2, 0.3, -6), ExactPoint.of(0.1, 0, 0), Vec3.Y, 34))
                .shading(new Shading.Classic(0.3, 1, DisplayRgb.WHITE, maxBounces))
                .object(
                        TestScenes.rectangle(-4, -4, 4, -4, 4, 4, 4, 4, 4, 4, -4, 4),
                        Material.Matte.of(
                                new Texture.Checker(List.of(DisplayRgb.WHITE, new DisplayRgb(0.2, 0.4, 0.6)), 9)))
                .light(new Light.Point(ExactPoint.of(-3, 4, -5), DisplayRgb.WHITE));
    }

    private static DoublePicture picture(Scene.Builder scene) {
        return DoublePicture.of(scene.build(), 1, 1);
    }

    private static Shape ball(double radius) {
        return Sphere.of(ExactPoint.of(0, 0, 0), radius);
    }

    @ParameterizedTest
    @ValueSource(ints = {2, 50, 51, 52, 200})
    void nestedBallsOfOneIndexAreOneBall(int n) {
        for (int maxBounces : new int[] {100, 2}) {
            DoublePicture one = picture(room(maxBounces).object(ball(1.4), glass(1.5, 0)));
            assertTrue(one.least() > 0);
            Scene.Builder nested = room(maxBounces);
            for (int i = 0; i < n; i++) {
                nested.object(ball(1.4 * (n - i) / n), glass(1.5, i % 3));
            }
            assertEquals(0, picture(nested).difference(one), 1e-9, n + " balls, " + maxBounces + " bounces");
        }
    }

    /** Balls that bend are counted still: in and out again, and no path has more than it may. */
    @Test
    void interfacesThatRefractAreBounces() {
        Scene.Builder tooMany = room(1).object(ball(1.4), glass(1.5, 0));
        assertEquals(0, picture(tooMany).at(10, 8, 0));
    }

    @Test
    void manyThingsOfIndexOneAreNothing() {
        DoublePicture nothing = picture(room(0));
        Scene.Builder many = room(0);
        for (int i = 1; i <= 60; i++) {
            double z = -3 + i / 10.0;
            many.object(TestScenes.rectangle(-4, -4, z, -4, 4, z, 4, 4, z, 4, -4, z), glass(1.5, 0));
            many.object(
                    new Cube(ExactPoint.of(0.3, 0.1, z / 3), 0.3 + i / 50.0, new Vec3(i, 2 * i, 20)), glass(1, i % 4));
            many.object(
                    new Torus(ExactPoint.of(0, 0, z / 2), new Vec3(0.1, 1, i / 30.0), 0.8, 0.3 + i / 200.0),
                    glass(1, i % 5));
        }
        assertEquals(0, picture(many).difference(nothing), 1e-9);
    }

    /** Whatever rounding does to interfaces in one place, paths end. */
    @Test
    void coincidentInterfacesEnd() {
        Scene.Builder scene = room(3);
        for (int i = 0; i < 40; i++) {
            double radius = 1.2 * (1 + (i - 20) * 0x1p-52);
            scene.object(Sphere.of(ExactPoint.of(0, 0, 0), radius), glass(i % 2 == 0 ? 1.5 : 1.5 + 0x1p-52, i % 3));
        }
        assertTrue(picture(scene).isFinite());
    }
}
