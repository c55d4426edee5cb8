package enlightenment.transport.path;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.camera.Camera;
import enlightenment.color.DisplayRgb;
import enlightenment.color.Rgb;
import enlightenment.geometry.Cube;
import enlightenment.geometry.Sphere;
import enlightenment.light.Emission;
import enlightenment.light.Light;
import enlightenment.material.Glass;
import enlightenment.material.Glossy;
import enlightenment.material.Material;
import enlightenment.material.Texture;
import enlightenment.math.ExactPoint;
import enlightenment.math.Vec3;
import enlightenment.primitive.Hit;
import enlightenment.primitive.Ray;
import enlightenment.render.TestScenes;
import enlightenment.sampling.SobolSampler;
import enlightenment.scene.RenderSettings;
import enlightenment.scene.Scene;
import enlightenment.scene.Shading;
import enlightenment.transport.state.PathPart;
import enlightenment.world.CompiledScene;
import enlightenment.world.SceneCompiler;
import enlightenment.world.Tracer;
import enlightenment.world.material.SurfaceMaterial;
import enlightenment.world.parts.RayCounters;
import java.util.Arrays;
import java.util.List;
import java.util.OptionalInt;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Scenes whose radiance is known: closed forms, and the constant surroundings in which nothing lossless can be seen. */
class PathIntegratorTest {
    private static final Shading.Physical IN_WHITE = new Shading.Physical(OptionalInt.empty(), new Rgb(1, 1, 1));

    static Texture grey(double linear) {
        return Texture.of(new Rgb(linear, linear, linear));
    }

    static Scene.Builder scene() {
        return Scene.builder().size(8, 8).shading(Shading.Physical.DEFAULT);
    }

    static Scene.Builder seenFrom(double x, double y, double z, double degrees) {
        return scene().camera(new Camera.Perspective(ExactPoint.of(x, y, z), ExactPoint.of(0, 0, 0), Vec3.Y, degrees));
    }

    /** Mean and standard error of the red band over the picture. */
    record Mean(double value, double error) {
        void agreesWith(double expected) {
            assertTrue(
                    Math.abs(value - expected) <= 4 * error + 1e-12 * expected,
                    () -> value + " ± " + error + ", not " + expected);
        }
    }

    static Mean render(Scene scene, int samples) {
        CompiledScene compiled = SceneCompiler.compile(scene, RenderSettings.of(scene));
        PathIntegrator tracer = new PathIntegrator(compiled, new RayCounters(compiled.kindNames.size()));
        tracer.beginTile(0, 0, 1, 1);
        SobolSampler sampler = new SobolSampler();
        Ray ray = new Ray();
        double[] out = new double[3];
        double sum = 0;
        double squares = 0;
        int n = 64;
        for (int pixel = 0; pixel < n; pixel++) {
            sampler.pixel(5, pixel % 8, pixel / 8);
            double mean = 0;
            for (int s = 0; s < samples; s++) {
                sampler.sample(s);
                compiled.camera.ray((pixel % 8 + sampler.filmX()) / 8, (pixel / 8 + sampler.filmY()) / 8, ray);
                tracer.shade(ray, sampler, out);
                mean += out[0] / samples;
            }
            sum += mean;
            squares += mean * mean;
        }
        double mean = sum / n;
        return new Mean(mean, Math.sqrt(Math.max(squares / n - mean * mean, 0) / (n - 1)));
    }

    /** P04: the radiance of a wall of an integrating sphere, over that of the lamp in its middle. */
    @ParameterizedTest
    @CsvSource({"0.15, 0.5, 0.02200489", "0.15, 0.9, 0.16839917", "0.5, 0.8, 0.5"})
    void theWallOfAnIntegratingSphereIsAsBrightAsTheSeriesSays(double lamp, double albedo, double expected) {
        Scene scene = scene().camera(
                        new Camera.Perspective(ExactPoint.of(0, 0.75, 0.1), ExactPoint.of(0, 1, 0.1), Vec3.Z, 40))
                .object(new Sphere(ExactPoint.of(0, 0, 0), 1, 0), Material.Matte.of(grey(albedo)))
                .light(new Light.Sphere(ExactPoint.of(0, 0, 0), lamp, DisplayRgb.WHITE))
                .build();
        render(scene, 1024).agreesWith(expected);
    }

