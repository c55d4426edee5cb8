package enlightenment.transport.path;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.camera.Camera;
import enlightenment.color.Rgb;
import enlightenment.geometry.Box;
import enlightenment.geometry.Shape;
import enlightenment.geometry.Sphere;
import enlightenment.light.Emission;
import enlightenment.light.Light;
import enlightenment.material.Material;
import enlightenment.material.Medium;
import enlightenment.math.ExactPoint;
import enlightenment.math.Vec3;
import enlightenment.primitive.Ray;
import enlightenment.sampling.SobolSampler;
import enlightenment.scene.RenderSettings;
import enlightenment.scene.Scene;
import enlightenment.scene.Shading;
import enlightenment.world.CompiledScene;
import enlightenment.world.SceneCompiler;
import enlightenment.world.parts.RayCounters;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.SplittableRandom;
import java.util.function.DoubleUnaryOperator;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Media whose light is known: where nothing is lost, exact solutions, single scattering, and numbers at the ends of their ranges. */
class RandomWalkTest {
    /** A path that has had fewer events was not ended by roulette, in a medium that absorbs nothing. */
    private static final int CERTAIN_EVENTS = 64;

    private static final Shape BALL = Sphere.of(ExactPoint.of(0, 0, 0), 1);

    /** Mean and standard error, in a band. */
    private record Mean(double value, double error) {
        void agreesWith(double expected) {
            assertTrue(Math.abs(value - expected) <= 4 * error + 1e-12, () -> this + ", not " + expected);
        }
    }

    /** Paths of a scene. */
    private static final class Paths {
        final CompiledScene compiled;
        final PathIntegrator tracer;
        final SobolSampler sampler = new SobolSampler();
        final Ray ray = new Ray();
        final double[] out = new double[3];
        double events;

        Paths(Scene scene) {
            compiled = SceneCompiler.compile(scene, RenderSettings.of(scene));
            tracer = new PathIntegrator(compiled, new RayCounters(compiled.kindNames.size()));
            tracer.beginTile(0, 0, 1, 1);
        }

        void follow(int pixel, int sample) {
            sampler.pixel(5, pixel % 8, pixel / 8);
            sampler.sample(sample);
            compiled.camera.ray((pixel % 8 + sampler.filmX()) / 8, (pixel / 8 + sampler.filmY()) / 8, ray);
            tracer.shade(ray, sampler, out);
            events += tracer.events();
            for (double v : out) {
                assertTrue(v >= 0 && v < Double.POSITIVE_INFINITY, "not a radiance: " + v);
            }
        }

        /** The means of three bands over 64 pixels. */
        Mean[] means(int samples) {
            double[] sum = new double[3];
            double[] squares = new double[3];
            for (int pixel = 0; pixel < 64; pixel++) {
                double[] mean = new double[3];
                for (int k = 0; k < samples; k++) {
                    follow(pixel, k);
                    for (int band = 0; band < 3; band++) {
                        mean[band] += out[band] / samples;
                    }
                }
                for (int band = 0; band < 3; band++) {
                    sum[band] += mean[band];
                    squares[band] += mean[band] * mean[band];
                }
            }
            events /= 64.0 * samples;
            Mean[] means = new Mean[3];
            for (int band = 0; band < 3; band++) {
                double mean = sum[band] / 64;
                means[band] = new Mean(mean, Math.sqrt(Math.max(squares[band] / 64 - mean * mean, 0) / 63));
            }
            return means;
        }
    }

    private static Medium medium(double scattering, double absorption, double g) {
        return new Medium.Coefficients(Rgb.gray(scattering), Rgb.gray(absorption), g);
    }

    private static Scene.Builder inWhite() {
        return Scene.builder().size(8, 8).shading(new Shading.Physical(OptionalInt.empty(), Rgb.WHITE));
    }

    private static Scene.Builder seenFrom(double distance, double degrees) {
        return inWhite()
                .camera(new Camera.Perspective(
                        ExactPoint.of(0, 0, -distance), ExactPoint.of(0, 0, 0), Vec3.Y, degrees));
    }

