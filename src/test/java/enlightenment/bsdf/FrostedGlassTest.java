package enlightenment.bsdf;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.math.Vec3;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;

/** Rough glass with the light that meets it more than once. */
class FrostedGlassTest {
    private static final double[] ALPHAS = {0.04, 0.1, 0.25, 0.5, 1};
    private static final double[] INDICES = {1.1, 1.5, 2.4};
    private static final int SAMPLES = 40_000;

    /** What comes back, and what comes through, by evenly spread samples. */
    private static double[] energies(Place place) {
        double[] sums = new double[2];
        for (int k = 0; k < SAMPLES; k++) {
            if (place.bsdf.sample(place.s, Halton.at(2, k), Halton.at(3, k), Halton.at(5, k))) {
                sums[place.s.transmitted ? 1 : 0] += place.s.valueR / SAMPLES;
            }
        }
        return sums;
    }

    @Test
    void noLightIsLostOnEitherSide() {
        for (double alpha : ALPHAS) {
            RoughDielectric bsdf = new RoughDielectric(alpha, true);
            for (double n : INDICES) {
                for (double cosine : new double[] {1, 0.5, 0.05, 1e-3}) {
                    for (double eta : new double[] {n, 1 / n}) {
                        double[] e = energies(Place.seen(bsdf, cosine).eta(eta));
                        assertEquals(1, e[0] + e[1], 5e-3, alpha + " " + eta + " from " + cosine);
                    }
                }
            }
        }
    }

    @Test
    void lossesAreInterpolatedBetweenIndices() {
        for (double alpha : ALPHAS) {
            LostLight lost = new LostLight(new Microfacets(alpha));
            for (double n : new double[] {1.04, 1.33, 1.5, 1.517, 2.4}) {
                for (double eta : new double[] {n, 1 / n}) {
                    VisibleNormals normals = new VisibleNormals.OfInterface(new Microfacets(alpha), eta);
                    for (double cosine : new double[] {1, 0.8, 0.5, 0.2, 0.05}) {
                        double loss = lost.loss(LostLight.place(eta), eta > 1, cosine);
                        assertEquals(normals.meanLoss(cosine), loss, 3e-3, alpha + " " + eta + " from " + cosine);
                    }
                }
            }
        }
    }

    /** Of diffuse light: the model has one number to choose, and this is what it is chosen by. */
    @Test
    void asMuchComesThroughAsOfLightThatWalksAmongFacets() {
        SplittableRandom random = new SplittableRandom(8);
        for (double alpha : new double[] {0.25, 0.5, 1}) {
            FacetWalk walk = new FacetWalk(alpha, random);
            for (double n : INDICES) {
                Place place = Place.seen(new RoughDielectric(alpha, true), 1).eta(1 / n);
                int walked = 0;
                double ours = 0;
                for (int k = 0; k < SAMPLES; k++) {
                    double cosine = Math.sqrt(Halton.at(7, k + 1));
                    double sine = Math.sqrt(1 - cosine * cosine);
                    walked += walk.passes(new Vec3(sine, 0, cosine), 1 / n) ? 1 : 0;
                    place.from(cosine, 0.3);
                    boolean goes = place.bsdf.sample(place.s, Halton.at(2, k), Halton.at(3, k), Halton.at(5, k));
                    ours += goes && place.s.transmitted ? place.s.valueR : 0;
                }
                double mean = walked / (double) SAMPLES;
                assertEquals(mean, ours / SAMPLES, 0.008, alpha + " " + n);
            }
        }
    }

    @Test
    void whatComesThroughIsTheSameFromBothSides() {
        for (double alpha : ALPHAS) {
            LostLight lost = new LostLight(new Microfacets(alpha));
            for (double n : new double[] {1 + 1e-12, 1.01, 1.37, 1.5, 2.4, 30}) {
                double place = LostLight.place(n);
                double into = lost.through(place, false, 1 / n) * lost.meanLoss(place, false);
                double outOf = lost.through(place, true, n) * lost.meanLoss(place, true) * n * n;
                assertEquals(into, outOf, 1e-12 * into);
                assertTrue(lost.through(place, true, n) < 1 && lost.through(place, false, 1 / n) < 1);
            }
        }
    }
}
