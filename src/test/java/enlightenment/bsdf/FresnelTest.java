package enlightenment.bsdf;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.color.Rgb;
import enlightenment.sampling.Quadrature;
import org.junit.jupiter.api.Test;

/** Fresnel's equations against textbook forms, known values and what they keep. */
class FresnelTest {
    private static final double[] INDICES = {1.33, 1.5, 2.4};

    @Test
    void normalIncidenceReflectsTheSquareOfDifferenceOverSum() {
        double[] known = {0.020059, 0.04, 0.169550};
        for (int k = 0; k < 3; k++) {
            double n = INDICES[k];
            double f = (n - 1) * (n - 1) / ((n + 1) * (n + 1));
            assertEquals(known[k], f, 5e-7);
            assertEquals(f, DielectricFresnel.reflectance(1, 1 / n), 1e-15);
            assertEquals(f, DielectricFresnel.reflectance(1, n), 1e-15);
        }
    }

    @Test
    void theTextbooksFormSaysTheSameWhereItDoesNotCancel() {
        for (double n : INDICES) {
            for (double c = 0.01; c < 1; c += 0.03) {
                double ct = Math.sqrt(1 - (1 - c * c) / (n * n));
                double s = squared((c - n * ct) / (c + n * ct));
                double p = squared((n * c - ct) / (n * c + ct));
                assertEquals((s + p) / 2, DielectricFresnel.reflectance(c, 1 / n), 1e-13);
                double there = DielectricFresnel.transmittance(c, ct, 1 / n);
                assertEquals(1 - (s + p) / 2, there, 1e-13);
                assertEquals(there, DielectricFresnel.transmittance(ct, c, n), 1e-14, "the same from both sides");
                // A pane: both faces and all that goes to and fro, for each polarisation.
                double paneS = s + squared(1 - s) * s / (1 - s * s);
                double paneP = p + squared(1 - p) * p / (1 - p * p);
                assertEquals((paneS + paneP) / 2, DielectricFresnel.paneReflectance(c, 1 / n), 1e-12);
            }
        }
    }

    private static double squared(double x) {
        return x * x;
    }

    @Test
    void meansOverTheHemisphereAreKnownAndDualFromBothSides() {
        double[] outside = {0.065931, 0.091778, 0.210181};
        double[] inside = {0.471947, 0.596337, 0.862870};
        for (int k = 0; k < 3; k++) {
            double n = INDICES[k];
            double out = mean(0, 1 / n);
            double in = mean(Math.sqrt(1 - 1 / (n * n)), n);
            assertEquals(outside[k], out, 1e-6);
            assertEquals(inside[k], in, 1e-5);
            assertEquals(1 - in, (1 - out) / (n * n), 1e-9);
        }
    }

    /** 2∫F c dc with total reflection below a cosine, next to which F goes like a root. */
    private static double mean(double critical, double eta) {
        double rest = 1 - critical;
        return critical * critical
                + Quadrature.integral(
                        x -> {
                            double c = critical + rest * x * x;
                            return DielectricFresnel.reflectance(c, eta) * 2 * c * 2 * x * rest;
                        },
                        0,
                        1,
                        40);
    }

    @Test
    void panesLetThroughWhatASlabDoes() {
        double[] known = {0.960670, 0.923077, 0.710059};
        for (int k = 0; k < 3; k++) {
            assertEquals(known[k], ThinDielectric.transmittance(-1, 1 / INDICES[k]), 5e-7);
        }
        assertEquals(0, ThinDielectric.transmittance(0, 1 / 1.5), 1e-15);
        assertEquals(1, ThinDielectric.transmittance(0.3, 1));
    }

    @Test
    void equalIndicesReflectNothingAndNearlyEqualOnesKeepTheirDigits() {
        for (double c : new double[] {1, 0.5, 1e-8, 1e-200, 0}) {
            assertEquals(0, DielectricFresnel.reflectance(c, 1));
        }
        for (double d : new double[] {1e-3, 1e-8, 1e-15}) {
            double eta = 1 + d;
            double exact = squared((eta - 1) / (eta + 1));
            assertEquals(exact, DielectricFresnel.reflectance(1, eta), 1e-13 * exact);
        }
    }

