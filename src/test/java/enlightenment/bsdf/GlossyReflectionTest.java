package enlightenment.bsdf;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.math.Vec3;
import enlightenment.sampling.SphereCells;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;

/** Rough metal reflects what GGX says, and all of it with compensation. */
class GlossyReflectionTest {
    private static final double[] COSINES = {0.05, 0.1, 0.25, 0.5, 0.75};

    /** For each α: E at the cosines, at 1 (from an integral of one dimension), and the mean. */
    private static final double[][] KNOWN = {
        {0.04, 0.8906, 0.9286, 0.9832, 0.9952, 0.9974, 0.99830, 0.9947},
        {0.10, 0.9118, 0.8835, 0.9216, 0.9692, 0.9832, 0.98830, 0.9720},
        {0.16, 0.9279, 0.8883, 0.8761, 0.9264, 0.9546, 0.96770, 0.9404},
        {0.25, 0.9331, 0.8916, 0.8401, 0.8573, 0.8915, 0.91581, 0.8823},
        {0.36, 0.9272, 0.8824, 0.8084, 0.7821, 0.7995, 0.82453, 0.8029},
        {0.50, 0.9126, 0.8601, 0.7652, 0.6983, 0.6821, 0.68785, 0.7002},
        {0.64, 0.8950, 0.8331, 0.7181, 0.6212, 0.5755, 0.55517, 0.6042},
        {0.81, 0.8727, 0.7985, 0.6598, 0.5353, 0.4647, 0.41997, 0.5024},
        {1.00, 0.8478, 0.7602, 0.5976, 0.4507, 0.3645, 0.30685, 0.4091},
    };

    private static Place white(double alpha, boolean compensate, double cosine) {
        return Place.seen(new GlossyReflection(alpha, Fresnel.SCHLICK, compensate), cosine);
    }

    private static double albedo(Place place) {
        return new SphereCells(place.mirrored(), 4, 24, 12).integral(place::valueAt, 1e-6);
    }

    @Test
    void theAlbedoOfSingleReflectionIsThatOfOtherPeoplesTables() {
        for (double[] row : KNOWN) {
            for (int k = 0; k < COSINES.length; k++) {
                double tolerance = row[0] < 0.1 ? 5e-4 : 2e-4;
                String what = row[0] + " from " + COSINES[k];
                assertEquals(row[k + 1], albedo(white(row[0], false, COSINES[k])), tolerance, what);
            }
            assertEquals(row[6], albedo(white(row[0], false, 1)), 2e-5, row[0] + " from above");
        }
    }

    @Test
    void theTableHasThatAlbedoToo() {
        for (double[] row : KNOWN) {
            AlbedoTable table = new AlbedoTable(new VisibleNormals.OfMirrors(new Microfacets(row[0])));
            for (int k = 0; k < COSINES.length; k++) {
                assertEquals(row[k + 1], 1 - table.loss(COSINES[k]), 1.2e-3, row[0] + " from " + COSINES[k]);
            }
            assertEquals(row[6], 1 - table.loss(1), 2e-4, row[0] + " from above");
            assertEquals(row[7], 1 - table.meanLoss, 1e-3, row[0] + " on the whole");
        }
    }

    @Test
    void withCompensationAWhiteOneReflectsAllLight() {
        for (double alpha : new double[] {1e-4, 0.01, 0.09, 0.36, 1}) {
            GlossyReflection bsdf = new GlossyReflection(alpha, Fresnel.SCHLICK, true);
            for (double cosine : new double[] {1, 0.7, 0.3, 0.05, 1e-3}) {
                assertEquals(1, sampledAlbedo(Place.seen(bsdf, cosine)), 2e-3, alpha + " from " + cosine);
            }
        }
    }

    /** The mean weight of evenly spread samples: Halton's sequence. */
    private static double sampledAlbedo(Place place) {
        int n = 40_000;
        double sum = 0;
        for (int k = 0; k < n; k++) {
            if (place.bsdf.sample(place.s, Halton.at(2, k), Halton.at(3, k), (k + 0.5) / n)) {
                sum += place.s.valueR;
            }
        }
        return sum / n;
    }

