package enlightenment.world.camera;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.camera.Camera;
import enlightenment.color.Rgb;
import enlightenment.frame.Bounds;
import enlightenment.frame.SceneFrame;
import enlightenment.geometry.Sphere;
import enlightenment.material.Glass;
import enlightenment.material.Material;
import enlightenment.material.Texture;
import enlightenment.math.ExactPoint;
import enlightenment.math.Vec3;
import enlightenment.primitive.Ray;
import enlightenment.primitive.SpherePrimitive;
import enlightenment.scene.RenderSettings;
import enlightenment.scene.Scene;
import enlightenment.world.CompiledScene;
import enlightenment.world.SceneCompiler;
import java.util.Arrays;
import java.util.HashSet;
import java.util.Set;
import java.util.SplittableRandom;
import java.util.stream.Collectors;
import org.junit.jupiter.api.Test;

/** Boxes that camera rays may start in. */
class RayStartsTest {
    private static final Material GLASS = Glass.of(Texture.of(Rgb.WHITE), 1.5);

    private static Vec3 vector(SplittableRandom r, double most) {
        return new Vec3(r.nextDouble(-most, most), r.nextDouble(-most, most), r.nextDouble(-most, most));
    }

    private static ExactPoint at(Vec3 v) {
        return ExactPoint.of(v.x(), v.y(), v.z());
    }

    private static Camera camera(SplittableRandom r) {
        ExactPoint eye = at(vector(r, 5));
        double height = Math.scalb(r.nextDouble(1, 2), r.nextInt(-200, 4));
        return switch (r.nextInt(4)) {
            case 0 -> {
                ExactPoint corner = eye.plus(vector(r, 2));
                Vec3 up = vector(r, height);
                Vec3 right = vector(r, height);
                yield new Camera.Window(
                        eye, corner, corner.plus(up), corner.plus(up).plus(right), corner.plus(right), 0);
            }
            case 1 -> new Camera.Isometric(eye, height);
            case 2 -> new Camera.Perspective(eye, eye.plus(vector(r, 1)), vector(r, 1), 60);
            default -> new Camera.Orthographic(eye, eye.plus(vector(r, 1)), vector(r, 1), height);
        };
    }

    /** The start as {@code GlassTracer.begin} computes it. */
    private static Vec3 start(CompiledCamera camera, double x, double y) {
        Ray ray = new Ray();
        camera.ray(x, y, ray);
        return new Vec3(
                Math.fma(ray.tMin, ray.dx, ray.ox),
                Math.fma(ray.tMin, ray.dy, ray.oy),
                Math.fma(ray.tMin, ray.dz, ray.oz));
    }

    @Test
    void noBoxIsLeftOutThatTouchesAStart() {
        SplittableRandom r = new SplittableRandom(11);
        for (int k = 0; k < 2000; k++) {
            Camera c = camera(r);
            CompiledCamera camera = CompiledCamera.of(c, new SceneFrame(c.origin(), 3), 300, 200);
            RayStarts starts = camera.rayStarts();
            for (int i = 0; i < 20; i++) {
                Vec3 start = start(camera, r.nextDouble(), r.nextDouble());
                Vec3 other = start.plus(vector(r, Math.scalb(1.0, r.nextInt(-60, 2))));
                assertTrue(starts.mayLieIn(Bounds.of(start)), c.type() + " at " + start);
                assertTrue(starts.mayLieIn(Bounds.of(start, other)), c.type() + " from " + start + " to " + other);
            }
        }
    }

    /** Balls in random places, and a view across them all at an angle to all axes. */
    private static CompiledScene across(int n) {
        SplittableRandom r = new SplittableRandom(12);
        Scene.Builder b = Scene.builder()
                .camera(new Camera.Orthographic(ExactPoint.of(-5, 5, -5), ExactPoint.of(0, 0, 0), Vec3.Y, 12));
        for (int k = 0; k < n; k++) {
            b.object(Sphere.of(at(vector(r, 5).plus(new Vec3(-5, 5, -5))), 0.02), GLASS);
        }
        Scene scene = b.build();
        return SceneCompiler.compile(scene, RenderSettings.of(scene));
    }

    /**
     * The plane through the eye across the line of sight, (−1, 1, −1)/√3, meets balls no farther from it than their radius, boxes around
     * them no farther than √3 times that.
     */
    @Test
    void ofBallsAcrossAnObliqueViewThoseAtItsPlaneAreKept() {
        CompiledScene scene = across(4000);
        Set<Integer> kept = Arrays.stream(scene.cameraSolids).boxed().collect(Collectors.toCollection(HashSet::new));
        assertEquals(scene.cameraSolids.length, kept.size());
        int met = 0;
        for (int id : scene.glassSolids) {
            SpherePrimitive s = (SpherePrimitive) scene.primitives[id];
            // The eye is the frame's origin.
            double distance = Math.abs(-s.x() + s.y() - s.z()) / Math.sqrt(3);
            boolean isInPicture = scene.camera.startBounds().contains(s.center());
            if (isInPicture && distance <= s.radius()) {
                assertTrue(kept.contains(id), "a ball at " + s.center());
                met++;
            }
            if (distance > 1.74 * s.radius()) {
                assertFalse(kept.contains(id), "a ball at " + s.center());
            }
        }
        assertTrue(met > 10 && kept.size() < 100, met + " met, " + kept.size() + " kept");
    }
}
