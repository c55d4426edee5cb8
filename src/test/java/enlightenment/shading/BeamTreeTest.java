package enlightenment.shading;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.camera.Camera;
import enlightenment.color.Rgb;
import enlightenment.compiled.CompiledScene;
import enlightenment.compiled.HomogeneousMedium;
import enlightenment.compiled.SceneCompiler;
import enlightenment.geometry.Sphere;
import enlightenment.material.Material;
import enlightenment.material.Medium;
import enlightenment.math.ExactPoint;
import enlightenment.math.Vec3;
import enlightenment.scene.PhysicalShading;
import enlightenment.scene.RenderSettings;
import enlightenment.scene.Scene;
import java.util.ArrayList;
import java.util.List;
import java.util.OptionalInt;
import java.util.Random;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Even light that comes through a plane border from one direction: E cos⁻¹θ exp(−σ d / cosθ) at the depth d. */
class BeamTreeTest {
    private static final int PATHS = 4096;
    private static final double SINE = 0.6;
    private static final double COSINE = 0.8;

    /** With this extinction coefficient in a scene whose frame is as long as its units. */
    private static HomogeneousMedium medium(double extinction) {
        Scene scene = Scene.builder()
                .size(4, 4)
                .camera(new Camera.Perspective(ExactPoint.of(0, 0, -2), ExactPoint.of(0, 0, 0), new Vec3(0, 1, 0), 40))
                .shading(new PhysicalShading(OptionalInt.empty(), Rgb.WHITE))
                .object(
                        Sphere.of(ExactPoint.of(0, 0, 0), 1),
                        new Material.Scattering(new Medium.Coefficients(Rgb.gray(extinction), Rgb.BLACK, 0), 1.4, 0, 0))
                .build();
        CompiledScene compiled = SceneCompiler.compile(scene, RenderSettings.of(scene));
        return compiled.inside(compiled.glassSolids[0]).medium;
    }

    /** On the unit square z = 0, downwards. */
    private static BeamTree tree(HomogeneousMedium medium, double length) {
        Random random = new Random(1);
        List<MediumBeam> beams = new ArrayList<>();
        for (int k = 0; k < PATHS; k++) {
            double[] start = {random.nextDouble(), random.nextDouble(), 0};
            MediumBeam beam = new MediumBeam(medium, 0, start, SINE, 0, -COSINE);
            beam.leaves(0, 0, 1);
            beam.carries(1, 1, 1, 0, 1);
            beam.length = length;
            beams.add(beam);
        }
        return new BeamTree(beams, PATHS);
    }

    private static double irradiance(BeamTree tree, double x, double y, double depth, double extinction) {
        double[] sum = new double[1];
        tree.at(x, y, -depth, beam -> {
            double deep = beam.depth(x, y, -depth);
            if (deep >= 0) {
                sum[0] += beam.red * beam.spread() * Math.exp(-extinction * deep);
            }
        });
        return sum[0];
    }

    /** However thin the layer that light comes to: its depth is nothing beside the distances of beams, or much more. */
    @ParameterizedTest
    @CsvSource({"1, 0.1", "1, 0.3", "20, 0.1", "1000, 0.0003", "1000, 0.002", "0.001, 0.2"})
    void itIsAsBrightInADepthAsBeerAndLambertSay(double inScene, double depth) {
        HomogeneousMedium medium = medium(inScene);
        double extinction = medium.extinctionR;
        BeamTree tree = tree(medium, 10);
        double shift = depth * SINE / COSINE;
        Random random = new Random(2);
        double mean = 0;
        int places = 2000;
        for (int k = 0; k < places; k++) {
            double x = 0.2 + 0.6 * random.nextDouble() + shift;
            double y = 0.2 + 0.6 * random.nextDouble();
            mean += irradiance(tree, x, y, depth, extinction) / places;
        }
        double expected = Math.exp(-extinction * depth / COSINE) / COSINE;
        // Some 4096 × 0.36 beams: 1/√1475 is 0.026, three times that.
        assertEquals(expected, mean, 0.08 * expected);
    }

    @ParameterizedTest
    @CsvSource({"0.25, 0.2", "0.5, 0.3"})
    void noLightIsBehindWhatABeamEndsAtOrBeforeItsStart(double length, double depth) {
        HomogeneousMedium medium = medium(0.01);
        BeamTree tree = tree(medium, length);
        assertTrue(irradiance(tree, 0.5 + depth * SINE / COSINE, 0.5, depth, medium.extinctionR) > 0);
        assertEquals(0, irradiance(tree, 0.5, 0.5, 2 * length, medium.extinctionR));
        assertEquals(0, irradiance(tree, 0.5, 0.5, -0.01, medium.extinctionR));
        assertEquals(0, irradiance(tree, 3, 0.5, depth, medium.extinctionR));
    }
}
