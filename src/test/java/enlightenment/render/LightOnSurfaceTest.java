package enlightenment.render;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.camera.Camera;
import enlightenment.color.DisplayRgb;
import enlightenment.frame.Rotation;
import enlightenment.geometry.Box;
import enlightenment.geometry.Cube;
import enlightenment.geometry.Cylinder;
import enlightenment.geometry.Rectangle;
import enlightenment.geometry.Shape;
import enlightenment.geometry.Sphere;
import enlightenment.geometry.Torus;
import enlightenment.light.Light;
import enlightenment.math.ExactPoint;
import enlightenment.math.Vec3;
import enlightenment.scene.Scene;
import enlightenment.scene.SceneObject;
import enlightenment.scene.Shading;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;

/**
 * A light that lies on a surface shines away from it, whatever rounding says about which of the two comes first. The truth is
 * the same light a hair in front of the surface.
 */
class LightOnSurfaceTest {
    private static final SceneObject FLOOR =
            SceneObject.of(TestScenes.rectangle(-9, -1, -9, -9, -1, 9, 9, -1, 9, 9, -1, -9), TestScenes.matte(1, 1, 1));
    private static final SceneObject BALL =
            SceneObject.of(Sphere.of(ExactPoint.of(0.4, -0.5, 0.3), 0.5), TestScenes.matte(1, 0.8, 0.6));
    private static final Vec3 TURN = new Vec3(31, 17, 7);
    private static final double HAIR = 1e-9;

    private interface Lifted {
        Light by(double y);
    }

    private static DoublePicture picture(Light light, List<SceneObject> objects, int scale) {
        Scene.Builder b = Scene.builder()
                .size(64, 64)
                .camera(new Camera.Perspective(
                        ExactPoint.of(1.31, 1.47, -6.13), ExactPoint.of(0.1, 0.4, 0.2), Vec3.Y, 50))
                .shading(new Shading.Classic(0.1, 0, new DisplayRgb(0.4, 0.6, 0.8), 6))
                .light(light);
        objects.forEach(b::object);
        return DoublePicture.of(MovedScene.scaledByPowerOfTen(b.build(), scale), 1, 4);
    }

    private static void assertShines(String what, Shape carrier, Lifted light) {
        List<SceneObject> objects = List.of(FLOOR, BALL, SceneObject.of(carrier, TestScenes.matte(0.9, 0.9, 1)));
        for (int scale : new int[] {-7, 0, 3}) {
            DoublePicture on = picture(light.by(0), objects, scale);
            DoublePicture before = picture(light.by(HAIR), objects, scale);
            String where = what + " in 10^" + scale;
            assertTrue(on.shareBeyond(before, 1e-6) <= 0.002, where + ": " + on.shareBeyond(before, 1e-6));
            assertEquals(0, on.speckles(before), where);
        }
    }

    private static Light.Rectangle lamp(ExactPoint middle, Vec3 u, Vec3 v, double half) {
        return new Light.Rectangle(
                middle.plus(u.times(-half)).plus(v.times(-half)),
                middle.plus(u.times(-half)).plus(v.times(half)),
                middle.plus(u.times(half)).plus(v.times(half)),
                middle.plus(u.times(half)).plus(v.times(-half)),
                DisplayRgb.WHITE);
    }

    @Test
    void aLampInTheCeilingsPlaneLightsTheRoom() {
        Rectangle ceiling = TestScenes.rectangle(-9, 3, -9, -9, 3, 9, 9, 3, 9, 9, 3, -9);
        assertShines("ceiling", ceiling, y -> lamp(ExactPoint.of(0.3, 3 - y, 0.7), Vec3.X, Vec3.Z, 0.6));
    }

