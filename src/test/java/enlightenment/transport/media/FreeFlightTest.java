package enlightenment.transport.media;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.camera.Camera;
import enlightenment.color.Rgb;
import enlightenment.material.Medium;
import enlightenment.math.ExactPoint;
import enlightenment.math.Vec3;
import enlightenment.scene.RenderSettings;
import enlightenment.scene.Scene;
import enlightenment.scene.Shading;
import enlightenment.world.SceneCompiler;
import enlightenment.world.material.HomogeneousMedium;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;

/** What long walks through coloured media are worth. */
class FreeFlightTest {
    private static final int STEPS = 3000;

    private static HomogeneousMedium medium(Rgb scattering, Rgb absorption) {
        Scene scene = Scene.builder()
                .size(8, 8)
                .camera(new Camera.Orthographic(ExactPoint.of(0, 0, -1), ExactPoint.of(0, 0, 0), Vec3.Y, 1))
                .shading(new Shading.Physical(
                        OptionalInt.empty(),
                        new Shading.Background.Constant(Rgb.gray(0)),
                        Optional.of(new Medium.Coefficients(scattering, absorption, 0))))
                .build();
        return SceneCompiler.compile(scene, RenderSettings.of(scene)).physical.around.medium;
    }

    /** What a walk carries by band. */
    private static final class Walk {
        final FreeFlight flight = new FreeFlight();
        final double[] carried;

        Walk(double... carried) {
            this.carried = carried;
            flight.begin();
        }

        void fly(HomogeneousMedium in, SplittableRandom random) {
            flight.draw(in, carried[0], carried[1], carried[2], random.nextDouble(), random.nextDouble());
        }

        void weigh() {
            carried[0] *= flight.weightR;
            carried[1] *= flight.weightG;
            carried[2] *= flight.weightB;
        }
    }

    @Test
    void inAWhiteMediumBandsShareWhatAWalkCarriesHoweverLongItIs() {
        HomogeneousMedium white = medium(new Rgb(1, 3, 9), Rgb.gray(0));
        SplittableRandom random = new SplittableRandom(5);
        for (int k = 0; k < 20; k++) {
            Walk walk = new Walk(1, 1, 1);
            for (int step = 0; step < STEPS; step++) {
                walk.fly(white, random);
                walk.flight.scatter();
                walk.weigh();
                assertEquals(3, walk.carried[0] + walk.carried[1] + walk.carried[2], 1e-9);
            }
        }
    }

    @Test
    void whatABandCarriesHasTheRightMeanAndABoundWhateverItBeganWith() {
        HomogeneousMedium in = medium(new Rgb(2, 5, 9), new Rgb(0.2, 0.1, 0.02));
        double[] began = {1, 0.01, 0.3};
        double[] albedo = {2 / 2.2, 5 / 5.1, 9 / 9.02};
        SplittableRandom random = new SplittableRandom(6);
        int walks = 20_000;
        double[] sum = new double[3];
        double[] squares = new double[3];
        for (int k = 0; k < walks; k++) {
            Walk walk = new Walk(began.clone());
            for (int step = 0; step < 6; step++) {
                walk.fly(in, random);
                // Interfaces that turn the path on its way.
                if (walk.flight.length > 0.3) {
                    walk.flight.pass(0.3);
                    step--;
                } else {
                    walk.flight.scatter();
                }
                walk.weigh();
            }
            for (int band = 0; band < 3; band++) {
                double c = walk.carried[band];
                assertTrue(c >= 0 && c <= 10 * began[band] * (1 + 1e-9), "carries " + c);
                sum[band] += c;
                squares[band] += c * c;
            }
        }
        for (int band = 0; band < 3; band++) {
            double mean = sum[band] / walks;
            double error = Math.sqrt((squares[band] / walks - mean * mean) / walks);
            assertEquals(began[band] * Math.pow(albedo[band], 6), mean, 4 * error);
        }
    }
}