    @Test
    void grazingLightIsReflectedAndTotalReflectionIsTotal() {
        for (double n : INDICES) {
            assertEquals(1, DielectricFresnel.reflectance(0, 1 / n), 1e-15);
            double critical = Math.sqrt(1 - 1 / (n * n));
            assertEquals(1, DielectricFresnel.reflectance(0.999 * critical, n));
            assertEquals(1, DielectricFresnel.paneReflectance(0.999 * critical, n));
            assertTrue(DielectricFresnel.reflectance(1.001 * critical, n) < 1);
            // Brewster's angle: only one polarisation is reflected.
            double brewster = 1 / Math.sqrt(1 + n * n);
            double s = squared((n * n - 1) / (n * n + 1));
            assertEquals(s / 2, DielectricFresnel.reflectance(brewster, 1 / n), 1e-14);
        }
    }

    @Test
    void metalsReflectWhatIsKnownOfThem() {
        assertEquals(0.952176, Fresnel.conductor(1, 0.2, 3.91), 5e-7);
        assertEquals(0.946110, Fresnel.conductor(0.5, 0.2, 3.91), 5e-7);
        assertEquals(0.962934, Fresnel.conductor(0.1, 0.2, 3.91), 5e-7);
        assertEquals(1, Fresnel.conductor(0, 0.2, 3.91), 1e-15);
    }

    @Test
    void aMetalWithoutExtinctionIsGlass() {
        for (double n : new double[] {0.7, 1, 1.5, 2.4}) {
            for (double c = 0.125; c <= 1; c += 0.125) {
                double glass = DielectricFresnel.reflectance(c, 1 / n);
                assertEquals(glass, Fresnel.conductor(c, n, 0), 1e-13, n + " at " + c);
            }
        }
        assertEquals(DielectricFresnel.reflectance(0.4, 1 / 1.5), Fresnel.conductor(0.4, 1.5, 1e-9), 1e-13);
    }

    @Test
    void schlicksFormulaGoesFromTheColourToWhite() {
        Scattering s = new Scattering();
        s.red = 0.04;
        s.green = 0.5;
        s.blue = 1;
        Fresnel.SCHLICK.at(1, s);
        assertEquals(0.04, s.valueR);
        assertEquals(0.5, s.valueG);
        Fresnel.SCHLICK.at(0, s);
        assertEquals(1, s.valueR);
        assertEquals(1, s.valueG);
        Fresnel.SCHLICK.at(0.5, s);
        assertEquals(0.04 + 0.96 / 32, s.valueR, 1e-16);
        assertEquals(1, s.valueB);
    }

    @Test
    void meansOfMetalsAndOfSchlicksFormulaAreTheirIntegrals() {
        Scattering s = new Scattering();
        s.red = 0.3;
        s.green = 0.6;
        s.blue = 0.9;
        Scattering at = new Scattering();
        Rgb eta = new Rgb(0.2, 0.4, 1.5);
        Rgb k = new Rgb(3.91, 2.4, 1.6);
        for (Fresnel f : new Fresnel[] {Fresnel.SCHLICK, Fresnel.conductor(eta, k)}) {
            double[] mean = new double[3];
            for (int component = 0; component < 3; component++) {
                int which = component;
                mean[component] = Quadrature.integral(
                        c -> {
                            at.red = s.red;
                            at.green = s.green;
                            at.blue = s.blue;
                            f.at(c, at);
                            double[] value = {at.valueR, at.valueG, at.valueB};
                            return 2 * c * value[which];
                        },
                        0,
                        1,
                        20);
            }
            assertEquals(mean[0], f.meanR(s), 1e-7);
            assertEquals(mean[1], f.meanG(s), 1e-7);
            assertEquals(mean[2], f.meanB(s), 1e-7);
        }
    }

    @Test
    void whatIsNoMetalIsRefused() {
        Rgb one = new Rgb(1, 1, 1);
        Rgb none = new Rgb(0, 1, 1);
        assertThrows(IllegalArgumentException.class, () -> Fresnel.conductor(none, one));
    }

    /** The limit of an index that grows: everything is reflected, at any angle. */
    @Test
    void aMetalOfAHugeIndexReflectsAllLight() {
        for (double index : new double[] {1e20, 1e80, 1e200, Double.MAX_VALUE}) {
            for (double cosine : new double[] {1, 0.7, 1e-3}) {
                Scattering s = new Scattering();
                s.red = 1;
                s.green = 1;
                s.blue = 1;
                Fresnel.conductor(new Rgb(index, 1, index), new Rgb(1, index, index))
                        .at(cosine, s);
                assertEquals(1, s.valueR, 1e-15);
                assertEquals(1, s.valueG, 1e-15);
                assertEquals(1, s.valueB, 1e-15);
            }
        }
    }
}
