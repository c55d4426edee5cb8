package enlightenment.physical;

import static enlightenment.physical.PhysicalScenes.at;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.camera.Camera;
import enlightenment.color.Rgb;
import enlightenment.geometry.Box;
import enlightenment.image.Image;
import enlightenment.light.Emission;
import enlightenment.light.Light;
import enlightenment.material.Material;
import enlightenment.material.Medium;
import enlightenment.math.Vec3;
import enlightenment.render.TestScenes;
import enlightenment.scene.BuiltInMethod;
import enlightenment.scene.RenderSettings;
import enlightenment.scene.Scene;
import enlightenment.scene.Shading;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.function.DoubleUnaryOperator;
import java.util.function.ToDoubleFunction;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.EnumSource;

/**
 * Light of lamps that fog scatters once into a line of sight, along the z axis from the origin, against integrals over that line; and its
 * scatter, which has to be small however near to a lamp the line passes.
 */
class FogLampsTest {
    private static final int SEEDS = 32;
    private static final int SAMPLES = 3;
    private static final int PIXELS = 4;
    private static final Rgb SCATTERING = new Rgb(0.3, 0.2, 0.5);
    private static final Rgb ABSORPTION = new Rgb(0, 0.4, 0.1);
    private static final double INTENSITY = 5;
    private static final double[] S = {SCATTERING.r(), SCATTERING.g(), SCATTERING.b()};
    private static final double[] T = {
        SCATTERING.r() + ABSORPTION.r(), SCATTERING.g() + ABSORPTION.g(), SCATTERING.b() + ABSORPTION.b()
    };

    private static Medium fog(double g) {
        return new Medium.Coefficients(SCATTERING, ABSORPTION, g);
    }

    private static Scene.Builder looking() {
        return Scene.builder()
                .size(PIXELS, PIXELS)
                .camera(new Camera.Orthographic(at(0, 0, 0), at(0, 0, 1), Vec3.Y, 1e-9));
    }

    private static Shading.Physical once(Medium around) {
        return new Shading.Physical(
                OptionalInt.of(1), new Shading.Background.Constant(Rgb.BLACK), Optional.ofNullable(around));
    }

    private static Light point(double x, double y, double z) {
        return new Light.Point(at(x, y, z), Rgb.WHITE, Emission.intensity(Rgb.gray(INTENSITY)));
    }

    /** The integral of f over t from a to b, by the angle that a place h beside the line at z sees it under. */
    private static double along(double a, double b, double z, double h, DoubleUnaryOperator f) {
        double from = Math.atan2(a - z, h);
        double to = b == Double.POSITIVE_INFINITY ? Math.PI / 2 : Math.atan2(b - z, h);
        int steps = 4000;
        double sum = 0;
        for (int k = 0; k < steps; k++) {
            double tangent = Math.tan(from + (to - from) * (k + 0.5) / steps);
            sum += f.applyAsDouble(z + h * tangent) * h * (1 + tangent * tangent);
        }
        return sum * (to - from) / steps;
    }

    private static double phase(double g, double cosine) {
        return (1 - g * g) / (4 * Math.PI * Math.pow(1 + g * g - 2 * g * cosine, 1.5));
    }

    /** What comes in a band from a point light at (h, 0, z) that is scattered between a and b. */
    private static double ofPoint(int band, double g, double h, double z, double a, double b) {
        return INTENSITY
                * along(a, b, z, h, t -> {
                    double d = Math.hypot(h, z - t);
                    return S[band] * phase(g, (z - t) / d) * Math.exp(-T[band] * (t + d)) / (d * d);
                });
    }

    /** By band: the mean of each picture. */
    private static double[][] means(Scene scene, BuiltInMethod method) {
        RenderSettings settings = RenderSettings.of(scene).withMethod(method).withAntialias(SAMPLES);
        List<Image> pictures = Rendered.seeds(scene, settings, 1, SEEDS);
        double[][] means = new double[3][];
        for (int band = 0; band < 3; band++) {
            means[band] = Rendered.means(pictures, 0, 0, PIXELS, PIXELS, band);
        }
        return means;
    }

    /** @param share of the light that the standard error must be less than, of all pictures with their 4608 samples together */
    private static void agree(Scene scene, BuiltInMethod method, double share, ToDoubleFunction<Integer> expected) {
        double[][] means = means(scene, method);
        for (int band = 0; band < 3; band++) {
            Statistics found = Statistics.of(means[band]);
            double wanted = expected.applyAsDouble(band);
            String told = "band " + band + ": " + found + " instead of " + wanted;
            assertEquals(wanted, found.mean(), 4.5 * found.error() + 1e-5 * wanted, told);
            assertTrue(found.error() < share * wanted, told);
        }
    }

