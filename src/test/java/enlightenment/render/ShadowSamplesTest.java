package enlightenment.render;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.camera.Camera;
import enlightenment.color.DisplayRgb;
import enlightenment.geometry.Sphere;
import enlightenment.image.Image;
import enlightenment.light.Light;
import enlightenment.math.ExactPoint;
import enlightenment.math.Vec3;
import enlightenment.sampling.RunningStatistics;
import enlightenment.scene.BuiltInMethod;
import enlightenment.scene.RenderSettings;
import enlightenment.scene.Scene;
import enlightenment.scene.Shading;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

/** One light point per hit is as true as a million, only noisier (numerics, N34). */
class ShadowSamplesTest {
    private static final int RENDERS = 10_000;
    private static final int MILLION = 1_000_000;

    /** What shines on the floor's half shadow. */
    enum Lamp {
        SPHERE(new Light.Sphere(ExactPoint.of(0, 4, 0), 1, DisplayRgb.WHITE)),
        RECTANGLE(new Light.Rectangle(
                ExactPoint.of(-1, 4, -1),
                ExactPoint.of(-1, 4, 1),
                ExactPoint.of(1, 4, 1),
                ExactPoint.of(1, 4, -1),
                DisplayRgb.WHITE));

        final Light light;

        Lamp(Light light) {
            this.light = light;
        }
    }

    /** One pixel, so narrow that it is one point of the half shadow on a floor. */
    private static Scene scene(Lamp lamp) {
        return Scene.builder()
                .size(1, 1)
                .camera(new Camera.Perspective(ExactPoint.of(3, 2, -3), ExactPoint.of(0.9, 0, 0.1), Vec3.Y, 1e-9))
                .shading(new Shading.Classic(0, 0, DisplayRgb.BLACK, 4))
                .object(TestScenes.rectangle(-9, 0, -9, -9, 0, 9, 9, 0, 9, 9, 0, -9), TestScenes.matte(1, 1, 1))
                .object(Sphere.of(ExactPoint.of(0, 2, 0), 0.8), TestScenes.matte(1, 1, 1))
                .light(lamp.light)
                .build();
    }

    private static double render(Scene scene, int shadowSamples, long seed) {
        RenderSettings settings = RenderSettings.of(scene)
                .withAntialias(1)
                .with(new BuiltInMethod.RayTraceSettings(shadowSamples))
                .withThreads(1)
                .withSeed(seed);
        Image image = Renderer.render(scene, settings);
        return image.component(0, 0, 0);
    }

    @ParameterizedTest
    @EnumSource(Lamp.class)
    void tenThousandRendersOfOneLightPointAgreeWithAMillionPoints(Lamp lamp) {
        Scene scene = scene(lamp);
        double truth = render(scene, MILLION, 1);
        RunningStatistics singles = new RunningStatistics();
        for (int i = 0; i < RENDERS; i++) {
            singles.add(render(scene, 1, i));
        }
        assertTrue(truth > 0.1 && truth < 0.9, truth + " is a half shadow");
        assertTrue(singles.standardDeviation() > 0.1, "single light points differ");
        double sigmas = (singles.mean() - truth) / singles.standardError();
        assertTrue(Math.abs(sigmas) <= 4, "off by " + sigmas + " sigma");
    }

    /** Independent light points: the root mean square error of a mean of n is that of one over √n. */
    @Test
    void theErrorOfMeansFallsWithTheRootOfTheirNumber() {
        Scene scene = scene(Lamp.SPHERE);
        double truth = render(scene, MILLION, 1);
        int renders = 1 << 13;
        double[] means = new double[renders];
        for (int i = 0; i < renders; i++) {
            means[i] = render(scene, 1, MILLION + i);
        }
        // The line through the logarithms of n = 1, 2, 4, ..., 128 and of the error, by least squares.
        int steps = 8;
        double sx = 0;
        double sy = 0;
        double sxx = 0;
        double sxy = 0;
        for (int k = 0; k < steps; k++) {
            double squares = 0;
            int groups = renders >> k;
            for (int i = 0; i < groups; i++) {
                squares += (means[i] - truth) * (means[i] - truth);
                means[i / 2] = i % 2 == 0 ? means[i] : (means[i / 2] + means[i]) / 2;
            }
            double y = Math.log(squares / groups) / (2 * Math.log(2));
            sx += k;
            sy += y;
            sxx += k * k;
            sxy += k * y;
        }
        double slope = (steps * sxy - sx * sy) / (steps * sxx - sx * sx);
        assertEquals(-0.5, slope, 0.05);
    }

    /** Light points of one render are spread evenly, so more of them help more than independent ones would. */
    @Test
    void lightPointsOfOneRenderAreBetterThanIndependentOnes() {
        Scene scene = scene(Lamp.SPHERE);
        double truth = render(scene, MILLION, 1);
        int renders = 500;
        int points = 64;
        double one = 0;
        double many = 0;
        for (int i = 0; i < renders; i++) {
            one += Math.pow(render(scene, 1, i) - truth, 2);
            many += Math.pow(render(scene, points, i) - truth, 2);
        }
        assertTrue(many * points < one / 2, "variance of " + points + ": " + many / one + " of that of one");
    }
}
