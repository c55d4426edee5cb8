package enlightenment.bsdf;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Coats over matte bases lose no light, and add none. */
class CoatingTest {
    private static final double[] COSINES = {1, 0.7, 0.3, 0.1, 0.05, 0.01, 1e-3};
    private static final double[] ALPHAS = {1e-4, 0.01, 0.04, 0.1, 0.25, 0.5, 1};

    /** The mean weight of evenly spread samples, which are of the two lobes in turn: Halton's sequence. */
    private static double albedo(Place place) {
        int n = 40_000;
        double sum = 0;
        for (int k = 0; k < n; k++) {
            if (place.bsdf.sample(place.s, Halton.at(2, k), Halton.at(3, k), Halton.at(5, k))) {
                sum += place.s.valueR;
            }
        }
        return sum / n;
    }

    /** 2∫Fμ dμ of a smooth interface from outside: J. W. T. Walsh 1926, as in S. Q. Duntley 1942. */
    private static double walsh(double n) {
        double n2 = n * n;
        double n4 = n2 * n2;
        double plus = n2 + 1;
        return 0.5
                + (n - 1) * (3 * n + 1) / (6 * (n + 1) * (n + 1))
                + n2 * (n2 - 1) * (n2 - 1) / (plus * plus * plus) * Math.log((n - 1) / (n + 1))
                - 2 * n * n2 * (n2 + 2 * n - 1) / (plus * (n4 - 1))
                + 8 * n4 * (n4 + 1) / (plus * (n4 - 1) * (n4 - 1)) * Math.log(n);
    }

    @ParameterizedTest
    @ValueSource(doubles = {1.05, 1.1, 1.33, 1.5, 1.9, 2.4, 4, 10})
    void theMeanTransmittanceIsThatOfTheClosedForm(double index) {
        // The closed form cancels next to 1.
        double tolerance = index < 1.2 ? 1e-8 : 1e-12;
        assertEquals(1 - walsh(index), SmoothCoating.meanTransmittance(1 / index), tolerance);
    }

    @Test
    void nextToNoCoatLetsNextToAllLightThrough() {
        for (double index : new double[] {Math.nextUp(1.0), 1 + 1e-9, 1 + 1e-4, 1.01}) {
            double mean = SmoothCoating.meanTransmittance(1 / index);
            assertTrue(mean <= 1 && mean > 1 - (index - 1) - 1e-14, index + " " + mean);
        }
    }

    @Test
    void aSmoothCoatOverAWhiteBaseReflectsAllLight() {
        for (double index : new double[] {1 + 1e-6, 1.1, 1.5, 2.4, 10}) {
            for (boolean nonlinear : new boolean[] {false, true}) {
                for (double cosine : COSINES) {
                    Place place = Place.seen(new SmoothCoating(index, nonlinear), cosine);
                    double base = 0;
                    int points = 400;
                    for (int k = 0; k < points; k++) {
                        double x = (k + 0.5) / points;
                        place.to(x * x, 1);
                        place.bsdf.evaluate(place.s);
                        base += place.s.valueR * 2 * Math.PI * 2 * x / points;
                    }
                    double coat = DielectricFresnel.reflectance(Math.min(cosine, 1), 1 / index);
                    assertEquals(1, coat + base, 2e-5, index + " from " + cosine);
                }
            }
        }
    }

    @ParameterizedTest
    @CsvSource({"1.01, 2e-3", "1.5, 1e-3", "10, 2e-3"})
    void aRoughCoatOverAWhiteBaseReflectsAllLight(double index, double tolerance) {
        for (double alpha : ALPHAS) {
            Bsdf bsdf = new RoughCoating(alpha, index, alpha > 0.1);
            for (double cosine : COSINES) {
                String what = "alpha " + alpha + ", index " + index + " from " + cosine;
                assertEquals(1, albedo(Place.seen(bsdf, cosine)), tolerance, what);
            }
        }
    }