    @ParameterizedTest
    @CsvSource({"0, 0.5", "0, 0.01", "0, 1e-4", "0.9, 0.2", "0.9, 0.01", "-0.9, 0.2", "-0.9, 0.001", "0.5, 0.001"})
    void fogAroundAPointLightShinesAsTheIntegralSaysHoweverNearTheLinePasses(double g, double h) {
        Scene scene = looking().shading(once(fog(g))).light(point(h, 0, 2)).build();
        double share = Math.abs(g) == 0.9 ? 0.04 : 0.02;
        agree(scene, BuiltInMethod.RAYTRACE, share, band -> ofPoint(band, g, h, 2, 0, Double.POSITIVE_INFINITY));
    }

    @ParameterizedTest
    @EnumSource(
            value = BuiltInMethod.class,
            names = {"CLUSTER", "METROPOLIS", "BIDIRECTIONAL"})
    void allMethodsFindThatIntegral(BuiltInMethod method) {
        Scene scene = looking().shading(once(fog(0.3))).light(point(0.1, 0, 2)).build();
        agree(scene, method, 0.2, band -> ofPoint(band, 0.3, 0.1, 2, 0, Double.POSITIVE_INFINITY));
    }

    /** A light behind the eye, and one behind the end of the flights, at a wall. */
    @Test
    void lightOutsideOfTheSegmentCounts() {
        agree(
                looking().shading(once(fog(0))).light(point(0.05, 0, -0.05)).build(),
                BuiltInMethod.RAYTRACE,
                0.02,
                band -> ofPoint(band, 0, 0.05, -0.05, 0, Double.POSITIVE_INFINITY));
        Scene ended = looking()
                .shading(once(fog(0)))
                .light(point(0.1, 0, 1.1))
                .object(
                        TestScenes.rectangle(-1, -1, 1, -1, 1, 1, 0.05, 1, 1, 0.05, -1, 1),
                        PhysicalScenes.matte(0, 0, 0))
                .build();
        // The wall hides the light from where the way to it crosses z = 1 to the left of its edge: from t = 0.9 on.
        agree(ended, BuiltInMethod.RAYTRACE, 0.05, band -> ofPoint(band, 0, 0.1, 1.1, 0, 0.9));
    }

    /** The eye and, in the second case, the light are outside of the fog, which has no index of its own. */
    @ParameterizedTest
    @CsvSource({"0.02, 0", "0.02, 0.9", "1.25, 0.4"})
    void fogInABoxShinesToo(double h, double g) {
        Scene scene = looking()
                .shading(once(null))
                .light(point(h, 0, 2))
                .object(new Box(at(-1, -1, 1), at(1, 1, 3)), Material.Scattering.of(fog(g)))
                .build();
        double inside = Math.min(1 / h, 1);
        agree(
                scene,
                BuiltInMethod.RAYTRACE,
                0.06,
                band -> INTENSITY
                        * along(1, 3, 2, h, t -> {
                            double d = Math.hypot(h, 2 - t);
                            double way = t - 1 + inside * d;
                            return S[band] * phase(g, (2 - t) / d) * Math.exp(-T[band] * way) / (d * d);
                        }));
    }

    @Test
    void aWallThrowsItsShadowIntoTheFog() {
        // It hides the light from the line up to t = 1.
        Scene scene = looking()
                .shading(once(fog(0)))
                .light(point(0.02, 0, 2))
                .object(
                        TestScenes.rectangle(0.01, -1, -9, 0.01, -1, 1.5, 0.01, 1, 1.5, 0.01, 1, -9),
                        PhysicalScenes.matte(0, 0, 0))
                .build();
        agree(scene, BuiltInMethod.RAYTRACE, 0.02, band -> ofPoint(band, 0, 0.02, 2, 1, Double.POSITIVE_INFINITY));
    }

    @Test
    void ofManyLampsEachCounts() {
        for (int count : new int[] {3, 20}) {
            Scene.Builder builder = looking().shading(once(fog(0)));
            List<double[]> places = new ArrayList<>();
            for (int k = 0; k < count; k++) {
                double[] place = {0.003 * (1 + k * k % 7), 0.2 + 0.35 * k};
                places.add(place);
                builder.light(point(k % 2 == 0 ? place[0] : -place[0], 0, place[1]));
            }
            agree(builder.build(), BuiltInMethod.RAYTRACE, count > 16 ? 0.1 : 0.03, band -> places.stream()
                    .mapToDouble(p -> ofPoint(band, 0, p[0], p[1], 0, Double.POSITIVE_INFINITY))
                    .sum());
        }
    }

