package enlightenment.world;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.camera.Camera;
import enlightenment.color.Rgb;
import enlightenment.geometry.Sphere;
import enlightenment.geometry.Triangle;
import enlightenment.material.Material;
import enlightenment.material.Texture;
import enlightenment.math.ExactPoint;
import enlightenment.math.Vec3;
import enlightenment.primitive.SpherePrimitive;
import enlightenment.scene.RenderSettings;
import enlightenment.scene.Scene;
import enlightenment.scene.Shading;
import enlightenment.world.light.PhysicalLight;
import enlightenment.world.material.SurfaceMaterial;
import enlightenment.world.parts.Polls;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.OptionalInt;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;

/** The pairs of mirror balls and lights that are kept, against a loop over all pairs. */
class MirrorBallsTest {
    private static final Texture GREY = Texture.of(Rgb.WHITE);
    private static final Material MIRROR = Material.Mirror.of(GREY);

    private static Scene.Builder empty() {
        return Scene.builder()
                .camera(new Camera.Perspective(ExactPoint.of(0, 0, -9), ExactPoint.of(0, 0, 0), Vec3.Y, 60))
                .shading(new Shading.Physical(OptionalInt.empty(), Rgb.BLACK));
    }

    private static Material glowing(double radiance) {
        return Material.Matte.of(Texture.of(Rgb.BLACK)).withRadiance(new Rgb(radiance, radiance / 2, 0));
    }

    private static ExactPoint place(SplittableRandom r, boolean onGrid) {
        return onGrid
                ? ExactPoint.of(r.nextInt(-4, 5), r.nextInt(-4, 5), r.nextInt(-4, 5))
                : ExactPoint.of(r.nextDouble(-5, 5), r.nextDouble(-5, 5), r.nextDouble(-5, 5));
    }

    /** On a grid, with few radii and radiances, many pairs have the same power, and some surfaces coincide. */
    private static CompiledScene random(long seed, int mirrors, int lights) {
        SplittableRandom r = new SplittableRandom(seed);
        boolean onGrid = r.nextBoolean();
        boolean areLarge = r.nextInt(4) == 0;
        Scene.Builder b = empty();
        for (int k = 0; k < mirrors; k++) {
            double radius = areLarge ? 20 + k : onGrid ? 0.25 * (1 + r.nextInt(2)) : r.nextDouble(0.01, 0.5);
            Material m = r.nextInt(8) == 0 ? new Material.Mirror(GREY, true, new Rgb(2, 1, 0)) : MIRROR;
            b.object(Sphere.of(place(r, onGrid), radius), m);
        }
        for (int k = 0; k < lights; k++) {
            ExactPoint at = place(r, onGrid);
            Material glow = glowing(onGrid ? 1 + r.nextInt(2) : StrictMath.exp(r.nextDouble(-3, 3)));
            if (r.nextInt(4) == 0) {
                b.object(new Triangle(at, at.plus(Vec3.X), at.plus(Vec3.Y)), glow);
            } else {
                b.object(Sphere.of(at, onGrid ? 0.125 : r.nextDouble(0.01, 0.1)), glow);
            }
        }
        Scene scene = b.build();
        return SceneCompiler.compile(scene, RenderSettings.of(scene));
    }

    private record Pair(int id, int light, double power) {}

