package enlightenment.world.light;

import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.camera.Camera;
import enlightenment.color.DisplayRgb;
import enlightenment.color.Rgb;
import enlightenment.geometry.Box;
import enlightenment.geometry.Cube;
import enlightenment.geometry.Rectangle;
import enlightenment.geometry.Shape;
import enlightenment.geometry.Sphere;
import enlightenment.light.Light;
import enlightenment.material.Material;
import enlightenment.material.Texture;
import enlightenment.math.ExactPoint;
import enlightenment.math.Vec3;
import enlightenment.primitive.Primitive;
import enlightenment.primitive.Ray;
import enlightenment.scene.RenderSettings;
import enlightenment.scene.Scene;
import enlightenment.scene.Shading;
import enlightenment.world.CompiledScene;
import enlightenment.world.SceneCompiler;
import java.util.OptionalInt;
import java.util.Random;
import org.junit.jupiter.api.Test;

class LightPyramidTest {
    private static final Material WHITE = Material.Matte.of(Texture.of(DisplayRgb.WHITE));

    private final Random random = new Random(17);
    private int left;
    private int apart;
    private int undecided;

    private double signed() {
        return 2 * random.nextDouble() - 1;
    }

    private ExactPoint point(double range) {
        return ExactPoint.of(range * signed(), range * signed(), range * signed());
    }

    private Vec3 direction() {
        return new Vec3(random.nextGaussian(), random.nextGaussian(), random.nextGaussian()).normalized();
    }

    private CompiledScene scene(Shape... shapes) {
        Vec3 right = direction();
        Vec3 up = right.cross(direction()).normalized().times(0.3 + random.nextDouble());
        ExactPoint at = point(2);
        Scene.Builder b = Scene.builder()
                .camera(new Camera.Perspective(ExactPoint.of(0, 0, -9), ExactPoint.of(0, 0, 0), Vec3.Y, 60))
                .shading(new Shading.Physical(OptionalInt.of(1), Rgb.BLACK))
                .light(new Light.Rectangle(at, at.plus(up), at.plus(up.plus(right)), at.plus(right), DisplayRgb.WHITE));
        for (Shape shape : shapes) {
            b.object(shape, WHITE);
        }
        Scene scene = b.build();
        return SceneCompiler.compile(scene, RenderSettings.of(scene), false);
    }

    private Shape[] shapes() {
        ExactPoint corner = point(2);
        ExactPoint other = point(2);
        Vec3 u = direction();
        Vec3 v = direction();
        return new Shape[] {
            new Cube(point(2), 0.1 + random.nextDouble(), new Vec3(90 * signed(), 90 * signed(), 90 * signed())),
            new Box(corner, corner.plus(new Vec3(random.nextDouble(), 0.01 + random.nextDouble(), 1.5))),
            Sphere.of(point(2), 0.1 + random.nextDouble()),
            new Rectangle(other, other.plus(u), other.plus(u.plus(v)), other.plus(v))
        };
    }

    /** Segments to corners, edges and the inside of the light. */
    private boolean meets(Primitive p, PhysicalLight light, Vec3 from) {
        boolean meets = false;
        for (int k = 0; k < 60; k++) {
            double a = k % 3 == 0 ? random.nextInt(2) : random.nextDouble();
            double b = k % 2 == 0 ? random.nextInt(2) : random.nextDouble();
            Vec3 to = new Vec3(light.x, light.y, light.z)
                    .plus(light.right.times(a))
                    .plus(light.up.times(b))
                    .minus(from);
            meets |= p.nearest(Ray.of(from, to), 1) <= 1;
        }
        return meets;
    }

    @Test
    void whatStandsBesideThePyramidBlocksNoSegmentAndMostOfWhatBlocksNoneIsFound() {
        LightPyramid.Apex apex = new LightPyramid.Apex();
        for (int round = 0; round < 300; round++) {
            CompiledScene scene = scene(shapes());
            PhysicalLight light = scene.physical.lights[0];
            // Rounding of far corners may leave no right angle.
            for (int k = 0; k < 20 && light.pyramid != null; k++) {
                Vec3 p = scene.frame.toFrame(point(3));
                apex.set(light.pyramid, p.x(), p.y(), p.z());
                for (int id = 0; id < scene.primitives.length; id++) {
                    if (id != light.id) {
                        count(apex.misses(id), meets(scene.primitives[id], light, p), scene.primitives[id]);
                    }
                }
            }
        }
        assertTrue(left > 10_000 && apart > 12_000, left + " " + apart);
        assertTrue(undecided < 0.15 * apart, undecided + " of " + apart);
    }

    private void count(boolean misses, boolean meets, Primitive p) {
        assertFalse(misses && meets, p.getClass().getSimpleName());
        left += misses ? 1 : 0;
        apart += meets ? 0 : 1;
        undecided += !misses && !meets ? 1 : 0;
    }

    /** What touches the light's plane, or a side of the pyramid, is in doubt. */
    @Test
    void aBoxThatTouchesThePyramidIsNotLeftOut() {
        Scene scene = Scene.builder()
                .camera(new Camera.Perspective(ExactPoint.of(0, 0, -9), ExactPoint.of(0, 0, 0), Vec3.Y, 60))
                .shading(new Shading.Physical(OptionalInt.of(1), Rgb.BLACK))
                .light(new Light.Rectangle(
                        ExactPoint.of(0, 2, 0),
                        ExactPoint.of(0, 2, 1),
                        ExactPoint.of(1, 2, 1),
                        ExactPoint.of(1, 2, 0),
                        DisplayRgb.WHITE))
                .object(new Box(ExactPoint.of(-1, 0.5, 0), ExactPoint.of(0, 1, 1)), WHITE)
                .object(new Box(ExactPoint.of(-1, 0.5, 0), ExactPoint.of(-0x1p-20, 1, 1)), WHITE)
                .build();
        CompiledScene compiled = SceneCompiler.compile(scene, RenderSettings.of(scene), false);
        PhysicalLight light = compiled.physical.lights[0];
        LightPyramid.Apex apex = new LightPyramid.Apex();
        Vec3 below = compiled.frame.toFrame(ExactPoint.of(0, 0, 0.5));
        apex.set(light.pyramid, below.x(), below.y(), below.z());
        int boxes = 0;
        for (int id = 0; id < compiled.primitives.length; id++) {
            if (id != light.id) {
                boxes += apex.misses(id) ? 1 : 0;
            }
        }
        assertTrue(boxes == 1, "one of two, but " + boxes);
    }
}