    /** One ray through the middle of the view. */
    private static Scene.Builder alongLine(double x, double y, double z, double toX, double toY, double toZ, Vec3 up) {
        return inWhite()
                .camera(new Camera.Orthographic(ExactPoint.of(x, y, z), ExactPoint.of(toX, toY, toZ), up, 1e-6));
    }

    private static Shading.Physical fog(Medium medium, OptionalInt bounces, double background) {
        return new Shading.Physical(
                bounces, new Shading.Background.Constant(Rgb.gray(background)), Optional.of(medium));
    }

    @ParameterizedTest
    @CsvSource({
        "0.01, 0, 1",
        "1, -0.9, 1",
        "30, 0.999, 1",
        "10, 0.5, 1",
        "1, 0, 1.5",
        "10, -0.999, 1.3",
        "3, 0.3, 0.8",
        "5, 0, 1.000000000001",
        "1e9, 0.999, 1",
        "1e-9, -0.5, 1.4"
    })
    void aMediumThatAbsorbsNothingCannotBeSeenInWhite(double sigma, double g, double index) {
        Scene scene = seenFrom(3, 45)
                .object(BALL, new Material.Scattering(medium(sigma, 0, g), index, 0, 0))
                .build();
        Paths paths = new Paths(scene);
        int certain = 0;
        for (int k = 0; k < 1000; k++) {
            paths.follow(k % 64, k / 64);
            if (paths.tracer.events() < CERTAIN_EVENTS) {
                certain++;
                assertEquals(1, paths.out[0], 1e-9);
                assertEquals(1, paths.out[1], 1e-9);
                assertEquals(1, paths.out[2], 1e-9);
            }
        }
        assertTrue(certain > 200, certain + " paths");
        paths.means(16)[0].agreesWith(1);
    }

    /** Rough interfaces give back what single facets lose, in the mean. */
    @ParameterizedTest
    @CsvSource({"2, 0.3, 1.4, 0.3", "5, 0, 1.5, 0.7"})
    void norCanItBehindARoughInterface(double sigma, double g, double index, double roughness) {
        Scene scene = seenFrom(3, 45)
                .object(BALL, new Material.Scattering(medium(sigma, 0, g), index, roughness, 0))
                .build();
        Mean mean = new Paths(scene).means(200)[0];
        assertEquals(1, mean.value, 4 * mean.error + 0.01);
    }

    @Test
    void colouredMediaThatAbsorbNothingCannotBeSeenInWhiteEither() {
        Medium medium = new Medium.Coefficients(new Rgb(0.5, 3, 9), Rgb.BLACK, 0.4);
        for (Mean mean : new Paths(seenFrom(3, 45)
                        .object(BALL, Material.Scattering.of(medium))
                        .build())
                .means(64)) {
            mean.agreesWith(1);
        }
    }

    @ParameterizedTest
    @CsvSource({"0, 2", "0.6, 1.6", "0.8, 1.2"})
    void anAbsorberLeavesTheExponentialOfTheChord(double aside, double chord) {
        Medium ink = new Medium.Coefficients(Rgb.BLACK, new Rgb(0.1, 1, 7), 0);
        Paths paths = new Paths(alongLine(aside, 0, -3, aside, 0, 0, Vec3.Y)
                .object(BALL, Material.Scattering.of(ink))
                .build());
        paths.follow(0, 0);
        assertEquals(Math.exp(-0.1 * chord), paths.out[0], 1e-6);
        assertEquals(Math.exp(-chord), paths.out[1], 1e-6);
        assertEquals(Math.exp(-7 * chord), paths.out[2], 1e-6);
    }

