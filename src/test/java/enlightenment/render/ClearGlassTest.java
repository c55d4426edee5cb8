package enlightenment.render;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.camera.Camera;
import enlightenment.color.DisplayRgb;
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
import java.util.Map;
import org.junit.jupiter.api.Test;

/** Glass of index 1 is not there; glass of extreme index spoils no pixel (numerics, N25, N26). */
class ClearGlassTest {
    /** Ambient light would hide a ray that goes astray: these lights shade smoothly, and nothing throws a shadow. */
    private static Scene.Builder room() {
        return Scene.builder()
                .size(48, 48)
                .camera(new Camera.Perspective(
                        ExactPoint.of(0.31, 0.47, -4.13), ExactPoint.of(0.02, 0.01, 0), Vec3.Y, 40))
                .shading(new Shading.Classic(0.25, 1, DisplayRgb.BLACK, 10_000))
                .object(Sphere.of(ExactPoint.of(0.2, -0.1, 0.3), 9), TestScenes.matte(0.9, 0.8, 0.7))
                .object(Sphere.of(ExactPoint.of(0.6, 0.2, 2.5), 0.9), TestScenes.matte(0.3, 0.9, 0.5))
                .object(Sphere.of(ExactPoint.of(-0.9, 0.4, 2.9), 0.8), TestScenes.mirror(0.9))
                .light(new Light.Point(ExactPoint.of(2.5, 4.5, -1.5), DisplayRgb.WHITE))
                .light(new Light.Point(ExactPoint.of(-3.5, -2.5, 1.5), new DisplayRgb(0.9, 0.5, 0.7)));
    }

    private static Material glass(double ior, int priority) {
        return new Glass(Texture.of(DisplayRgb.WHITE), ior, 1, priority, true);
    }

    @Test
    void anyShapeOfIndexOneIsInvisible() {
        DoublePicture without = DoublePicture.of(room().build(), 2, 1);
        assertTrue(without.greatest() - without.least() > 0.3);
        for (Map.Entry<String, Shape> e : Solids.all().entrySet()) {
            DoublePicture with =
                    DoublePicture.of(room().object(e.getValue(), glass(1, 0)).build(), 2, 1);
            assertEquals(0, with.difference(without), 1e-12, e.getKey());
        }
    }

    @Test
    void allShapesOfIndexOneInOneAnotherAreInvisible() {
        DoublePicture without = DoublePicture.of(room().build(), 2, 1);
        Scene.Builder all = room();
        int priority = 0;
        for (Shape s : Solids.all().values()) {
            all.object(s, glass(1, ++priority % 3));
        }
        assertEquals(0, DoublePicture.of(all.build(), 2, 1).difference(without), 1e-12);
    }

    @Test
    void aBubbleOfTheSameIndexAsItsGlassIsInvisible() {
        Shape block = Sphere.of(ExactPoint.of(0, 0, 0), 1.7);
        DoublePicture without =
                DoublePicture.of(room().object(block, glass(1.5, 0)).build(), 2, 1);
        for (Map.Entry<String, Shape> e : Solids.solid().entrySet()) {
            Scene scene = room().object(block, glass(1.5, 0))
                    .object(e.getValue(), glass(1.5, 1))
                    .build();
            assertEquals(0, DoublePicture.of(scene, 2, 1).difference(without), 1e-11, e.getKey());
        }
    }

    @Test
    void anIndexThatDiffersFromOneByAnUlpBendsByUlps() {
        DoublePicture without = DoublePicture.of(room().build(), 1, 1);
        for (Map.Entry<String, Shape> e : Solids.solid().entrySet()) {
            for (double ior : new double[] {1 + 1e-15, 1 - 1e-15}) {
                DoublePicture with = DoublePicture.of(
                        room().object(e.getValue(), glass(ior, 0)).build(), 1, 1);
                // At cosine c the ray is bent by |n − 1|/c; total reflection begins below c = 5e-8, too thin for a
                // pixel.
                assertEquals(0, with.difference(without), 1e-9, e.getKey() + " of index " + ior);
            }
        }
    }

    @Test
    void extremeIndicesGiveFinitePictures() {
        for (double ior : new double[] {0.5, 1e6, 1e-6, 1e100, 1e-100, 1e300, 1e-300, Double.MIN_VALUE}) {
            for (Map.Entry<String, Shape> e : Solids.all().entrySet()) {
                Scene scene =
                        room().size(8, 8).object(e.getValue(), glass(ior, 0)).build();
                DoublePicture p = DoublePicture.of(scene, 1, 1);
                assertTrue(p.isFinite() && p.least() >= 0, e.getKey() + " of index " + ior);
            }
        }
    }
}
