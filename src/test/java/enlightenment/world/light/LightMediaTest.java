package enlightenment.world.light;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.camera.Camera;
import enlightenment.color.Rgb;
import enlightenment.geometry.Box;
import enlightenment.geometry.Rectangle;
import enlightenment.geometry.Shape;
import enlightenment.geometry.Sphere;
import enlightenment.light.Emission;
import enlightenment.light.Light;
import enlightenment.material.Glass;
import enlightenment.material.Material;
import enlightenment.material.Texture;
import enlightenment.math.ExactPoint;
import enlightenment.math.Vec3;
import enlightenment.scene.RenderSettings;
import enlightenment.scene.Scene;
import enlightenment.scene.Shading;
import enlightenment.world.CompiledScene;
import enlightenment.world.LightStarts;
import enlightenment.world.SceneCompiler;
import enlightenment.world.material.FaceMaterials;
import enlightenment.world.parts.CompiledPrimitives;
import enlightenment.world.parts.Polls;
import java.util.Arrays;
import java.util.List;
import java.util.OptionalInt;
import java.util.SplittableRandom;
import java.util.concurrent.CancellationException;
import org.junit.jupiter.api.Test;

/** The solids of glass around lights, found by a hierarchy of boxes, against a loop over all of them. */
class LightMediaTest {
    private static final Texture WHITE = Texture.of(Rgb.WHITE);
    private static final Material MATTE = Material.Matte.of(WHITE);
    private static final Material GLASS = Glass.of(WHITE, 1.5);
    private static final Material GLOW =
            Material.Matte.of(Texture.of(Rgb.BLACK)).withRadiance(Rgb.WHITE);

    private static Scene.Builder empty() {
        return Scene.builder()
                .camera(new Camera.Perspective(ExactPoint.of(0, 0, -9), ExactPoint.of(0, 0, 0), Vec3.Y, 60))
                .shading(new Shading.Physical(OptionalInt.empty(), Rgb.BLACK));
    }

    /** Shapes at places of a coarse grid: boxes around many of them touch. */
    private static Shape shape(SplittableRandom r) {
        double s = 1 + r.nextInt(3);
        double x = r.nextInt(8);
        double y = r.nextInt(8);
        double z = r.nextInt(8);
        return switch (r.nextInt(3)) {
            case 0 -> new Box(ExactPoint.of(x, y, z), ExactPoint.of(x + s, y + 1, z + 1));
            case 1 -> Sphere.of(ExactPoint.of(x, y, z), s / 2);
            default ->
                new Rectangle(
                        ExactPoint.of(x, y, z),
                        ExactPoint.of(x, y + 1, z),
                        ExactPoint.of(x + s, y + 1, z),
                        ExactPoint.of(x + s, y, z));
        };
    }

    private static Scene random(long seed) {
        SplittableRandom r = new SplittableRandom(seed);
        Scene.Builder b = empty();
        for (int k = 0; k < 60; k++) {
            int kind = r.nextInt(4);
            b.object(shape(r), kind == 0 ? GLOW : kind == 1 ? MATTE : GLASS);
        }
        for (int k = 0; k < 8; k++) {
            ExactPoint at = ExactPoint.of(r.nextInt(8), r.nextInt(8) + 0.5, r.nextInt(8));
            b.light(new Light.Point(at, Rgb.WHITE, Emission.power(Rgb.WHITE)));
        }
        return b.build();
    }

    @Test
    void theSolidsAroundALightAreThoseThatALoopOverAllGlassFinds() {
        int found = 0;
        for (long seed = 1; seed <= 30; seed++) {
            Scene scene = random(seed);
            CompiledScene compiled = SceneCompiler.compile(scene, RenderSettings.of(scene), seed % 4 != 0);
            LightStarts starts = compiled.lightStarts(false);
            PhysicalLight[] lights = compiled.physical.lights;
            for (int i = 0; i < lights.length; i++) {
                PhysicalLight light = lights[i];
                int[] expected = Arrays.stream(compiled.glassSolids)
                        .filter(id -> compiled.primitives[id].bounds().overlaps(light.bounds()))
                        .toArray();
                assertArrayEquals(expected, starts.mediaAround(i));
                assertArrayEquals(expected, compiled.physical.caustics.mediaAround(i));
                found += expected.length;
            }
        }
        assertTrue(found > 1000, found + " solids");
    }

    /** Points and solids apart from each other, the points below them. */
    private static Scene grid(Material material, int n) {
        Scene.Builder b = empty();
        for (int k = 0; k < n; k++) {
            b.object(Sphere.of(ExactPoint.of(k % 64, k / 64, 0), 0.25), material);
            b.light(new Light.Point(ExactPoint.of(k % 64, k / 64, -1), Rgb.WHITE, Emission.power(Rgb.WHITE)));
        }
        return b.build();
    }

    private static int asked(CompiledScene scene, int patience) {
        CompiledPrimitives compiled = new CompiledPrimitives(
                scene.primitives,
                new FaceMaterials(scene.primitives.length, id -> List.of(scene.material(id, 0))),
                scene.kind,
                scene.kindNames,
                scene.glassSolids,
                scene.object,
                scene.objects,
                scene.mediumRank);
        return Polls.of(
                patience,
                ends -> LightMedia.find(scene.physical.lights, compiled, scene.accelerator, () -> {
                    if (ends.getAsBoolean()) {
                        throw new CancellationException();
                    }
                }));
    }

    /** A step for each light, and for each primitive of a leaf or two that a point may be near: a loop would take n². */
    @Test
    void itEndsWhereverItIsAskedAndIsFarFromLookingAtAllSolidsForEachLight() {
        int n = 4096;
        Scene scene = grid(GLASS, n);
        CompiledScene compiled = SceneCompiler.compile(scene, RenderSettings.of(scene));
        int all = asked(compiled, Polls.NEVER);
        assertTrue(all >= n / 1024 && all <= n / 1024 * 20, all + " times");
        for (int patience = 1; patience <= all; patience++) {
            assertEquals(patience, asked(compiled, patience));
        }
    }
}
