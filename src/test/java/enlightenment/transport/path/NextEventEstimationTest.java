package enlightenment.transport.path;

import static org.junit.jupiter.api.Assertions.assertEquals;

import enlightenment.bsdf.RoughDielectric;
import enlightenment.bsdf.Scattering;
import enlightenment.bsdf.ThinDielectric;
import enlightenment.camera.Camera;
import enlightenment.color.DisplayRgb;
import enlightenment.color.Rgb;
import enlightenment.geometry.Cube;
import enlightenment.geometry.Rectangle;
import enlightenment.geometry.Sphere;
import enlightenment.geometry.Triangle;
import enlightenment.light.Emission;
import enlightenment.light.Light;
import enlightenment.material.Glass;
import enlightenment.material.Material;
import enlightenment.math.ExactPoint;
import enlightenment.math.Vec3;
import enlightenment.render.TestScenes;
import enlightenment.scene.Scene;
import enlightenment.scene.Shading;
import java.util.OptionalInt;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Direct light where surfaces, media and panes make it special: closed forms, and quadrature. */
class PathLightTest {
    private static final Material WHITE_THAT_GLOWS =
            Material.Matte.of(PathIntegratorTest.grey(0.6)).withRadiance(new Rgb(1, 1, 1));

    /** A ray that looks down at the origin of a floor at y = 0, whose albedo is ½, from a height of 1. */
    private static Scene.Builder floor(int bounces) {
        return PathIntegratorTest.scene()
                .camera(new Camera.Orthographic(ExactPoint.of(0, 1, 0), ExactPoint.of(0, 0, 0), Vec3.Z, 1e-6))
                .shading(new Shading.Physical(OptionalInt.of(bounces), Rgb.BLACK))
                .object(
                        TestScenes.rectangle(-9, 0, -9, -9, 0, 9, 9, 0, 9, 9, 0, -9),
                        Material.Matte.of(PathIntegratorTest.grey(0.5)));
    }

    /** Rounding puts a point of a plane that no axis is parallel to above or below it. */
    @Test
    void aFlatSurfaceDoesNotLightItself() {
        Rectangle tilted = TestScenes.rectangle(
                -1.1, -0.9, -0.3, -1.1 + 0.37, 0.9, 0.41, 1.37, 0.73, 0.71, 1.37 - 0.37, 0.73 - 1.8, 0);
        Scene.Builder rectangle = PathIntegratorTest.seenFrom(0.1, 0.2, -5, 9).object(tilted, WHITE_THAT_GLOWS);
        assertEquals(1, PathIntegratorTest.render(rectangle.build(), 64).value(), 1e-12);
        Scene.Builder triangle = PathIntegratorTest.seenFrom(0.1, 0.2, -5, 6)
                .object(
                        new Triangle(
                                ExactPoint.of(-2, -1.3, -0.4),
                                ExactPoint.of(0.3, 2.2, 0.5),
                                ExactPoint.of(2.1, -1.7, 0.7)),
                        WHITE_THAT_GLOWS);
        assertEquals(1, PathIntegratorTest.render(triangle.build(), 64).value(), 1e-12);
    }

    /** Nor do its other faces: a closed room that glows is a geometric series however it is turned. */
    @Test
    void aTiltedCubeThatGlowsIsAsBrightAsOneThatIsNot() {
        Scene.Builder cube = PathIntegratorTest.seenFrom(0.1, 0.2, -0.1, 60)
                .object(new Cube(ExactPoint.of(0, 0, 0), 2, new Vec3(20, 30, 40)), WHITE_THAT_GLOWS);
        PathIntegratorTest.render(cube.build(), 256).agreesWith(1 / (1 - 0.6));
    }

    private static final double SIGMA = 0.4;

    /** A ball of index 1 around everything. */
    private static Scene.Builder mist(int bounces) {
        return floor(bounces)
                .object(
                        new Sphere(ExactPoint.of(0, 0, 0), 30, 0),
                        Glass.of(PathIntegratorTest.grey(1), 1).withAbsorption(new Rgb(SIGMA, 0, 0)));
    }

    @Test
    void mistDimsAPointLight() {
        Scene.Builder scene = mist(1).light(new Light.Point(
                ExactPoint.of(3, 4, 0), DisplayRgb.WHITE, Emission.intensity(new Rgb(7, 7, 7))));
        double expected = 0.5 / Math.PI * 7 * (4.0 / 5) / 25 * Math.exp(-SIGMA * (5 + 1));
        assertEquals(expected, PathIntegratorTest.render(scene.build(), 1).value(), 1e-8);
    }