    /** Phase function, gathering and flights find a small ball together; the rays to it are summed by their angle with its axis. */
    @ParameterizedTest
    @CsvSource({"0, 0.12", "0, 0.5", "0.9, 0.15", "-0.9, 0.15"})
    void ballsShineIntoTheFog(double g, double h) {
        double radius = 0.1;
        double radiance = 40;
        Scene scene = looking()
                .shading(once(fog(g)))
                .light(new Light.Sphere(at(h, 0, 1.5), radius, Rgb.WHITE, Emission.radiance(Rgb.gray(radiance))))
                .build();
        agree(
                scene,
                BuiltInMethod.RAYTRACE,
                0.05,
                band -> radiance
                        * along(0, Double.POSITIVE_INFINITY, 1.5, h, t -> {
                            double d = Math.hypot(h, 1.5 - t);
                            return S[band] * Math.exp(-T[band] * t) * ofBall(band, g, d, (1.5 - t) / d, radius);
                        }));
    }

    private static double ofBall(int band, double g, double d, double cosine, double radius) {
        double most = Math.asin(radius / d);
        double sine = Math.sqrt(1 - cosine * cosine);
        int rings = 24;
        int spokes = 12;
        double sum = 0;
        for (int i = 0; i < rings; i++) {
            // The squares of angles are even: the distance has a root at the ball's outline.
            double u = (i + 0.5) / rings;
            double angle = most * (1 - u * u);
            double distance = d * Math.cos(angle) - Math.sqrt(Math.pow(radius, 2) - Math.pow(d * Math.sin(angle), 2));
            for (int k = 0; k < spokes; k++) {
                double turn = Math.PI * (k + 0.5) / spokes;
                double c = Math.cos(angle) * cosine + Math.sin(angle) * sine * Math.cos(turn);
                sum += phase(g, c) * Math.exp(-T[band] * distance) * Math.sin(angle) * 2 * u * most;
            }
        }
        return sum * 2 * Math.PI / (rings * spokes);
    }

    @ParameterizedTest
    @CsvSource({"0", "0.6"})
    void aRectangleShinesIntoTheFog(double g) {
        double radiance = 3;
        Scene scene = looking()
                .shading(once(fog(g)))
                .light(new Light.Rectangle(
                        at(0.1, -0.2, 1),
                        at(0.1, 0.2, 1),
                        at(0.1, 0.2, 1.6),
                        at(0.1, -0.2, 1.6),
                        Rgb.WHITE,
                        true,
                        Emission.radiance(Rgb.gray(radiance))))
                .build();
        agree(
                scene,
                BuiltInMethod.RAYTRACE,
                0.05,
                band -> radiance
                        * along(0, Double.POSITIVE_INFINITY, 1.3, 0.1, t -> {
                            int n = 40;
                            double sum = 0;
                            for (int i = 0; i < n * n; i++) {
                                double y = -0.2 + 0.4 * (i % n + 0.5) / n;
                                double z = 1 + 0.6 * (i / n + 0.5) / n - t;
                                double d = Math.sqrt(0.01 + y * y + z * z);
                                sum += phase(g, z / d) * Math.exp(-T[band] * d) * 0.1 / (d * d * d);
                            }
                            return S[band] * Math.exp(-T[band] * t) * sum * 0.24 / (n * n);
                        }));
    }

    /** Four times as many samples have half the error, which is measured over seeds: so it is with a finite variance, and seldom without. */
    @Test
    void theErrorNearAPointFallsAsThatOfAFiniteVariance() {
        Scene scene = looking().shading(once(fog(0))).light(point(1e-3, 0, 2)).build();
        RenderSettings settings = RenderSettings.of(scene).withMethod(BuiltInMethod.RAYTRACE);
        double few = error(scene, settings.withAntialias(2));
        double many = error(scene, settings.withAntialias(8));
        assertTrue(many < few / 2, many + " after " + few);
    }

    private static double error(Scene scene, RenderSettings settings) {
        return Statistics.of(Rendered.means(Rendered.seeds(scene, settings, 1, SEEDS), 0, 0, PIXELS, PIXELS, 0))
                .error();
    }
}