    @Test
    void aLampOnAFaceOfABoxOrOfALeaningCubeShines() {
        Box box = new Box(ExactPoint.of(-1, 1.7, 0), ExactPoint.of(1, 2.9, 2));
        assertShines("box", box, y -> lamp(ExactPoint.of(0.3, 1.7 - y, 0.7), Vec3.X, Vec3.Z, 0.4));
        assertShines("box, at its edge", box, y -> lamp(ExactPoint.of(0.6, 1.7 - y, 0.4), Vec3.X, Vec3.Z, 0.4));
        Vec3 u = Rotation.ofDegrees(TURN).axis(0);
        Vec3 v = Rotation.ofDegrees(TURN).axis(1);
        Vec3 n = Rotation.ofDegrees(TURN).axis(2).negated();
        ExactPoint o = ExactPoint.of(0.2, 2.1, 1.1);
        Cube cube = new Cube(o, 0.8 * Math.sqrt(3), TURN);
        assertShines("leaning cube", cube, y -> lamp(o.plus(n.times(0.8 + y)), u, v, 0.3));
        Cylinder post = new Cylinder(o, o.plus(n.times(0.9)), 0.5, true);
        assertShines("the end of a post", post, y -> lamp(o.plus(n.times(0.9 + y)), u, v, 0.2));
    }

    @Test
    void aLampOnALeaningWallShines() {
        Vec3 u = Rotation.ofDegrees(TURN).axis(0);
        Vec3 v = Rotation.ofDegrees(TURN).axis(1);
        Vec3 n = Rotation.ofDegrees(TURN).axis(2).negated();
        ExactPoint o = ExactPoint.of(0.2, 0.9, 2.1);
        Light.Rectangle all = lamp(o, u, v, 30);
        Rectangle wall = new Rectangle(all.lowerLeft(), all.upperLeft(), all.upperRight(), all.lowerRight());
        assertShines("leaning wall", wall, y -> lamp(o.plus(u.times(0.41)).plus(n.times(y)), u, v, 0.37));
    }

    @Test
    void aPointLightOnASurfaceShines() {
        Rectangle ceiling = TestScenes.rectangle(-9, 3, -9, -9, 3, 9, 9, 3, 9, 9, 3, -9);
        assertShines("ceiling", ceiling, y -> new Light.Point(ExactPoint.of(0.3, 3 - y, 0.7), DisplayRgb.WHITE));
        ExactPoint o = ExactPoint.of(0.2, 1.9, 0.6);
        Vec3 down = new Vec3(0.36, -0.8, -0.48);
        assertShines("ball", Sphere.of(o, 0.7), y -> new Light.Point(o.plus(down.times(0.7 + y)), DisplayRgb.WHITE));
        Vec3 across = new Vec3(0.8, 0.6, -0.4).cross(down).normalized();
        assertShines(
                "post",
                new Cylinder(o.plus(across.times(-1)), o.plus(across), 0.3, true),
                y -> new Light.Point(o.plus(down.times(0.3 + y)), DisplayRgb.WHITE));
        assertShines(
                "ring",
                new Torus(o, across, 0.8, 0.2),
                y -> new Light.Point(o.plus(down.times(1.0 + y)), DisplayRgb.WHITE));
    }

    @Test
    void aBallOfLightInABallOfTheSameSizeIsSeenAndShines() {
        // A hair larger it would be seen for certain.
        ExactPoint o = ExactPoint.of(0.2, 1.9, 0.6);
        assertShines("ball", new Sphere(o, 0.4, 33), y -> new Light.Sphere(o, 0.4 + y, DisplayRgb.WHITE));
    }

    @Test
    void whatIsBehindTheCeilingChangesNoBitInTheRoom() {
        Rectangle ceiling = TestScenes.rectangle(-9, 3, -9, -9, 3, 9, 9, 3, 9, 9, 3, -9);
        for (double y : new double[] {0, 1e-17, 1e-13, 0.1}) {
            Light light = lamp(ExactPoint.of(0.3, 3 - y, 0.7), Vec3.X, Vec3.Z, 0.6);
            List<SceneObject> objects =
                    new ArrayList<>(List.of(FLOOR, BALL, SceneObject.of(ceiling, TestScenes.matte(0.9, 0.9, 1))));
            DoublePicture room = picture(light, objects, 0);
            objects.add(SceneObject.of(Sphere.of(ExactPoint.of(0.1, 4.2, 0.5), 1), TestScenes.matte(1, 0, 0)));
            objects.add(SceneObject.of(
                    new Box(ExactPoint.of(-2, 3.5, -2), ExactPoint.of(-1, 4, 2)), TestScenes.mirror(0.9)));
            assertArrayEquals(room.toArray(), picture(light, objects, 0).toArray(), "lamp " + y + " below");
        }
    }
}
