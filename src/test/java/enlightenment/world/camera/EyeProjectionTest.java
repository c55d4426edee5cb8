package enlightenment.world.camera;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.camera.Camera;
import enlightenment.frame.SceneFrame;
import enlightenment.math.ExactPoint;
import enlightenment.math.Vec3;
import enlightenment.primitive.Ray;
import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;

/** Projections against the camera's rays: the same the other way round, for every camera. */
class EyeProjectionTest {
    private static final ExactPoint EYE = ExactPoint.of(1, 2, -3);
    private static final ExactPoint AIM = ExactPoint.of(0.5, 1, 2);

    private static List<CompiledCamera> cameras() {
        ExactPoint corner = ExactPoint.of(-2, 0, 1);
        Vec3 up = new Vec3(0.5, 3, 0.25);
        Vec3 right = new Vec3(4, 0.5, -1);
        List<Camera> all = List.of(
                new Camera.Window(EYE, corner, corner.plus(up), corner.plus(up.plus(right)), corner.plus(right), 0),
                new Camera.Perspective(EYE, AIM, new Vec3(0.1, 1, 0), 50),
                new Camera.Orthographic(EYE, AIM, new Vec3(0.1, 1, 0), 2),
                new Camera.Isometric(EYE, 2));
        return all.stream()
                .map(c -> CompiledCamera.of(c, new SceneFrame(c.origin(), 2), 300, 100))
                .toList();
    }

    private static Vec3 at(Ray ray, double t) {
        return new Vec3(ray.ox + t * ray.dx, ray.oy + t * ray.dy, ray.oz + t * ray.dz);
    }

    private static boolean project(EyeProjection eye, Vec3 p) {
        return eye.project(p.x(), p.y(), p.z());
    }

    @Test
    void whatARayMeetsIsSeenAtItsPlaceAndLooksBackAtItsStart() {
        SplittableRandom random = new SplittableRandom(1);
        for (CompiledCamera camera : cameras()) {
            EyeProjection eye = EyeProjection.of(camera);
            Ray ray = new Ray();
            for (int i = 0; i < 1_000; i++) {
                double x = random.nextDouble();
                double y = random.nextDouble();
                camera.ray(x, y, ray);
                Vec3 p = at(ray, ray.tMin + 3 * random.nextDouble());
                assertTrue(project(eye, p));
                assertEquals(x, eye.x, 1e-12);
                assertEquals(y, eye.y, 1e-12);
                Vec3 back = p.plus(new Vec3(eye.toEyeX, eye.toEyeY, eye.toEyeZ));
                assertEquals(0, back.minus(at(ray, ray.tMin)).maxAbs(), 1e-12);
                Vec3 d = new Vec3(ray.dx, ray.dy, ray.dz).normalized();
                assertEquals(0, d.plus(new Vec3(eye.dx, eye.dy, eye.dz)).maxAbs(), 1e-12);
            }
        }
    }

    @Test
    void whatLiesBeforeTheStartOrBesideThePictureIsNotSeen() {
        for (CompiledCamera camera : cameras()) {
            EyeProjection eye = EyeProjection.of(camera);
            Ray ray = new Ray();
            camera.ray(0.5, 0.5, ray);
            assertFalse(project(eye, at(ray, ray.tMin - 0.01)));
            assertTrue(project(eye, at(ray, ray.tMin + 0.01)));
            for (double[] beside : new double[][] {{-0.01, 0.5}, {1.01, 0.5}, {0.5, -0.01}, {0.5, 1.01}}) {
                camera.ray(beside[0], beside[1], ray);
                assertFalse(project(eye, at(ray, ray.tMin + 1)));
            }
        }
    }

    /** A small patch that faces the eye: its area in the picture, over its own, as the projections of its corners say. */
    @Test
    void importanceIsTheAreaInThePictureOfAnAreaThatFacesTheEye() {
        SplittableRandom random = new SplittableRandom(2);
        double size = 1e-5;
        for (CompiledCamera camera : cameras()) {
            EyeProjection eye = EyeProjection.of(camera);
            EyeProjection corner = EyeProjection.of(camera);
            Ray ray = new Ray();
            for (int i = 0; i < 100; i++) {
                camera.ray(0.1 + 0.8 * random.nextDouble(), 0.1 + 0.8 * random.nextDouble(), ray);
                Vec3 p = at(ray, ray.tMin + 1 + random.nextDouble());
                assertTrue(project(eye, p));
                Vec3 d = new Vec3(eye.dx, eye.dy, eye.dz);
                Vec3 a = d.cross(new Vec3(0.3, -0.5, 0.7)).normalized();
                Vec3 b = d.cross(a);
                double[] place = new double[4];
                for (int k = 0; k < 2; k++) {
                    assertTrue(project(corner, p.plus((k == 0 ? a : b).times(size))));
                    place[2 * k] = corner.x - eye.x;
                    place[2 * k + 1] = corner.y - eye.y;
                }
                double area = Math.abs(place[0] * place[3] - place[1] * place[2]) / (size * size);
                assertEquals(1, area / eye.importance, 1e-3);
            }
        }
    }
}