    /** P06: every surface of a closed box emits 1 and reflects a share. */
    @ParameterizedTest
    @ValueSource(doubles = {0.5, 0.9})
    void aClosedBoxThatGlowsIsAGeometricSeries(double albedo) {
        Material.Matte wall = new Material.Matte(grey(albedo), true).withRadiance(new Rgb(1, 1, 1));
        Scene scene = seenFrom(0.2, 0.3, -0.4, 60)
                .object(new Sphere(ExactPoint.of(0, 0, 0), 1, 0), wall)
                .build();
        render(scene, 512).agreesWith(1 / (1 - albedo));
    }

    /** P09. */
    @Test
    void aPointLightLightsBySquareOfTheDistance() {
        Scene scene = scene().camera(
                        new Camera.Orthographic(ExactPoint.of(0, 1, 0), ExactPoint.of(0, 0, 0), Vec3.Z, 1e-6))
                .object(TestScenes.rectangle(-9, 0, -9, -9, 0, 9, 9, 0, 9, 9, 0, -9), Material.Matte.of(grey(0.5)))
                .light(new Light.Point(ExactPoint.of(3, 4, 0), DisplayRgb.WHITE, Emission.intensity(new Rgb(7, 7, 7))))
                .build();
        assertEquals(0.5 / Math.PI * 7 * (4.0 / 5) / 25, render(scene, 1).value, 1e-8);
    }

    /** P12. */
    @Test
    void aLampIsSeenAsBrightAsItIs() {
        Scene scene = seenFrom(0, 0, -9, 1)
                .light(new Light.Sphere(
                        ExactPoint.of(0, 0, 0), 1, DisplayRgb.WHITE, Emission.radiance(new Rgb(3, 3, 3))))
                .build();
        assertEquals(3, render(scene, 1).value);
    }

    private static final List<Material> LOSSLESS = List.of(
            Material.Matte.of(grey(1)),
            Material.Matte.of(grey(1)).withRoughness(0.7),
            Material.Mirror.of(grey(1)),
            Glass.of(grey(1), 1.5),
            Glass.of(grey(1), 1),
            Glossy.of(grey(1), 0.5));

    /** P05. */
    @ParameterizedTest
    @ValueSource(ints = {0, 1, 2, 3, 4, 5})
    void whatLosesNothingCannotBeSeenInAFurnace(int k) {
        Scene scene = seenFrom(0, 0, -4, 20)
                .shading(IN_WHITE)
                .object(new Sphere(ExactPoint.of(0, 0, 0), 1, 0), LOSSLESS.get(k))
                .build();
        Mean mean = render(scene, 64);
        assertTrue(Math.abs(mean.value - 1) < 4 * mean.error + 2e-3, mean::toString);
    }

    /** P05: all light that a pane reflects or lets pass comes from the same surroundings; what is opaque in part is matte there. */
    @ParameterizedTest
    @ValueSource(doubles = {1, 0.4})
    void aPaneCannotBeSeenInAFurnaceEither(double transparency) {
        Scene scene = seenFrom(0, 1, -4, 20)
                .shading(IN_WHITE)
                .object(
                        TestScenes.rectangle(-9, -9, 0, -9, 9, 0, 9, 9, 0, 9, -9, 0),
                        new Glass(grey(1), 1.5, transparency, 0, true))
                .build();
        assertEquals(1, render(scene, 64).value, 1e-12);
    }

    /** Rough glass loses a little, and the more the rougher. */
    @Test
    void roughGlassLosesLittle() {
        Scene scene = seenFrom(0, 0, -4, 20)
                .shading(IN_WHITE)
                .object(
                        new Sphere(ExactPoint.of(0, 0, 0), 1, 0),
                        Glass.of(grey(1), 1.5).withRoughness(0.3))
                .build();
        double mean = render(scene, 64).value;
        assertTrue(mean > 0.95 && mean < 1.001, () -> "mean " + mean);
    }