    /** S. Chandrasekhar, "Radiative Transfer", 1960: 1 − sqrt(1 − albedo)·H(cosine). */
    @ParameterizedTest
    @CsvSource({
        "0.5, 1, 0.115226", "0.5, 0.5, 0.160144", "0.5, 0.1, 0.241721",
        "0.9, 1, 0.414947", "0.9, 0.5, 0.507939", "0.9, 0.1, 0.629336",
        "0.99, 1, 0.752721", "0.99, 0.5, 0.815140", "0.99, 0.1, 0.877512"
    })
    void aThickMediumIsAsWhiteAsChandrasekharSays(double albedo, double cosine, double expected) {
        double sine = Math.sqrt(1 - cosine * cosine);
        Scene scene = alongLine(20 * sine, 20 * cosine, 0, 0, 0, 0, Vec3.Z)
                .object(
                        new Box(ExactPoint.of(-1000, -1000, -1000), ExactPoint.of(1000, 0, 1000)),
                        Material.Scattering.of(medium(albedo, 1 - albedo, 0)))
                .build();
        new Paths(scene).means(300)[0].agreesWith(expected);
    }

    /**
     * In light from everywhere ways through a body that absorbs nothing have the mean length 4 V / S, however it scatters (S. Blanco and
     * R. Fournier, 2003). A band that absorbs a little more than another tells the length of each way.
     */
    @ParameterizedTest
    @CsvSource({"0.2, 0", "3, 0", "3, 0.7"})
    void waysThroughABodyHaveTheMeanLengthOfItsChords(double sigma, double g) {
        double absorption = 0.01;
        Material.Scattering matter =
                Material.Scattering.of(new Medium.Coefficients(Rgb.gray(sigma), new Rgb(0, absorption, 0), g));
        Shape box = new Box(ExactPoint.of(-0.5, -0.3, -0.8), ExactPoint.of(0.5, 0.3, 0.8));
        double volume = 1 * 0.6 * 1.6;
        double surface = 2 * (0.6 + 1.6 + 0.6 * 1.6);
        meanWay(matter, BALL, absorption).agreesWith(4.0 / 3);
        meanWay(matter, box, absorption).agreesWith(4 * volume / surface);
    }

    private static Mean meanWay(Material matter, Shape body, double absorption) {
        Paths paths = new Paths(seenFrom(6, 60).object(body, matter).build());
        SplittableRandom random = new SplittableRandom(7);
        double unit = Math.scalb(1.0, -paths.compiled.frame.exponent());
        double sum = 0;
        double squares = 0;
        int n = 0;
        for (int k = 0; n < 40_000; k++) {
            Vec3 d = direction(random);
            Vec3 a = (Math.abs(d.x()) < 0.6 ? Vec3.X : Vec3.Y).cross(d).normalized();
            double angle = 2 * Math.PI * random.nextDouble();
            double radius = Math.sqrt(random.nextDouble());
            Vec3 across = a.times(radius * Math.cos(angle)).plus(d.cross(a).times(radius * Math.sin(angle)));
            Vec3 from = across.minus(d.times(4)).plus(new Vec3(0, 0, 6)).times(unit);
            paths.ray.set(from.x(), from.y(), from.z(), d.x(), d.y(), d.z(), 0);
            paths.sampler.pixel(k, 0, 0);
            paths.tracer.shade(paths.ray, paths.sampler, paths.out);
            double way = paths.out[0] > 0 ? paths.out[0] * Math.log(paths.out[0] / paths.out[1]) / absorption : 0;
            if (paths.out[0] != paths.out[1] || paths.out[0] == 0) {
                n++;
                sum += way;
                squares += way * way;
            }
        }
        double mean = sum / n;
        return new Mean(mean, Math.sqrt((squares / n - mean * mean) / n));
    }

    private static Vec3 direction(SplittableRandom random) {
        double z = 2 * random.nextDouble() - 1;
        double angle = 2 * Math.PI * random.nextDouble();
        double r = Math.sqrt(1 - z * z);
        return new Vec3(r * Math.cos(angle), r * Math.sin(angle), z);
    }

    @Test
    void bandsTogetherAreThreeGreyPictures() {
        double[] scattering = {6, 5, 3};
        double[] absorption = {0.06, 0.2, 0.6};
        Mean[] together = wax(new Medium.Coefficients(new Rgb(6, 5, 3), new Rgb(0.06, 0.2, 0.6), 0.3));
        for (int band = 0; band < 3; band++) {
            Mean alone = wax(medium(scattering[band], absorption[band], 0.3))[band];
            double error = Math.hypot(alone.error, together[band].error);
            new Mean(together[band].value, error).agreesWith(alone.value);
        }
    }

