package enlightenment.classic.cluster;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.sampling.Distribution;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class LobeTest {
    private static final double COS = 0.8;
    private static final double SIN = 0.6;

    /** Points of an ellipse that moves with the film position: deviations 0.1 and 0.02 along axes turned by (0.8, 0.6). */
    private static Lobe fitted(String family, int points) {
        Lobe lobe = new Lobe(Distribution.of(family));
        lobe.clear(0.001);
        Random random = new Random(5);
        for (int k = 0; k < points; k++) {
            double x = 8 * random.nextDouble() - 4;
            double y = 8 * random.nextDouble() - 4;
            double a = 0.1 * random.nextGaussian();
            double b = 0.02 * random.nextGaussian();
            lobe.add(x, y, middleP(x, y) + a * COS - b * SIN, middleQ(x, y) + a * SIN + b * COS, 1);
        }
        lobe.fit();
        return lobe;
    }

    private static double middleP(double x, double y) {
        return 0.1 + 0.05 * x - 0.02 * y;
    }

    private static double middleQ(double x, double y) {
        return -0.2 + 0.01 * x + 0.03 * y;
    }

    @Test
    void aKnownEllipseIsFoundWithItsSlopes() {
        Lobe lobe = fitted("normal", 20_000);
        // Variances are widened 1.25 times.
        double wide = Math.sqrt(1.25);
        assertEquals(0.1 * wide, lobe.deviation(), 0.002);
        for (double[] at : new double[][] {{0, 0}, {3, -2}, {-4, 4}}) {
            double p = middleP(at[0], at[1]);
            double q = middleQ(at[0], at[1]);
            assertEquals(0, lobe.distance(at[0], at[1], p, q), 0.02);
            // Two deviations off along the longer and across it.
            double along = 0.2 * wide;
            double across = 0.04 * wide;
            assertEquals(4, lobe.distance(at[0], at[1], p + along * COS, q + along * SIN), 0.4);
            assertEquals(4, lobe.distance(at[0], at[1], p - across * SIN, q + across * COS), 0.4);
        }
    }

    @ParameterizedTest
    @ValueSource(strings = {"normal", "zeta", "linear"})
    void whatIsProposedHasTheDensityThatIsTold(String family) {
        Lobe lobe = fitted(family, 2000);
        lobe.aim(2, 1);
        // E[g/density] over proposals is the integral of g: of 1 over a small square that moves through the ellipse.
        double side = 0.05;
        int n = 400;
        for (double offset : new double[] {-0.1, 0, 0.1}) {
            double left = middleP(2, 1) + offset * COS - side / 2;
            double top = middleQ(2, 1) + offset * SIN - side / 2;
            double sum = 0;
            for (int i = 0; i < n; i++) {
                for (int j = 0; j < n; j++) {
                    lobe.propose((i + 0.5) / n, (j + 0.5) / n);
                    if (lobe.p >= left && lobe.p < left + side && lobe.q >= top && lobe.q < top + side) {
                        sum += 1 / lobe.density(lobe.p, lobe.q);
                    }
                }
            }
            assertEquals(side * side, sum / (n * n), 0.02 * side * side, family + " at " + offset);
        }
    }

    @ParameterizedTest
    @ValueSource(ints = {1, 2, 3, 4, 100})
    void pointsThatDoNotSpreadMakeAFiniteLobe(int points) {
        for (int kind = 0; kind < 4; kind++) {
            Lobe lobe = new Lobe(Distribution.of("normal"));
            lobe.clear(0.01);
            for (int k = 0; k < points; k++) {
                // All the same; in a line on the film; in a line on the disk; all at its border.
                double t = (double) k / points;
                double x = kind == 1 ? t : 4;
                double p = kind == 2 ? t : kind == 3 ? 1 : 0.3;
                lobe.add(x, 4, p, kind == 3 ? 0 : 0.3, 1);
            }
            lobe.fit();
            lobe.share = 1;
            for (double at : new double[] {-4, 0, 4}) {
                lobe.aim(at, -at);
                lobe.propose(0.3, 0.7);
                double density = lobe.density(lobe.p, lobe.q);
                assertTrue(density > 0 && density < Double.POSITIVE_INFINITY, "kind " + kind + ": " + density);
                assertTrue(lobe.deviation() >= 0.01);
            }
        }
    }
}