    /** Beer and Lambert: a ball of index 1 only absorbs, over the chord. */
    @Test
    void aMediumAbsorbsExponentially() {
        Scene scene = scene().camera(
                        new Camera.Orthographic(ExactPoint.of(0, 0, -8), ExactPoint.of(0, 0, 0), Vec3.Y, 1e-6))
                .shading(IN_WHITE)
                .object(
                        new Sphere(ExactPoint.of(0, 0, 0), 3, 0),
                        Glass.of(grey(1), 1).withAbsorption(new Rgb(0.25, 0, 0)))
                .build();
        assertEquals(Math.exp(-0.25 * 6), render(scene, 1).value, 1e-12);
    }

    /** The cube encloses less than the ball, although the box around it may be larger; it sticks out, but not here. */
    @ParameterizedTest
    @ValueSource(doubles = {0, 45})
    void theSolidOfLessVolumeFillsAnOverlapHoweverItIsTurned(double degrees) {
        Scene scene = scene().camera(
                        new Camera.Orthographic(ExactPoint.of(0, 0, -8), ExactPoint.of(0, 0, 0), Vec3.Y, 1e-6))
                .shading(IN_WHITE)
                .object(
                        new Sphere(ExactPoint.of(0, 0, 0), 1, 0),
                        Glass.of(grey(1), 1).withAbsorption(new Rgb(0.25, 0, 0)))
                .object(
                        new Cube(ExactPoint.of(0, 0, 0), 0.8 * Math.sqrt(3), new Vec3(0, 0, degrees)),
                        Glass.of(grey(1), 1).withAbsorption(new Rgb(1, 0, 0)))
                .build();
        assertEquals(Math.exp(-1.6 - 0.25 * 0.4), render(scene, 1).value, 1e-12);
    }

    /** Direct light only, of a lamp whose upper half a screen hides from the floor or not, found by light sampling or by chance. */
    @ParameterizedTest
    @ValueSource(ints = {1, 2})
    void aLampHidesAnother(int bounces) {
        Scene.Builder builder = scene().camera(
                        new Camera.Orthographic(ExactPoint.of(0, 1, 0), ExactPoint.of(0, 0, 0), Vec3.Z, 1e-6))
                .shading(new Shading.Physical(OptionalInt.of(bounces), Rgb.BLACK))
                .object(TestScenes.rectangle(-9, 0, -9, -9, 0, 9, 9, 0, 9, 9, 0, -9), Material.Matte.of(grey(0.5)))
                .light(new Light.Sphere(ExactPoint.of(0, 9, 0), 1, DisplayRgb.WHITE))
                .light(new Light.Sphere(ExactPoint.of(0, 4, 0), 1, DisplayRgb.WHITE));
        // Seen from there the near lamp covers the far one: irradiance is that of the near one alone.
        assertEquals(0.5 / 16, render(builder.build(), 4).value, 1e-12);
    }

    /** P05, from within: the eye is in the glass, where radiance is greater by the square of its index. */
    @Test
    void theFurnaceIsBrighterFromWithinGlass() {
        Scene scene = seenFrom(0.1, 0.2, -0.1, 60)
                .shading(IN_WHITE)
                .object(new Sphere(ExactPoint.of(0, 0, 0), 1, 0), Glass.of(grey(1), 1.5))
                .build();
        Mean mean = render(scene, 256);
        mean.agreesWith(2.25);
    }

    /** The partner of all that is clever: directions are drawn by rejection, and light counts where it is met. */
    private static double naive(CompiledScene scene, Tracer tracer, Ray ray, SplittableRandom random, int depth) {
        Hit hit = new Hit();
        if (!tracer.trace(ray, hit)) {
            return scene.physical.backgroundR;
        }
        SurfaceMaterial material = scene.material(tracer.id, hit.face);
        double light = material.glows && material.glowsTo(hit.side) ? material.glowR : 0;
        double[] albedo = new double[3];
        material.color(albedo);
        if (depth == 0 || albedo[0] == 0) {
            return light;
        }
        Vec3 n = hit.normal().times(hit.side);
        Vec3 d;
        do {
            d = new Vec3(random.nextDouble(-1, 1), random.nextDouble(-1, 1), random.nextDouble(-1, 1));
        } while (d.lengthSquared() > 1 || d.lengthSquared() == 0);
        // A point of the unit sphere that touches the surface is distributed by the cosine.
        d = d.normalized().plus(n);
        Ray on = Ray.leaving(hit.point(), d, hit.primitive, hit.side);
        return light + albedo[0] * naive(scene, tracer, on, random, depth - 1);
    }