    private static Mean[] wax(Medium medium) {
        Light lamp = new Light.Sphere(ExactPoint.of(1.5, 1.5, -1), 0.4, Rgb.WHITE, Emission.radiance(Rgb.gray(20)));
        return new Paths(seenFrom(3, 45)
                        .shading(new Shading.Physical(OptionalInt.empty(), Rgb.gray(0.1)))
                        .light(lamp)
                        .object(BALL, Material.Scattering.of(medium))
                        .build())
                .means(64);
    }

    /** Light of a point that fog scatters once towards the eye: an integral over the line of sight. */
    @ParameterizedTest
    @CsvSource({"0.2, 0.1, 0", "1, 0, 0.7", "0.5, 0.5, -0.6"})
    void fogAroundAPointLightShinesAsTheIntegralOverTheLineOfSightSays(double scattering, double absorption, double g) {
        Vec3 at = new Vec3(0.7, 0.4, 2);
        double extinction = scattering + absorption;
        DoubleUnaryOperator integrand = t -> {
            Vec3 way = at.minus(new Vec3(0, 0, t));
            double d = way.length();
            double cosine = way.z() / d;
            double phase = (1 - g * g) / (4 * Math.PI * Math.pow(1 + g * g - 2 * g * cosine, 1.5));
            return scattering * phase * Math.exp(-extinction * (t + d)) / (d * d);
        };
        double expected = 0;
        int steps = 400_000;
        for (int k = 0; k < steps; k++) {
            double t = 100 * (k + 0.5) / steps;
            expected += integrand.applyAsDouble(t) * 100 / steps;
        }
        Scene.Builder builder = alongLine(0, 0, 0, 0, 0, 1, Vec3.Y)
                .light(new Light.Point(ExactPoint.of(0.7, 0.4, 2), Rgb.WHITE, Emission.intensity(Rgb.gray(5))));
        Scene once = builder.shading(fog(medium(scattering, absorption, g), OptionalInt.of(1), 3))
                .build();
        new Paths(once).means(256)[1].agreesWith(5 * expected);
        Scene never = builder.shading(fog(medium(scattering, absorption, g), OptionalInt.of(0), 3))
                .build();
        assertEquals(0, new Paths(never).means(1)[1].value);
    }

    /** However long light would wander, the paths that are followed have an end; all of them together lose nothing. */
    @ParameterizedTest
    @CsvSource({"1e-9, 0, 1", "1e-9, 0.999, 1", "1e-9, -0.999, 1.5", "1e-300, 0, 1", "1e9, 0.999, 1.5", "1e300, 0, 1"})
    void pathsEndWhateverTheMeanFreePath(double meanFreePath, double g, double index) {
        Medium medium = new Medium.Colored(Rgb.WHITE, Rgb.gray(meanFreePath), g);
        Paths paths = new Paths(seenFrom(3, 20)
                .object(BALL, new Material.Scattering(medium, index, 0, 0))
                .build());
        Mean mean = paths.means(8)[0];
        assertTrue(paths.events < 3000, paths.events + " events of a path");
        assertEquals(1, mean.value, 4 * mean.error + 0.02);
    }

    @ParameterizedTest
    @CsvSource({"1e-9", "1e-3", "1", "1e3", "1e9", "1e200"})
    void pathsEndInFogWithoutEnd(double meanFreePath) {
        Medium medium = new Medium.Colored(Rgb.WHITE, Rgb.gray(meanFreePath), 0);
        Scene scene = seenFrom(3, 45)
                .shading(fog(medium, OptionalInt.empty(), 1))
                .light(new Light.Sphere(ExactPoint.of(1, 1, 0), 0.2, Rgb.WHITE, Emission.radiance(Rgb.gray(9))))
                .build();
        Paths paths = new Paths(scene);
        paths.means(4);
        assertTrue(paths.events < 20_000, paths.events + " events of a path");
    }
}
