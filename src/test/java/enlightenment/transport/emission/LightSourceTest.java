package enlightenment.transport.emission;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.camera.Camera;
import enlightenment.color.Rgb;
import enlightenment.geometry.Sphere;
import enlightenment.light.Emission;
import enlightenment.light.Light;
import enlightenment.material.Material;
import enlightenment.material.Texture;
import enlightenment.math.ExactPoint;
import enlightenment.math.Vec3;
import enlightenment.primitive.Ray;
import enlightenment.scene.RenderSettings;
import enlightenment.scene.Scene;
import enlightenment.scene.Shading;
import enlightenment.transport.ray.PathSource;
import enlightenment.world.CompiledScene;
import enlightenment.world.LightStarts;
import enlightenment.world.SceneCompiler;
import java.util.OptionalInt;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;

/** Light paths begin as light is emitted, with the densities that they say. */
class LightSourceTest {
    private static final int PATHS = 100_000;

    private static ExactPoint at(double x, double y, double z) {
        return ExactPoint.of(x, y, z);
    }

    private static Scene.Builder scene(double background) {
        return Scene.builder()
                .size(8, 8)
                .camera(new Camera.Perspective(at(0, 0, -4), at(0, 0, 0), Vec3.Y, 40))
                .shading(new Shading.Physical(OptionalInt.empty(), Rgb.gray(background)))
                .light(new Light.Sphere(at(-0.5, 1, 0), 0.2, Rgb.WHITE, Emission.power(Rgb.gray(8))))
                .light(panel(0.5, true, 4))
                .light(panel(1.5, false, 2))
                .light(new Light.Point(at(0, 0.3, 0), Rgb.WHITE, Emission.power(Rgb.gray(1))));
    }

    private static Light panel(double x, boolean twoSided, double power) {
        return new Light.Rectangle(
                at(x, 1, 0),
                at(x, 1, 0.5),
                at(x + 0.7, 1, 0.5),
                at(x + 0.7, 1, 0),
                Rgb.WHITE,
                twoSided,
                Emission.power(Rgb.gray(power)));
    }

    private static CompiledScene compile(Scene.Builder builder) {
        Scene scene = builder.build();
        return SceneCompiler.compile(scene, RenderSettings.of(scene));
    }

    /** Draws paths; returns by light: how many there were, and the sum of their powers. */
    private static double[][] draw(CompiledScene scene, boolean withBackground) {
        LightStarts starts = scene.lightStarts(withBackground);
        LightSource source = new LightSource(starts, scene.physical);
        SplittableRandom random = new SplittableRandom(5);
        double[][] found = new double[2][starts.background + 1];
        double[] numbers = new double[PathSource.NUMBERS];
        Ray ray = new Ray();
        for (int i = 0; i < PATHS; i++) {
            for (int k = 0; k < numbers.length; k++) {
                numbers[k] = random.nextDouble();
            }
            assertTrue(source.emit(numbers, ray));
            found[0][source.light]++;
            found[1][source.light] += source.red;
            assertEquals(1, ray.dd, 1e-12);
            assertEquals(starts.probability(source.light), source.probability);
            assertEquals(starts.pointDensity(source.light), source.pointDensity);
            boolean isPoint = !source.isBackground() && scene.physical.lights[source.light].isPoint;
            assertEquals(
                    isPoint
                            ? starts.directionDensity(source.light, ray.dx, ray.dy, ray.dz)
                            : starts.directionDensity(source.light, source.cosine),
                    source.directionDensity);
            double radiance =
                    source.isBackground() ? scene.physical.backgroundR : scene.physical.lights[source.light].r;
            double density = source.probability * source.pointDensity * source.directionDensity;
            assertEquals(radiance * source.cosine / density, source.red, 1e-12 * source.red);
        }
        return found;
    }

    /** In the frame of a render power is in other units of area, for all lights the same. */
    @Test
    void allPathsBringTheSamePowerAndEachLightSendsAsManyAsItHasPower() {
        CompiledScene scene = compile(scene(0));
        double[][] found = draw(scene, true);
        double all = 0;
        for (double power : found[1]) {
            all += power / PATHS;
        }
        double[] powers = new double[found[0].length];
        for (int l = 0; l < powers.length - 1; l++) {
            powers[l] = Math.rint(15 * found[1][l] / PATHS / all * 10) / 10;
            assertEquals(all, found[1][l] / found[0][l], 1e-9 * all);
            // Five deviations of a binomial distribution.
            assertEquals(found[0][l], powers[l] / 15 * PATHS, 5 * Math.sqrt(found[0][l]));
        }
        java.util.Arrays.sort(powers);
        assertEquals(
                "[0.0, 1.0, 2.0, 4.0, 8.0]", java.util.Arrays.toString(powers).replaceAll("(\\.\\d)\\d*", "$1"));
        assertEquals(0, found[0][found[0].length - 1], "the surroundings are dark");
    }

    @Test
    void theSurroundingsShineThroughABallAroundAllSurfaces() {
        CompiledScene scene = compile(scene(0.5));
        LightStarts starts = scene.lightStarts(true);
        double power = 4 * Math.PI * Math.PI * starts.radius * starts.radius * 0.5;
        double[][] found = draw(scene, true);
        double each = found[1][starts.background] / found[0][starts.background];
        assertEquals(power / starts.probability(starts.background), each, 1e-9 * each);
        assertEquals(0, scene.lightStarts(false).probability(starts.background));
        assertEquals(0, draw(scene, false)[0][starts.background]);
    }

    @Test
    void theInsideOfAGlowingBallCountsOnlyIfTheEyeIsInIt() {
        Material glow = Material.Matte.of(Texture.of(Rgb.gray(0.5))).withRadiance(Rgb.gray(1));
        Scene.Builder lonely = scene(0).object(Sphere.of(at(0, -2, 0), 0.5), glow);
        Scene.Builder filled = scene(0).object(Sphere.of(at(0, -2, 0), 0.5), glow)
                .object(Sphere.of(at(0, -2, 0), 0.2), Material.Matte.of(Texture.of(Rgb.gray(0.5))));
        assertFalse(isAnyBallTwoSided(compile(lonely)));
        assertFalse(isAnyBallTwoSided(compile(filled)));
        Camera within = new Camera.Perspective(at(0, -2, -0.4), at(0, -2, 0), Vec3.Y, 40);
        assertTrue(isAnyBallTwoSided(compile(filled.camera(within))));
    }

    private static boolean isAnyBallTwoSided(CompiledScene scene) {
        LightStarts starts = scene.lightStarts(false);
        boolean any = false;
        for (int l = 0; l < starts.background; l++) {
            any |= scene.physical.lights[l].isBall && starts.shinesBothWays(l);
        }
        return any;
    }

    @Test
    void whereNothingShinesNoPathBegins() {
        Scene dark = Scene.builder()
                .camera(new Camera.Perspective(at(0, 0, -4), at(0, 0, 0), Vec3.Y, 40))
                .shading(Shading.Physical.DEFAULT)
                .build();
        CompiledScene scene = SceneCompiler.compile(dark, RenderSettings.of(dark));
        LightSource source = new LightSource(scene.lightStarts(true), scene.physical);
        assertFalse(source.emit(new double[PathSource.NUMBERS], new Ray()));
    }
}
