package enlightenment.bsdf;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.SplittableRandom;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** The phase function is a density, its samples follow it, and its mean cosine is what it is named by. */
class HenyeyGreensteinTest {
    private static final int BINS = 50;

    private final Scattering s = new Scattering();

    private void comeAlong(double x, double y, double z) {
        double scale = 1 / Math.sqrt(x * x + y * y + z * z);
        s.ox = -x * scale;
        s.oy = -y * scale;
        s.oz = -z * scale;
    }

    /** The share of light that is turned by an angle whose cosine is at most c: the integral of the phase function. */
    private static double share(double g, double c) {
        if (g == 0) {
            return (1 + c) / 2;
        }
        return (1 - g * g) / (2 * g) * (1 / Math.sqrt((1 - g) * (1 - g) + 2 * g * (1 - c)) - 1 / (1 + g));
    }

    /** In steps that grow as the distance from the peak does. */
    @ParameterizedTest
    @ValueSource(doubles = {-0.999, -0.5, 0, 0.3, 0.9, 0.999})
    void itsIntegralIsOne(double g) {
        HenyeyGreenstein phase = new HenyeyGreenstein(g);
        comeAlong(0, 0, 1);
        int steps = 200_000;
        double sum = 0;
        for (int k = 0; k < steps; k++) {
            double v = (k + 0.5) / steps;
            double fromPeak = 2 * v * v * v;
            double cosine = g < 0 ? fromPeak - 1 : 1 - fromPeak;
            s.ix = Math.sqrt(fromPeak * (2 - fromPeak));
            s.iy = 0;
            s.iz = cosine;
            phase.evaluate(s);
            assertEquals(s.pdf, s.valueG);
            sum += 2 * Math.PI * s.pdf * 6 * v * v / steps;
        }
        assertEquals(1, sum, 1e-6);
    }

    @ParameterizedTest
    @ValueSource(doubles = {-0.999, -0.7, 0, 1e-9, 0.5, 0.95, 0.999})
    void itsSamplesFollowIt(double g) {
        HenyeyGreenstein phase = new HenyeyGreenstein(g);
        SplittableRandom random = new SplittableRandom(3);
        int n = 100_000;
        int[] counts = new int[BINS];
        double meanCosine = 0;
        double right = 0;
        for (int k = 0; k < n; k++) {
            comeAlong(random.nextDouble() - 0.5, random.nextDouble() - 0.5, random.nextDouble() - 0.5);
            assertTrue(phase.sample(s, random.nextDouble(), random.nextDouble(), 0));
            assertEquals(1, s.ix * s.ix + s.iy * s.iy + s.iz * s.iz, 1e-12);
            assertEquals(1, s.valueR);
            double density = s.pdf;
            assertEquals(density, phase.pdf(s), 1e-7 * density);
            double cosine = -(s.ox * s.ix + s.oy * s.iy + s.oz * s.iz);
            meanCosine += cosine / n;
            right += (s.ix * s.oy - s.iy * s.ox > 0 ? 1.0 : 0) / n;
            // Equal shares, whatever g is.
            counts[(int) Math.min(BINS * share(g, cosine), BINS - 1)]++;
        }
        double chi = 0;
        for (int count : counts) {
            double expected = (double) n / BINS;
            chi += (count - expected) * (count - expected) / expected;
        }
        // 49 degrees of freedom: 1e-6.
        assertTrue(chi < 110, g + ": " + chi);
        assertEquals(g, meanCosine, 4.5 / Math.sqrt(n));
        assertEquals(0.5, right, 2.5 / Math.sqrt(n));
    }
}
