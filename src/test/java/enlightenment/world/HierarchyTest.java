package enlightenment.world;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.accel.Bvh;
import enlightenment.accel.BvhQuery;
import enlightenment.accel.Closest;
import enlightenment.camera.Camera;
import enlightenment.color.DisplayRgb;
import enlightenment.film.FilmTile;
import enlightenment.frame.SceneFrame;
import enlightenment.geometry.Box;
import enlightenment.geometry.Cube;
import enlightenment.geometry.Rectangle;
import enlightenment.geometry.Shape;
import enlightenment.geometry.Sphere;
import enlightenment.geometry.Torus;
import enlightenment.geometry.Triangle;
import enlightenment.light.Light;
import enlightenment.material.Glass;
import enlightenment.material.Material;
import enlightenment.material.Texture;
import enlightenment.math.ExactPoint;
import enlightenment.math.Vec3;
import enlightenment.method.RayTraceMethod;
import enlightenment.primitive.Primitive;
import enlightenment.primitive.Primitives;
import enlightenment.primitive.Ray;
import enlightenment.scene.BuiltInMethod;
import enlightenment.scene.RenderSettings;
import enlightenment.scene.Scene;
import enlightenment.world.parts.RayCounters;
import java.util.Random;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;

/** The hierarchy against a loop over everything: the same ids, the same bits. */
class HierarchyTest {
    private static Shape shape(Random r, double size) {
        ExactPoint c = ExactPoint.of(4 * r.nextGaussian(), 4 * r.nextGaussian(), 4 * r.nextGaussian());
        return switch (r.nextInt(6)) {
            case 0 -> Sphere.of(c, size);
            case 1 -> new Box(c, c.plus(new Vec3(size, 2 * size, size / 2)));
            case 2 -> new Cube(c, size, new Vec3(90 * r.nextInt(3), 360 * r.nextDouble(), 20));
            case 3 -> new Torus(c, new Vec3(r.nextGaussian(), 1, r.nextGaussian()), size, size / 3);
            case 4 ->
                new Triangle(c, c.plus(new Vec3(size, 0, r.nextDouble() * size)), c.plus(new Vec3(0, size, size)));
            default -> {
                Vec3 u = new Vec3(size, 0, 0);
                Vec3 v = new Vec3(0, size, r.nextBoolean() ? 0 : size);
                yield new Rectangle(c, c.plus(v), c.plus(u.plus(v)), c.plus(u));
            }
        };
    }

    private static Primitive[] primitives(Random r, int n) {
        Primitive[] all = new Primitive[n];
        for (int i = 0; i < n; i++) {
            all[i] = Primitives.place(shape(r, Math.pow(10, -6 + 7 * r.nextDouble())), SceneFrame.WORLD);
        }
        return all;
    }

    private static void compare(int count, int rays, long seed) {
        Random r = new Random(seed);
        Primitive[] all = primitives(r, count);
        Bvh bvh = Bvh.build(all);
        int[] kinds = new int[count];
        Closest tree = new Closest(kinds, new long[1]);
        Closest loop = new Closest(kinds, new long[1]);
        BvhQuery query = new BvhQuery(kinds, new long[1]);
        int hits = 0;
        for (int k = 0; k < rays; k++) {
            Vec3 o = new Vec3(5 * r.nextGaussian(), 5 * r.nextGaussian(), 5 * r.nextGaussian());
            Vec3 d = new Vec3(direction(r), direction(r), direction(r));
            if (d.maxAbs() == 0) {
                continue;
            }
            Ray ray = Ray.of(o, d);
            loop.reset(Double.MAX_VALUE);
            for (int i = 0; i < count; i++) {
                loop.offer(ray, all[i], i);
            }
            assertEquals(loop.id(), bvh.closest(ray, tree));
            assertEquals(Double.doubleToRawLongBits(loop.t()), Double.doubleToRawLongBits(tree.t()));
            hits += loop.id() >= 0 ? 1 : 0;
            double limit = 3 * r.nextDouble();
            boolean blocked = false;
            for (Primitive p : all) {
                blocked |= p.nearest(ray, limit) <= limit;
            }
            assertEquals(blocked, bvh.occluded(ray, limit, query));
        }
        assertTrue(count == 0 || hits > 0);
    }

