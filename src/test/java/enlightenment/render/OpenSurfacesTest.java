package enlightenment.render;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.camera.Camera;
import enlightenment.color.DisplayRgb;
import enlightenment.geometry.Cone;
import enlightenment.geometry.Cylinder;
import enlightenment.geometry.Shape;
import enlightenment.light.Light;
import enlightenment.material.Material;
import enlightenment.math.ExactPoint;
import enlightenment.math.Vec3;
import enlightenment.scene.Scene;
import enlightenment.scene.Shading;
import java.util.List;
import org.junit.jupiter.api.Test;

/**
 * The inside of a surface without caps lies in its own shadow: not solid is not flat. The truth is a thickened copy, where the
 * shadow is another surface's.
 */
class OpenSurfacesTest {
    private static final Material WHITE = TestScenes.matte(1, 1, 1);
    private static final ExactPoint BASE = ExactPoint.of(-0.3, 0.2, 0.1);
    private static final ExactPoint TOP = ExactPoint.of(0.4, 1.5, -0.6);

    /** Far above the errors of hits, far below a pixel. */
    private static final double HAIR = 1e-9;

    private interface Wide {
        Shape by(double more);
    }

    private static final List<Wide> SHAPES = List.of(
            more -> new Cylinder(BASE, TOP, 0.8 + more, false),
            more -> new Cone(BASE, TOP, 0.5 + more, 0.9 + more, false),
            more -> new Cone(BASE, TOP, 0.9 + more, 0.5 + more, false),
            more -> new Cone(TOP, BASE, 0.9 + more, 0, false));

    private static final List<Light> LIGHTS = List.of(
            new Light.Sphere(ExactPoint.of(-3.1, 4.3, -4.7), 0.7, DisplayRgb.WHITE),
            new Light.Sphere(ExactPoint.of(2.7, 0.9, 1.3), 0.3, DisplayRgb.WHITE),
            new Light.Point(ExactPoint.of(2.3, 3.1, -4.3), DisplayRgb.WHITE),
            new Light.Rectangle(
                    ExactPoint.of(-3, 3, -3),
                    ExactPoint.of(-3, 3, -2),
                    ExactPoint.of(-2, 3, -2),
                    ExactPoint.of(-2, 3, -3),
                    DisplayRgb.WHITE));

    private static DoublePicture picture(Light light, Material material, Shape... shapes) {
        Scene.Builder b = Scene.builder()
                .size(64, 64)
                .camera(new Camera.Perspective(
                        ExactPoint.of(1.31, 4.47, -4.13), ExactPoint.of(0.1, 0.8, -0.2), Vec3.Y, 30))
                .shading(new Shading.Classic(0.1, 0, new DisplayRgb(0.4, 0.6, 0.8), 6))
                .light(light);
        for (Shape s : shapes) {
            b.object(s, material);
        }
        return DoublePicture.of(b.build(), 1, 4);
    }

    @Test
    void theInsideOfAnOpenSurfaceIsShadowedByItsOwnWall() {
        for (Wide shape : SHAPES) {
            for (Light light : LIGHTS) {
                for (Material m : List.of(WHITE, TestScenes.mirror(0.9))) {
                    String what = shape.by(0).type() + " under a light " + light.type() + ", " + m.type();
                    DoublePicture thin = picture(light, m, shape.by(0));
                    DoublePicture thick = picture(light, m, shape.by(0), shape.by(HAIR));
                    assertEquals(0, thin.speckles(thick), what);
                    assertTrue(thin.shareBeyond(thick, 1e-3) <= 0.01, what + ": " + thin.shareBeyond(thick, 1e-3));
                }
            }
        }
    }
}
