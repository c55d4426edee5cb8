package enlightenment.physical;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.math.Vec3;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;

/** The partner of the path tracer is right itself: where the answer is known, it gives it. */
class NaiveTracerTest {
    private static final int PATHS = 16_000;

    /**
     * Without the roughest glass: the tracer samples facets by their density, whether they are visible or not, so that its weights have
     * tails there of which this number of paths does not even show the standard error.
     */
    static Stream<ClosedForms.Known> known() {
        return ClosedForms.all().stream().filter(known -> !known.name().contains("roughest"));
    }

    /** Five standard errors of 32 means: a right program fails one of 60 comparisons with a chance of 1e-3. */
    @ParameterizedTest
    @MethodSource("known")
    void itGivesTheRadianceThatIsKnown(ClosedForms.Known known) {
        NaiveTracer tracer = new NaiveTracer(known.scene());
        int side = known.scene().width();
        double[][] means = tracer.means(0, 0, side, side, PATHS, 1);
        for (int band = 0; band < 3; band++) {
            Statistics s = Statistics.of(means[band]);
            double expected = known.radiance()[band];
            double off = Math.abs(s.mean() - expected);
            // The least distance of rays moves places by 1e-7; a table of albedos closes to about 1e-3.
            double tolerance = 5 * s.error() + 1e-6 * expected + (known.name().contains("metal") ? 2e-3 : 0);
            assertTrue(off <= tolerance, () -> s + " instead of " + expected);
        }
    }

    /** The values of physical-light 2.6. */
    @Test
    void conductorsReflectWhatTheLiteratureSays() {
        assertEquals(0.952176, NaiveFresnel.conductor(1, 0.2, 3.91), 1e-6);
        assertEquals(0.946110, NaiveFresnel.conductor(0.5, 0.2, 3.91), 1e-6);
        assertEquals(0.962934, NaiveFresnel.conductor(0.1, 0.2, 3.91), 1e-6);
        assertEquals(0.04, NaiveFresnel.dielectric(1, 1, 1.5), 1e-12);
        assertEquals(0.169550, NaiveFresnel.dielectric(1, 1, 2.4), 1e-6);
    }

    /** Albedos of single scattering, by quadrature elsewhere. */
    @ParameterizedTest
    @ValueSource(doubles = {0.16, 0.5, 1})
    void facetsHaveTheAlbedosOfTheTable(double alpha) {
        double straight = alpha == 0.16 ? 0.96770 : alpha == 0.5 ? 0.68785 : 0.30685;
        double mean = alpha == 0.16 ? 0.9404 : alpha == 0.5 ? 0.7002 : 0.4091;
        NaiveFacets facets = new NaiveFacets(alpha);
        assertEquals(straight, facets.albedo(1), 1e-3);
        assertEquals(mean, facets.meanAlbedo(), 1e-3);
    }

    /** Albedos of a reflectance of a half at the greatest roughness. */
    @Test
    void roughMatteSurfacesHaveTheAlbedosOfTheTable() {
        NaiveReflector rough = new NaiveReflector.Rough(new double[] {0.5, 1, 1}, 1);
        double[] mu = {0.05, 0.3, 0.7, 1};
        double[] expected = {0.4965, 0.4780, 0.4503, 0.4390};
        for (int k = 0; k < mu.length; k++) {
            assertEquals(expected[k], albedo(rough, 0, mu[k]), 5e-4);
            assertEquals(1, albedo(rough, 1, mu[k]), 1e-3);
        }
    }

    private static double albedo(NaiveReflector reflector, int band, double mu) {
        Vec3 out = new Vec3(Math.sqrt(1 - mu * mu), 0, mu);
        int side = 400;
        double sum = 0;
        for (int i = 0; i < side * side; i++) {
            double z = Math.sqrt((i / side + 0.5) / side);
            double phi = 2 * Math.PI * (i % side + 0.5) / side;
            double r = Math.sqrt(1 - z * z);
            sum += Math.PI * reflector.value(band, out, new Vec3(r * Math.cos(phi), r * Math.sin(phi), z));
        }
        return sum / (side * side);
    }
}
