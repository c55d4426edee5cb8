package enlightenment.transport.state;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.bsdf.DielectricFresnel;
import enlightenment.bsdf.Scattering;
import enlightenment.bsdf.SmoothDielectric;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;

class PathWavelengthTest {
    private static Scattering reflected(double cosine, double eta) {
        Scattering s = new Scattering();
        s.nz = 1;
        s.oz = cosine;
        s.ox = Math.sqrt((1 - cosine) * (1 + cosine));
        s.iz = cosine;
        s.ix = -s.ox;
        s.eta = eta;
        s.delta = true;
        return s;
    }

    private static double common(Scattering s, double first, double last) {
        PathWavelength wavelength = new PathWavelength();
        wavelength.etaFirst = first;
        wavelength.etaLast = last;
        return wavelength.common(s);
    }

    @Test
    void whatIsCommonIsNoMoreThanAnyWavelengthReflects() {
        SplittableRandom random = new SplittableRandom(1);
        for (int run = 0; run < 100_000; run++) {
            double first = Math.exp(random.nextDouble(-1.2, 1.2));
            double last = first * Math.exp(random.nextDouble(-0.3, 0.3));
            double cosine = run % 2 == 0 ? random.nextDouble() : Math.sqrt(random.nextDouble());
            double own = first + random.nextDouble() * (last - first);
            double common = common(reflected(cosine, own), first, last);
            double least = DielectricFresnel.leastReflectance(cosine, first, last);
            double there = DielectricFresnel.reflectance(cosine, own);
            assertTrue(least >= 0 && there >= least * (1 - 1e-12), first + " " + last + " " + own + " " + cosine);
            assertEquals(least, common * there, 1e-9);
        }
    }

    /** Glass of usual dispersion: hardly any of what it reflects is coloured. */
    @Test
    void whatIsCommonIsNearlyAllOfTheReflectance() {
        for (double cosine : new double[] {1, 0.9, 0.7, 0.3, 0.1}) {
            double last = DielectricFresnel.reflectance(cosine, 1 / 1.51);
            assertEquals(last, DielectricFresnel.leastReflectance(cosine, 1 / 1.53, 1 / 1.51), 0.06 * last);
        }
    }

    @Test
    void whatIsRefractedHasNothingInCommonUnlessAllIndicesAreTheSame() {
        Scattering s = reflected(0.8, 1 / 1.5);
        assertTrue(SmoothDielectric.INSTANCE.sample(s, 0, 0, 0.999));
        assertTrue(s.transmitted);
        assertEquals(0, common(s, 1 / 1.52, 1 / 1.48));
        assertEquals(1, common(s, 1 / 1.5, 1 / 1.5));
    }
}