    /** All pairs by id and light; of more than eight those with the largest power, by power, id and light. */
    private static List<Pair> expected(CompiledScene scene) {
        List<Pair> all = new ArrayList<>();
        for (int id = 0; id < scene.primitives.length; id++) {
            SurfaceMaterial m = scene.material(id, 0);
            if (m.isGlass || !m.isDelta || m.isBlack || scene.coincident.concerns(id)) {
                continue;
            }
            SpherePrimitive mirror = (SpherePrimitive) scene.primitives[id];
            for (int light = 0; light < scene.physical.lights.length; light++) {
                PhysicalLight l = scene.physical.lights[light];
                if (l.id == id || scene.coincident.concerns(l.id)) {
                    continue;
                }
                double x = mirror.x() - l.ballX;
                double y = mirror.y() - l.ballY;
                double z = mirror.z() - l.ballZ;
                double share = mirror.radius() * mirror.radius() / (x * x + y * y + z * z);
                double radiance = Math.max(l.r, Math.max(l.g, l.b));
                all.add(new Pair(id, light, radiance * l.form.area() * Math.min(share, 1)));
            }
        }
        if (all.size() > 8) {
            all.sort(Comparator.<Pair>comparingDouble(p -> -p.power)
                    .thenComparingInt(Pair::id)
                    .thenComparingInt(Pair::light));
        }
        return all.subList(0, Math.min(8, all.size()));
    }

    private static void assertSame(List<Pair> expected, MirrorBalls actual) {
        if (expected.isEmpty()) {
            assertNull(actual);
            return;
        }
        assertArrayEquals(expected.stream().mapToInt(Pair::id).toArray(), actual.id);
        assertArrayEquals(expected.stream().mapToInt(Pair::light).toArray(), actual.light);
    }

    @Test
    void theEightPairsAreThoseThatALoopOverAllPairsFinds() {
        int few = 0;
        int many = 0;
        for (long seed = 1; seed <= 60; seed++) {
            CompiledScene scene = random(seed, 1 + (int) (seed % 50), 1 + (int) (seed * 7 % 60));
            List<Pair> expected = expected(scene);
            assertSame(expected, scene.mirrorBalls);
            many += expected.size() == 8 ? 1 : 0;
        }
        for (long seed = 1; seed <= 60; seed++) {
            CompiledScene scene = random(seed, (int) (seed % 4), (int) (seed / 4 % 5));
            List<Pair> expected = expected(scene);
            assertSame(expected, scene.mirrorBalls);
            few += expected.size() < 8 ? 1 : 0;
        }
        assertTrue(few > 20 && many > 40, few + " with fewer than eight, " + many + " with eight");
    }

    private static Scene.Builder crowd(Material material, int n) {
        SplittableRandom r = new SplittableRandom(5);
        Scene.Builder b = empty();
        for (int k = 0; k < n; k++) {
            b.object(Sphere.of(place(r, false), 0.02), material);
            b.object(Sphere.of(place(r, false), 0.01), glowing(1));
        }
        return b;
    }

    /** Each mirror asks once for at least one node of the tree, each light is put into one: with 2048 of each that is four times 1024. */
    @Test
    void lookingForPairsEndsWhereverItIsAsked() {
        int n = 2048;
        int plain =
                Polls.ofCompiling(Polls.NEVER, crowd(Material.Matte.of(GREY), n).build());
        Scene mirrored = crowd(MIRROR, n).build();
        int all = Polls.ofCompiling(Polls.NEVER, mirrored);
        assertTrue(all >= plain + 4, plain + " times without mirrors, " + all + " with them");
        for (int patience = plain; patience <= all; patience += 1 + (all - plain) / 8) {
            assertEquals(patience, Polls.ofCompiling(patience, mirrored));
        }
    }

    /** Where mirrors and lamps are equal, and only their distances differ, a loop would take n² steps of which 1024 are asked at once. */
    @Test
    void equalMirrorsAndLampsTakeFarFewerStepsThanThereArePairs() {
        int n = 2048;
        Scene scene = crowd(MIRROR, n).build();
        CompiledScene compiled = SceneCompiler.compile(scene, RenderSettings.of(scene));
        int[] asked = new int[1];
        MirrorBalls balls = MirrorBalls.of(compiled.parts(), compiled.coincident, compiled.physical, () -> asked[0]++);
        assertSame(expected(compiled), balls);
        int ofAllPairs = n / 1024 * n;
        assertTrue(asked[0] < ofAllPairs / 8, asked[0] + " times; a loop would ask " + ofAllPairs + " times");
    }
}