    @Test
    void mistDimsABall() {
        double distance = 3;
        double radius = 1.5;
        double irradiance = 0;
        int n = 100_000;
        for (int k = 0; k < n; k++) {
            // Evenly in the squared sine of the angle: by the cosine.
            double sine2 = (k + 0.5) / n * radius * radius / (distance * distance);
            double length = distance * Math.sqrt(1 - sine2) - Math.sqrt(radius * radius - distance * distance * sine2);
            irradiance += Math.PI * radius * radius / (distance * distance) / n * Math.exp(-SIGMA * length);
        }
        double expected = 0.5 / Math.PI * irradiance * Math.exp(-SIGMA);
        for (int bounces = 1; bounces < 3; bounces++) {
            Scene.Builder scene =
                    mist(bounces).light(new Light.Sphere(ExactPoint.of(0, distance, 0), radius, DisplayRgb.WHITE));
            PathIntegratorTest.render(scene.build(), 256).agreesWith(expected);
        }
    }

    private static double dimmedRectangle() {
        double irradiance = 0;
        int n = 1000;
        for (int i = 0; i < n; i++) {
            for (int k = 0; k < n; k++) {
                double x = -1 + 2 * (i + 0.5) / n;
                double z = -1 + 2 * (k + 0.5) / n;
                double d2 = x * x + 9 + z * z;
                irradiance += 4.0 / n / n * 9 / (d2 * d2) * Math.exp(-SIGMA * Math.sqrt(d2));
            }
        }
        return 0.5 / Math.PI * irradiance * Math.exp(-SIGMA);
    }

    @ParameterizedTest
    @ValueSource(ints = {1, 2})
    void mistDimsARectangle(int bounces) {
        Scene.Builder scene = mist(bounces)
                .light(new Light.Rectangle(
                        ExactPoint.of(-1, 3, 1),
                        ExactPoint.of(-1, 3, -1),
                        ExactPoint.of(1, 3, -1),
                        ExactPoint.of(1, 3, 1),
                        DisplayRgb.WHITE));
        PathIntegratorTest.render(scene.build(), 256).agreesWith(dimmedRectangle());
    }

    private static final double TINT = 0.8;

    /** A pane between the floor and what is above 2. */
    private static Scene.Builder underPane(int bounces) {
        return floor(bounces)
                .object(
                        TestScenes.rectangle(-9, 2, -9, -9, 2, 9, 9, 2, 9, 9, 2, -9),
                        Glass.of(PathIntegratorTest.grey(TINT), 1.5));
    }

    private static double passes(double cosine) {
        return TINT * ThinDielectric.transmittance(cosine, 1 / 1.5);
    }

    @Test
    void aPointLightShinesThroughAPane() {
        Scene.Builder scene = underPane(1)
                .light(new Light.Point(ExactPoint.of(3, 4, 0), DisplayRgb.WHITE, Emission.intensity(new Rgb(7, 7, 7))));
        double expected = 0.5 / Math.PI * 7 * (4.0 / 5) / 25 * passes(0.8);
        assertEquals(expected, PathIntegratorTest.render(scene.build(), 1).value(), 1e-8);
    }

    @ParameterizedTest
    @ValueSource(ints = {1, 2})
    void aBallShinesThroughAPane(int bounces) {
        double irradiance = 0;
        int n = 100_000;
        for (int k = 0; k < n; k++) {
            double sine2 = (k + 0.5) / n * 0.25;
            irradiance += Math.PI * 0.25 / n * passes(Math.sqrt(1 - sine2));
        }
        Scene.Builder scene = underPane(bounces).light(new Light.Sphere(ExactPoint.of(0, 4, 0), 2, DisplayRgb.WHITE));
        PathIntegratorTest.render(scene.build(), 256).agreesWith(0.5 / Math.PI * irradiance);
    }

    @ParameterizedTest
    @ValueSource(ints = {1, 2})
    void aRectangleShinesThroughAPane(int bounces) {
        double irradiance = 0;
        int n = 1000;
        for (int i = 0; i < n; i++) {
            for (int k = 0; k < n; k++) {
                double x = -1 + 2 * (i + 0.5) / n;
                double z = -1 + 2 * (k + 0.5) / n;
                double d2 = x * x + 9 + z * z;
                irradiance += 4.0 / n / n * 9 / (d2 * d2) * passes(3 / Math.sqrt(d2));
            }
        }
        Scene.Builder scene = underPane(bounces)
                .light(new Light.Rectangle(
                        ExactPoint.of(-1, 3, 1),
                        ExactPoint.of(-1, 3, -1),
                        ExactPoint.of(1, 3, -1),
                        ExactPoint.of(1, 3, 1),
                        DisplayRgb.WHITE));
        PathIntegratorTest.render(scene.build(), 256).agreesWith(0.5 / Math.PI * irradiance);
    }

