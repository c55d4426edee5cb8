package enlightenment.physical;

import static enlightenment.physical.PhysicalScenes.linear;
import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertSame;

import enlightenment.camera.Camera;
import enlightenment.color.DisplayRgb;
import enlightenment.color.Rgb;
import enlightenment.geometry.Mesh;
import enlightenment.light.Light;
import enlightenment.material.Glass;
import enlightenment.material.Material;
import enlightenment.material.Medium;
import enlightenment.math.ExactPoint;
import enlightenment.math.Vec3;
import enlightenment.mesh.TestMeshes;
import enlightenment.mesh.TriangleMesh;
import enlightenment.render.Renderer;
import enlightenment.scene.RenderSettings;
import enlightenment.scene.Scene;
import enlightenment.scene.Shading;
import java.util.List;
import org.junit.jupiter.api.Test;

/** Whether the triangles of a file face outwards or inwards makes no difference to what fills a solid. */
class InwardMeshTest {
    private static final TriangleMesh BALL = TestMeshes.ball(2);

    private static float[] picture(Scene.Builder scene) {
        Scene built = scene.build();
        return Renderer.render(built, RenderSettings.of(built).withAntialias(3)).toArray();
    }

    private static float[] physical(TriangleMesh ball, Material material) {
        return picture(PhysicalScenes.room()
                .object(Mesh.of(TestMeshes.moved(ball, false, p -> p.times(0.4).plus(new Vec3(0, 0.8, 0)))), material)
                .light(PhysicalScenes.panel(0, 1.95, 0, 0.3, Rgb.gray(20), false)));
    }

    @Test
    void solidsOfGlassAndMediaDoNotDependOnHowTrianglesFace() {
        Medium milk = new Medium.Coefficients(Rgb.gray(3), Rgb.gray(0.1), 0);
        for (Material m : List.of(Glass.of(linear(0.9, 1, 0.9), 1.5), Material.Scattering.of(milk))) {
            assertArrayEquals(physical(BALL, m), physical(BALL.turned(), m), m.type());
        }
    }

    @Test
    void norDoesGlassOfClassicShading() {
        for (TriangleMesh ball : List.of(BALL, BALL.turned())) {
            assertArrayEquals(classic(BALL), classic(ball));
        }
    }

    private static float[] classic(TriangleMesh ball) {
        return picture(Scene.builder()
                .size(24, 24)
                .camera(new Camera.Perspective(ExactPoint.of(0, 0, -4), ExactPoint.of(0, 0, 0), Vec3.Y, 40))
                .shading(new Shading.Classic(0.2, 0.1, DisplayRgb.ofBytes(90, 120, 200), 8))
                .object(Mesh.of(ball), Glass.of(linear(1, 0.9, 0.9), 1.3))
                .light(new Light.Sphere(ExactPoint.of(3, 3, -3), 0.5, DisplayRgb.WHITE)));
    }

    @Test
    void onlyClosedMeshesThatFaceInwardsAreTurned() {
        assertSame(BALL, BALL.outwards());
        assertEquals(BALL, BALL.turned().outwards());
        TriangleMesh open = TestMeshes.grid(3).turned();
        assertSame(open, open.outwards());
        assertNotEquals(BALL, BALL.turned());
        assertEquals(BALL.volume(), BALL.turned().volume());
    }
}
