package enlightenment.transport.image;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.camera.Camera;
import enlightenment.color.DisplayRgb;
import enlightenment.color.Rgb;
import enlightenment.geometry.Sphere;
import enlightenment.light.Emission;
import enlightenment.light.Light;
import enlightenment.material.Glossy;
import enlightenment.material.Material;
import enlightenment.material.Texture;
import enlightenment.math.ExactPoint;
import enlightenment.math.Vec3;
import enlightenment.primitive.Ray;
import enlightenment.render.TestScenes;
import enlightenment.sampling.SobolSampler;
import enlightenment.scene.RenderSettings;
import enlightenment.scene.Scene;
import enlightenment.scene.Shading;
import enlightenment.transport.path.PathIntegrator;
import enlightenment.world.CompiledScene;
import enlightenment.world.SceneCompiler;
import enlightenment.world.parts.RayCounters;
import java.util.OptionalInt;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/**
 * Caustics of mirror balls that are themselves seen in a mirror, against paths that find them by chance.
 */
class MirrorCausticsTest {
    private static final Texture SILVER = Texture.of(new Rgb(0.9, 0.8, 0.7));
    private static final int SIZE = 8;

    /** A lamp, two balls and a floor, seen in a mirror. */
    private static Scene scene(Material floor, double lamp, Shading.Physical shading, double scale) {
        Scene.Builder scene = Scene.builder()
                .size(SIZE, SIZE)
                .shading(shading)
                .camera(new Camera.Perspective(at(scale, 0, 2, 0), at(scale, 0.8, 8, -0.4), Vec3.Z, 8))
                .object(
                        rectangle(scale, -0.15, 4, -0.55, -0.15, 4, 0.3, 0.7, 4, 0.3, 0.7, 4, -0.55),
                        Material.Mirror.of(Texture.of(new Rgb(1, 1, 1))))
                .object(rectangle(scale, -9, 0, -9, -9, 0, 9, 9, 0, 9, 9, 0, -9), floor)
                .object(new Sphere(at(scale, 1.5, 1, 1), length(scale, 1), 0), Material.Mirror.of(SILVER))
                .object(new Sphere(at(scale, -1.5, 0.75, 1), length(scale, 0.75), 0), Glossy.of(SILVER, 0));
        return scene.light(new Light.Sphere(
                        at(scale, 0, 2.5, -2),
                        length(scale, lamp),
                        DisplayRgb.WHITE,
                        Emission.radiance(new Rgb(9, 7, 5))))
                .build();
    }

    private static double length(double scale, double x) {
        return scale * x;
    }

    private static ExactPoint at(double scale, double x, double y, double z) {
        return ExactPoint.of(scale * x, scale * y, scale * z);
    }

    private static enlightenment.geometry.Shape rectangle(double scale, double... c) {
        for (int i = 0; i < c.length; i++) {
            c[i] *= scale;
        }
        return TestScenes.rectangle(c[0], c[1], c[2], c[3], c[4], c[5], c[6], c[7], c[8], c[9], c[10], c[11]);
    }

    private static final Material GREY = Material.Matte.of(Texture.of(new Rgb(0.6, 0.6, 0.6)));

    /** Mean and variance of the red band's samples by pixel. */
    private record Picture(double[] mean, double[] variance) {
        double sum() {
            double sum = 0;
            for (double m : mean) {
                sum += m;
            }
            return sum / mean.length;
        }

        double variances() {
            double sum = 0;
            for (double v : variance) {
                sum += v;
            }
            return sum / mean.length;
        }
    }

    private static CompiledScene compiled(Scene scene) {
        return SceneCompiler.compile(scene, RenderSettings.of(scene));
    }

    private static Picture render(Scene scene, int samples, long seed, boolean solves) {
        CompiledScene compiled = compiled(scene);
        PathIntegrator tracer = new PathIntegrator(compiled, new RayCounters(compiled.kindNames.size()), solves);
        tracer.beginTile(0, 0, 1, 1);
        SobolSampler sampler = new SobolSampler();
        Ray ray = new Ray();
        double[] out = new double[3];
        Picture picture = new Picture(new double[SIZE * SIZE], new double[SIZE * SIZE]);
        for (int pixel = 0; pixel < SIZE * SIZE; pixel++) {
            sampler.pixel(seed, pixel % SIZE, pixel / SIZE);
            double sum = 0;
            double squares = 0;
            for (int s = 0; s < samples; s++) {
                sampler.sample(s);
                compiled.camera.ray(
                        (pixel % SIZE + sampler.filmX()) / SIZE, (pixel / SIZE + sampler.filmY()) / SIZE, ray);
                tracer.shade(ray, sampler, out);
                sum += out[0];
                squares += out[0] * out[0];
            }
            picture.mean[pixel] = sum / samples;
            picture.variance[pixel] = Math.max(squares / samples - sum * sum / samples / samples, 0) / samples;
        }
        return picture;
    }

    /** Sums over the picture: by chance a pixel finds a handful of such paths. */
    private static void agree(Scene scene, int samples) {
        Picture a = render(scene, samples, 3, true);
        Picture b = render(scene, 2 * samples, 5, false);
        double error = Math.sqrt((a.variances() + b.variances()) / (SIZE * SIZE));
        assertTrue(Math.abs(a.sum() - b.sum()) < 4 * error, () -> a.sum() + ", not " + b.sum() + ", within " + error);
    }

    @ParameterizedTest
    @ValueSource(doubles = {0, 0.5})
    void imagesAndChanceAgree(double roughness) {
        Material floor = ((Material.Matte) GREY).withRoughness(roughness);
        agree(scene(floor, 0.8, Shading.Physical.DEFAULT, 1), 1024);
    }

    @Test
    void imagesAndChanceAgreeOnRoughMetal() {
        Material floor = Glossy.of(Texture.of(new Rgb(0.9, 0.8, 0.7)), 0.5);
        agree(scene(floor, 0.8, Shading.Physical.DEFAULT, 1), 1024);
    }

    @ParameterizedTest
    @ValueSource(ints = {2, 3})
    void imagesAndChanceAgreeWherePathsEndSoon(int bounces) {
        Shading.Physical shading = new Shading.Physical(OptionalInt.of(bounces), Rgb.BLACK);
        agree(scene(GREY, 0.8, shading, 1), 1024);
    }

    @Test
    void ofASmallLampLittleIsLeftToChance() {
        Scene scene = scene(GREY, 0.05, Shading.Physical.DEFAULT, 1);
        double variance = render(scene, 1024, 3, true).variances();
        double byChance = render(scene, 1024, 3, false).variances();
        assertTrue(variance < 1e-3 * byChance, () -> variance + " of " + byChance);
    }

    @ParameterizedTest
    @ValueSource(ints = {-40, 3, 50})
    void aSceneOfAnotherSizeLooksTheSame(int exponent) {
        Picture a = render(scene(GREY, 0.8, Shading.Physical.DEFAULT, 1), 16, 3, true);
        Picture b = render(scene(GREY, 0.8, Shading.Physical.DEFAULT, Math.scalb(1.0, exponent)), 16, 3, true);
        for (int i = 0; i < SIZE * SIZE; i++) {
            assertEquals(a.mean[i], b.mean[i]);
        }
    }
}