    /** A ball of index 1 absorbs along a diameter, and another lies behind the light. */
    @Test
    void aShadowRayPassesMediaThatDoNotTurnIt() {
        Material mist = Glass.of(PathIntegratorTest.grey(1), 1).withAbsorption(new Rgb(SIGMA, 0, 0));
        Scene.Builder scene = floor(1).object(new Sphere(ExactPoint.of(1.5, 2, 0), 0.5, 0), mist)
                .object(new Sphere(ExactPoint.of(6, 8, 0), 0.5, 0), mist)
                .light(new Light.Point(ExactPoint.of(3, 4, 0), DisplayRgb.WHITE, Emission.intensity(new Rgb(7, 7, 7))));
        double expected = 0.5 / Math.PI * 7 * (4.0 / 5) / 25 * Math.exp(-SIGMA);
        assertEquals(expected, PathIntegratorTest.render(scene.build(), 1).value(), 1e-8);
    }

    /** A pane is no scattering event. */
    @Test
    void aLampIsSeenThroughAPaneWithoutAnyBounce() {
        Scene.Builder scene = PathIntegratorTest.scene()
                .camera(new Camera.Orthographic(ExactPoint.of(0, 1, 0), ExactPoint.of(0, 4, 0), Vec3.Z, 1e-6))
                .shading(new Shading.Physical(OptionalInt.of(0), Rgb.BLACK))
                .object(
                        TestScenes.rectangle(-9, 2, -9, -9, 2, 9, 9, 2, 9, 9, 2, -9),
                        Glass.of(PathIntegratorTest.grey(1), 1.5))
                .light(new Light.Sphere(ExactPoint.of(0, 4, 0), 1, DisplayRgb.WHITE));
        double expected = ThinDielectric.transmittance(1, 1 / 1.5);
        double mean = PathIntegratorTest.render(scene.build(), 1024).value();
        assertEquals(expected, mean, 0.005);
    }

    /** The lamp is seen as the integral of the lobes over the directions to it says. */
    @ParameterizedTest
    @ValueSource(doubles = {0.3, 0.6, 1})
    void aLampIsSeenThroughRoughGlassAsItsLobesSay(double roughness) {
        // The eye is in the glass and looks up at its interface.
        Scene.Builder scene = PathIntegratorTest.scene()
                .camera(new Camera.Orthographic(ExactPoint.of(-0.3, -1, 0), ExactPoint.of(0, 0, 0), Vec3.Z, 1e-6))
                .shading(new Shading.Physical(OptionalInt.of(1), Rgb.BLACK))
                .object(
                        new Cube(ExactPoint.of(0, -9, 0), 9 * Math.sqrt(3), Vec3.ZERO),
                        Glass.of(PathIntegratorTest.grey(1), 1.5).withRoughness(roughness))
                .light(new Light.Sphere(ExactPoint.of(0, 3, 0), 2, DisplayRgb.WHITE));
        RoughDielectric bsdf = new RoughDielectric(roughness * roughness, true);
        Scattering s = new Scattering();
        double length = Math.sqrt(0.3 * 0.3 + 1);
        s.ox = -0.3 / length;
        s.oy = -1 / length;
        s.ny = -1;
        s.eta = 1.5;
        s.radiance = true;
        double sum = 0;
        int n = 1000;
        double height = 1 - Math.sqrt(1 - 4.0 / 9);
        for (int i = 0; i < n; i++) {
            for (int k = 0; k < n; k++) {
                s.iy = 1 - height * (i + 0.5) / n;
                double sine = Math.sqrt(1 - s.iy * s.iy);
                s.ix = sine * Math.cos(2 * Math.PI * (k + 0.5) / n);
                s.iz = sine * Math.sin(2 * Math.PI * (k + 0.5) / n);
                bsdf.evaluate(s);
                sum += s.valueR;
            }
        }
        PathIntegratorTest.render(scene.build(), 256).agreesWith(sum / n / n * 2 * Math.PI * height);
    }
}