    /** A box of matte walls with a ball, a rectangle that shines to one side, a disk that glows and something in their way. */
    private static Scene room(int bounces) {
        Scene.Builder b = scene().camera(
                        new Camera.Perspective(ExactPoint.of(0, 0, -0.95), ExactPoint.of(0, -0.2, 1), Vec3.Y, 70))
                .shading(new Shading.Physical(OptionalInt.of(bounces), Rgb.BLACK))
                .object(new Cube(ExactPoint.of(0, 0, 0), Math.sqrt(3), Vec3.ZERO), Material.Matte.of(grey(0.6)))
                .object(new Sphere(ExactPoint.of(0.3, -0.5, 0.3), 0.3, 0), Material.Matte.of(grey(0.8)))
                .object(
                        TestScenes.rectangle(0.9, -0.5, -0.5, 0.9, 0.5, -0.5, 0.9, 0.5, 0.5, 0.9, -0.5, 0.5),
                        Material.Matte.of(grey(0.3)).withRadiance(new Rgb(0.5, 0.5, 0.5)))
                .light(new Light.Sphere(ExactPoint.of(-0.4, 0.3, 0.2), 0.25, DisplayRgb.WHITE));
        return b.light(new Light.Rectangle(
                        ExactPoint.of(-0.5, 0.95, 0.5),
                        ExactPoint.of(-0.5, 0.95, -0.5),
                        ExactPoint.of(0.5, 0.95, -0.5),
                        ExactPoint.of(0.5, 0.95, 0.5),
                        DisplayRgb.WHITE,
                        false,
                        Emission.radiance(new Rgb(2, 2, 2))))
                .build();
    }

    @ParameterizedTest
    @ValueSource(ints = {1, 3})
    void theNaivePathTracerAgrees(int bounces) {
        Scene scene = room(bounces);
        CompiledScene compiled = SceneCompiler.compile(scene, RenderSettings.of(scene));
        Tracer tracer = new Tracer(compiled, new RayCounters(compiled.kindNames.size()));
        SplittableRandom random = new SplittableRandom(9);
        Ray ray = new Ray();
        double sum = 0;
        double squares = 0;
        int n = 200_000;
        for (int k = 0; k < n; k++) {
            compiled.camera.ray(random.nextDouble(), random.nextDouble(), ray);
            double l = naive(compiled, tracer, ray, random, bounces);
            sum += l;
            squares += l * l;
        }
        double mean = sum / n;
        double error = Math.sqrt((squares / n - mean * mean) / n);
        double own = render(scene, 256).value;
        assertTrue(Math.abs(own - mean) < 4 * error, () -> own + ", naive " + mean + " ± " + error);
    }

    /** Of the same paths, what is direct does not depend on how many bounces follow: with one bounce it is all there is. */
    @Test
    void withOneBounceAllLightIsDirect() {
        double[] whole = firstValues(room(1), PathPart.WHOLE);
        assertArrayEquals(whole, firstValues(room(1), PathPart.DIRECT));
        assertArrayEquals(whole, firstValues(room(7), PathPart.DIRECT));
        assertFalse(Arrays.equals(whole, firstValues(room(7), PathPart.WHOLE)));
    }

    private static double[] firstValues(Scene scene, PathPart part) {
        CompiledScene compiled = SceneCompiler.compile(scene, RenderSettings.of(scene));
        PathIntegrator tracer = new PathIntegrator(compiled, new RayCounters(compiled.kindNames.size()), part);
        tracer.beginTile(0, 0, 1, 1);
        SobolSampler sampler = new SobolSampler();
        Ray ray = new Ray();
        double[] out = new double[3];
        double[] values = new double[2000];
        for (int k = 0; k < values.length; k++) {
            sampler.pixel(1, k, 0);
            sampler.sample(0);
            compiled.camera.ray(sampler.filmX(), sampler.filmY(), ray);
            tracer.shade(ray, sampler, out);
            values[k] = out[0];
        }
        return values;
    }
}