    /** Often exactly zero of either sign: rays along axes and in planes. */
    private static double direction(Random r) {
        return switch (r.nextInt(6)) {
            case 0 -> 0.0;
            case 1 -> -0.0;
            default -> r.nextGaussian();
        };
    }

    @Test
    void theHierarchyFindsWhatALoopFinds() {
        compare(0, 10, 1);
        compare(1, 20_000, 2);
        compare(5, 2_000, 3);
        compare(300, 20_000, 4);
    }

    @Test
    @Tag("full")
    void theHierarchyFindsWhatALoopFindsForAMillionRays() {
        compare(300, 1_000_000, 5);
    }

    @Test
    void coincidentPrimitivesNeitherOverflowTheStackNorChangeTheWinner() {
        Primitive[] same = new Primitive[20_000];
        for (int i = 0; i < same.length; i++) {
            same[i] = Primitives.place(Sphere.of(ExactPoint.of(0, 0, 5), 1), SceneFrame.WORLD);
        }
        Bvh bvh = Bvh.build(same);
        Closest state = new Closest(new int[same.length], new long[1]);
        assertEquals(0, bvh.closest(Ray.of(Vec3.ZERO, Vec3.Z), state));
        assertEquals(4, state.t());
    }

    @Test
    void aPictureIsTheSameWithAndWithoutAHierarchy() {
        Random r = new Random(11);
        Scene.Builder b = Scene.builder()
                .size(48, 32)
                .camera(new Camera.Perspective(ExactPoint.of(0, 2, -12), ExactPoint.of(0, 0, 0), Vec3.Y, 50))
                .light(new Light.Sphere(ExactPoint.of(4, 9, -6), 1.5, DisplayRgb.WHITE))
                .light(new Light.Rectangle(
                        ExactPoint.of(-9, 3, -4),
                        ExactPoint.of(-9, 6, -4),
                        ExactPoint.of(-9, 6, 0),
                        ExactPoint.of(-9, 3, 0),
                        DisplayRgb.WHITE));
        Material[] materials = {
            Material.Matte.of(Texture.of(new DisplayRgb(0.9, 0.6, 0.4))),
            Material.Mirror.of(Texture.of(new DisplayRgb(0.8, 0.9, 0.8))),
            Glass.of(Texture.of(new DisplayRgb(0.9, 0.9, 1)), 1.5)
        };
        for (int i = 0; i < 60; i++) {
            b.object(shape(r, 0.2 + 1.3 * r.nextDouble()), materials[i % 5 < 3 ? 0 : i % 5 - 2]);
        }
        b.object(
                new Rectangle(
                        ExactPoint.of(-20, -6, -20),
                        ExactPoint.of(-20, -6, 20),
                        ExactPoint.of(20, -6, 20),
                        ExactPoint.of(20, -6, -20)),
                materials[0]);
        Scene scene = b.build();
        RenderSettings settings = RenderSettings.of(scene).withAntialias(2).with(new BuiltInMethod.RayTraceSettings(5));
        FilmTile tree = render(scene, settings, true);
        FilmTile loop = render(scene, settings, false);
        for (int y = 0; y < 32; y++) {
            for (int x = 0; x < 48; x++) {
                for (int c = 0; c < 3; c++) {
                    assertEquals(loop.mean(x, y, c), tree.mean(x, y, c), "pixel " + x + ", " + y);
                }
            }
        }
    }

    private static FilmTile render(Scene scene, RenderSettings settings, boolean withBvh) {
        CompiledScene compiled = SceneCompiler.compile(scene, settings, withBvh);
        FilmTile tile = new FilmTile(0, 0, 48, 32);
        RayTraceMethod.of(compiled, settings, new RayCounters(compiled.kindNames.size()), 0)
                .render(tile);
        return tile;
    }
}
