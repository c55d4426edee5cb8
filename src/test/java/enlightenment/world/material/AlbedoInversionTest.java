package enlightenment.world.material;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.bsdf.GaussLegendre;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

class AlbedoInversionTest {
    private static final int NODES = 64;

    @ParameterizedTest
    @CsvSource({".50, .146544", ".90, .478024", ".99, .794564"})
    void halfSpacesGiveBackWhatChandrasekharsTableSays(double albedo, double givenBack) {
        assertEquals(givenBack, AlbedoInversion.givenBack(Math.sqrt(1 - albedo)), 5e-7);
        assertEquals(albedo, AlbedoInversion.singleScattering(givenBack), 2e-6);
    }

    /** H by its own equation, repeated until it stands, and its moment. */
    private static double byIteration(double albedo) {
        double[] mu = new double[NODES];
        double[] weight = new double[NODES];
        double[] h = new double[NODES];
        for (int i = 0; i < NODES; i++) {
            mu[i] = GaussLegendre.node(NODES, i);
            weight[i] = GaussLegendre.weight(NODES, i);
            h[i] = 1;
        }
        double root = Math.sqrt(1 - albedo);
        for (int round = 0; round < 4000; round++) {
            double[] next = new double[NODES];
            double change = 0;
            for (int i = 0; i < NODES; i++) {
                double sum = 0;
                for (int k = 0; k < NODES; k++) {
                    sum += weight[k] * mu[k] * h[k] / (mu[i] + mu[k]);
                }
                next[i] = 1 / (root + albedo / 2 * sum);
                change = Math.max(change, Math.abs(next[i] - h[i]));
            }
            h = next;
            if (change < 1e-14) {
                break;
            }
        }
        double moment = 0;
        for (int i = 0; i < NODES; i++) {
            moment += weight[i] * mu[i] * h[i];
        }
        return 1 - 2 * root * moment;
    }

    @ParameterizedTest
    @ValueSource(doubles = {0.01, 0.2, 0.5, 0.8, 0.95, 0.999, 0.999_99})
    void theIntegralIsThatOfTheFunctionH(double albedo) {
        assertEquals(byIteration(albedo), AlbedoInversion.givenBack(Math.sqrt(1 - albedo)), 3e-6);
    }

    @Test
    void theInverseIsOne() {
        for (double givenBack = 1e-9; givenBack < 1; givenBack += 0.003_7) {
            double albedo = AlbedoInversion.singleScattering(givenBack);
            assertEquals(givenBack, AlbedoInversion.givenBack(Math.sqrt(1 - albedo)), 1e-8 * (1 + givenBack));
        }
    }

    @Test
    void blackStaysBlackAndWhiteLosesNothing() {
        assertEquals(0, AlbedoInversion.singleScattering(0));
        assertEquals(1, AlbedoInversion.singleScattering(1));
        // A little light was scattered once: 2/3 (1 − ln 2) of it come out again.
        assertEquals(1e-6 / (2 * (1 - Math.log(2)) / 3), AlbedoInversion.singleScattering(1e-6), 1e-10);
        // Nearly white: what is lost is 4 / sqrt(3) times the root of what each scattering takes.
        double lost = Math.sqrt(1 - AlbedoInversion.singleScattering(0.9999)) * 4 / Math.sqrt(3);
        assertEquals(1e-4, lost, 1e-7);
    }

    @Test
    void moreLightBackNeedsMoreScattering() {
        double last = 0;
        for (int i = 1; i < 500; i++) {
            double albedo = AlbedoInversion.singleScattering(i / 500.0);
            assertTrue(albedo > last && albedo < 1, i / 500.0 + " " + albedo);
            last = albedo;
        }
    }
}