    @Test
    void noColourReflectsMoreThanItReceives() {
        SplittableRandom random = new SplittableRandom(12);
        for (int k = 0; k < 40; k++) {
            double index = 1 + 3 * random.nextDouble();
            double alpha = random.nextDouble();
            boolean nonlinear = random.nextBoolean();
            Bsdf bsdf = k % 2 == 0 ? new SmoothCoating(index, nonlinear) : new RoughCoating(alpha, index, nonlinear);
            double color = random.nextDouble();
            double cosine = random.nextDouble();
            double albedo = albedo(Place.seen(bsdf, cosine).color(color, color, color));
            assertTrue(albedo < 1, index + " " + alpha + " " + color + ": " + albedo);
        }
    }

    @Test
    void theNonlinearBaseIsTheSumOfItsReflections() {
        double index = 1.5;
        double mean = SmoothCoating.meanTransmittance(1 / index);
        double inside = 1 - mean / (index * index);
        for (double color : new double[] {0, 0.1, 0.5, 0.9, 1}) {
            double sum = 0;
            for (int k = 0; k < 500; k++) {
                sum += color * (1 - inside) * Math.pow(color * inside, k);
            }
            Place place =
                    Place.seen(new SmoothCoating(index, true), 0.8).to(0.6, 2).color(color, 1, 1);
            double enters = 1 - DielectricFresnel.reflectance(0.8, 1 / index);
            double leaves = 1 - DielectricFresnel.reflectance(0.6, 1 / index);
            assertEquals(sum * enters * leaves / (Math.PI * mean), place.f(), 1e-9);
        }
        // Mitsuba's form of the same: T T/n² ρ/(1 − ρF̄)/π.
        assertEquals(mean, index * index * (1 - inside), 1e-15);
    }

    @Test
    void theLeastRoughCoatIsNearlyASmoothOne() {
        Bsdf smooth = new SmoothCoating(1.5, false);
        Bsdf rough = new RoughCoating(1e-4, 1.5, false);
        for (double cosine : new double[] {1, 0.7, 0.3, 0.1}) {
            for (double color : new double[] {0, 0.5, 1}) {
                double expected = albedo(Place.seen(smooth, cosine).color(color, color, color));
                assertEquals(expected, albedo(Place.seen(rough, cosine).color(color, color, color)), 2e-3);
            }
        }
    }

    @Test
    void deltaSamplesComeWithTheProbabilityThatTheyHave() {
        SplittableRandom random = new SplittableRandom(13);
        for (double cosine : new double[] {1, 0.3, 0.05}) {
            Place place = Place.seen(new SmoothCoating(1.5, false), cosine).color(0.9, 0.5, 0.2);
            double density = 0;
            int points = 4_000;
            for (int k = 0; k < points; k++) {
                place.to((k + 0.5) / points, 3);
                density += place.bsdf.pdf(place.s) * 2 * Math.PI / points;
            }
            int deltas = 0;
            double probability = 0;
            int samples = 100_000;
            for (int k = 0; k < samples; k++) {
                assertTrue(place.bsdf.sample(place.s, random.nextDouble(), random.nextDouble(), random.nextDouble()));
                deltas += place.s.delta ? 1 : 0;
                probability = place.s.delta ? place.s.pdf : probability;
            }
            assertEquals(1, density + probability, 1e-6);
            double deviation = Math.sqrt(probability * (1 - probability) / samples);
            assertEquals(probability, (double) deltas / samples, 5 * deviation);
        }
    }

    @Test
    void aBlackBaseShowsItsCoat() {
        Place place = Place.seen(new SmoothCoating(1.5, true), 0.5).color(0, 0, 0);
        assertTrue(place.bsdf.reflectsIfBlack());
        assertTrue(place.bsdf.sample(place.s, 0.1, 0.2, Math.nextDown(1.0)));
        assertTrue(place.s.delta);
        assertEquals(DielectricFresnel.reflectance(0.5, 1 / 1.5), place.s.valueR * place.s.pdf, 1e-15);
        assertFalse(new RoughCoating(0.1, 1.5, true).hasDelta());
    }

    @Test
    void thereIsNoCoatOfIndexOneOrLess() {
        assertThrows(IllegalArgumentException.class, () -> new SmoothCoating(1, false));
        assertThrows(IllegalArgumentException.class, () -> new RoughCoating(0.1, 0.5, false));
        assertThrows(IllegalArgumentException.class, () -> new RoughCoating(1e-5, 1.5, false));
        assertThrows(IllegalArgumentException.class, () -> new SmoothCoating(Double.NaN, false));
    }
}
