package enlightenment.transport.ray;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.camera.Camera;
import enlightenment.color.Rgb;
import enlightenment.geometry.Mesh;
import enlightenment.material.Glass;
import enlightenment.material.Material;
import enlightenment.material.Texture;
import enlightenment.math.ExactPoint;
import enlightenment.math.Vec3;
import enlightenment.mesh.TestMeshes;
import enlightenment.primitive.Ray;
import enlightenment.scene.RenderSettings;
import enlightenment.scene.Scene;
import enlightenment.scene.Shading;
import enlightenment.world.CompiledScene;
import enlightenment.world.SceneCompiler;
import enlightenment.world.parts.RayCounters;
import java.util.Arrays;
import java.util.OptionalInt;
import org.junit.jupiter.api.Test;

/**
 * What is seen through a glass ball of 20·4^k triangles goes to what is seen through the ball: by interpolated normals as places do, a quarter
 * of the error for each cut; by those of triangles a half.
 */
class SmoothRefractionConvergenceTest {
    private static final int CUTS = 5;
    private static final int SIDE = 60;
    private static final double DISTANCE = 4;
    private static final double INDEX = 1.5;

    private static CompiledScene scene(int cuts, boolean smoothly) {
        Material glass = Glass.of(Texture.of(new Rgb(1, 1, 1)), INDEX).withSmoothRefraction(smoothly);
        Scene scene = Scene.builder()
                .size(SIDE, SIDE)
                .camera(new Camera.Perspective(
                        ExactPoint.of(0, 0, -DISTANCE), ExactPoint.of(0.0, 0.0, 0.0), Vec3.Y, 18))
                .shading(new Shading.Physical(OptionalInt.empty(), Rgb.WHITE))
                .object(Mesh.of(TestMeshes.ball(cuts)), glass)
                .build();
        return SceneCompiler.compile(scene, RenderSettings.of(scene));
    }

    /** The root mean square of the errors of directions behind the ball. */
    private static double error(int cuts, boolean smoothly) {
        CompiledScene scene = scene(cuts, smoothly);
        PathFollower path = new PathFollower(scene, new RayCounters(scene.kindNames.size()), 9);
        path.tracer.beginTile(0, 0, SIDE, SIDE);
        Ray ray = new Ray();
        double sum = 0;
        int n = 0;
        for (int k = 0; k < SIDE * SIDE; k++) {
            scene.camera.ray((k % SIDE + 0.5) / SIDE, (k / SIDE + 0.5) / SIDE, ray);
            Vec3 d = new Vec3(ray.dx, ray.dy, ray.dz).normalized();
            Vec3 center = new Vec3(0, 0, DISTANCE);
            double along = d.dot(center);
            double off2 = center.minus(d.times(along)).lengthSquared();
            // Away from silhouettes and total reflection.
            if (off2 > 0.36) {
                continue;
            }
            Vec3 p = d.times(along - Math.sqrt(1 - off2)).minus(center);
            Vec3 within = refracted(d, p, 1 / INDEX);
            Vec3 exit = p.minus(within.times(2 * within.dot(p)));
            Vec3 expected = refracted(within, exit.negated(), INDEX);
            path.begin(ray);
            for (int crossed = 0; crossed < 2; crossed++) {
                assertEquals(PathFollower.Event.GLASS, path.next(ray));
                path.glass.choose(0.99999, new double[2]);
                assertTrue(path.cross(ray) && path.glass.weight() == 1);
                path.continues();
            }
            Vec3 seen = new Vec3(ray.dx, ray.dy, ray.dz).normalized();
            sum += seen.minus(expected).lengthSquared();
            n++;
        }
        assertTrue(n > SIDE * SIDE / 4, "" + n);
        return Math.sqrt(sum / n);
    }

    /** Snell's law; the normal is on the side that light comes from. */
    private static Vec3 refracted(Vec3 d, Vec3 n, double eta) {
        double c = -d.dot(n);
        double root = 1 - eta * eta * (1 - c * c);
        assertTrue(root > 0);
        return d.times(eta).plus(n.times(eta * c - Math.sqrt(root)));
    }

    private static void check(boolean smoothly, double least, double most) {
        double[] errors = new double[CUTS];
        for (int cuts = 1; cuts < CUTS; cuts++) {
            errors[cuts] = error(cuts, smoothly);
        }
        for (int cuts = 2; cuts < CUTS; cuts++) {
            double ratio = errors[cuts - 1] / errors[cuts];
            assertTrue(ratio > least && ratio < most, Arrays.toString(errors));
        }
    }

    @Test
    void byInterpolatedNormalsEachCutLeavesAQuarterOfTheError() {
        check(true, 3.4, 4.6);
    }

    @Test
    void byNormalsOfTrianglesEachCutLeavesAHalf() {
        check(false, 1.6, 2.8);
    }
}