    @Test
    void compensationOfAColouredOneAddsLightButNotTooMuch() {
        for (double alpha : new double[] {0.1, 0.5, 1}) {
            for (double cosine : new double[] {1, 0.3, 0.05}) {
                Place with = white(alpha, true, cosine).color(0.6, 0.6, 0.6);
                Place without = white(alpha, false, cosine).color(0.6, 0.6, 0.6);
                double more = albedo(with);
                double less = albedo(without);
                assertTrue(more > less && more < 1, less + " " + more);
                // It cannot be more than if all that is lost came back after one more reflection.
                double lost = 1 - albedo(white(alpha, false, cosine));
                assertTrue(more < less + lost * (0.6 + 0.4 / 21), less + " " + more);
            }
        }
    }

    @Test
    void theValueIsThatOfTheTextbook() {
        SplittableRandom random = new SplittableRandom(8);
        for (double alpha : new double[] {0.05, 0.3, 1}) {
            Place place = white(alpha, false, 1).color(0.3, 0.3, 0.3);
            for (int k = 0; k < 200; k++) {
                double out = 0.05 + 0.95 * random.nextDouble();
                double in = 0.05 + 0.95 * random.nextDouble();
                place.from(out, 6 * random.nextDouble()).to(in, 6 * random.nextDouble());
                Vec3 m = place.o().plus(place.i()).normalized();
                double mz = m.dot(place.normal());
                double c = m.dot(place.o());
                double fresnel = 0.3 + 0.7 * Math.pow(1 - c, 5);
                double d = alpha * alpha / (Math.PI * Math.pow((alpha * alpha - 1) * mz * mz + 1, 2));
                double g = 1 / (1 + lambda(alpha, out) + lambda(alpha, in));
                double f = fresnel * d * g / (4 * out * in);
                assertEquals(f, place.f(), 1e-9 * f);
                double density = d * c / (out * (1 + lambda(alpha, out))) / (4 * c);
                assertEquals(density, place.bsdf.pdf(place.s), 1e-9 * density);
            }
        }
    }

    private static double lambda(double alpha, double cosine) {
        double tan2 = (1 - cosine * cosine) / (cosine * cosine);
        return (Math.sqrt(1 + alpha * alpha * tan2) - 1) / 2;
    }

    @Test
    void theNarrowestOneIsNearlyAMirror() {
        SplittableRandom random = new SplittableRandom(9);
        Place place = white(1e-4, true, 0.6).color(0.2, 0.5, 1);
        int far = 0;
        for (int k = 0; k < 1_000; k++) {
            assertTrue(place.bsdf.sample(place.s, random.nextDouble(), random.nextDouble(), random.nextDouble()));
            assertEquals(0.2 + 0.8 * Math.pow(0.4, 5), place.s.valueR, 0.01);
            far += place.i().minus(place.mirrored()).length() > 3e-3 ? 1 : 0;
        }
        // A share α²/t² of the slopes is above t.
        assertTrue(far < 20, far + " of 1,000 are far from the mirror image");
    }

    @Test
    void aPolishedOneReflectsFresnelsShareIntoTheMirrorImage() {
        Place place = Place.seen(new SmoothConductor(Fresnel.SCHLICK), 0.5).color(0.2, 0.5, 1);
        assertTrue(place.bsdf.sample(place.s, 0.1, 0.2, 0.3));
        assertEquals(0, place.i().minus(place.mirrored()).length(), 1e-15);
        assertTrue(place.s.delta && place.bsdf.isDelta());
        assertEquals(1, place.s.pdf);
        assertEquals(0.2 + 0.8 / 32, place.s.valueR, 1e-15);
        place.bsdf.evaluate(place.s);
        assertEquals(0, place.s.valueR + place.s.pdf);
    }

    @Test
    void whatIsTooSmoothIsForAMirror() {
        assertTrue(Microfacets.isSmooth(0));
        assertTrue(Microfacets.isSmooth(9e-5));
        assertFalse(Microfacets.isSmooth(1e-4));
        for (double alpha : new double[] {0, 9e-5, 1.01, Double.NaN}) {
            assertThrows(IllegalArgumentException.class, () -> new GlossyReflection(alpha, Fresnel.SCHLICK, false));
        }
    }
}
