package enlightenment.bsdf;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.math.Vec3;
import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;

/** Glass, smooth, thin or rough, reflects and transmits by Fresnel's and Snell's laws. */
class DielectricTest {
    private final SplittableRandom random = new SplittableRandom(11);

    @Test
    void smoothGlassReflectsFresnelsShareAndRefractsTheRest() {
        for (double eta : new double[] {1 / 1.5, 1.5, 1 / 2.4, 1}) {
            for (double cosine : new double[] {1, 0.9, 0.5, 0.05}) {
                Place place = Place.seen(SmoothDielectric.INSTANCE, cosine).eta(eta);
                double share = DielectricFresnel.reflectance(cosine, eta);
                int reflected = 0;
                int n = 2_000;
                for (int k = 0; k < n; k++) {
                    assertTrue(place.bsdf.sample(place.s, 0.5, 0.5, (k + 0.5) / n));
                    assertTrue(place.s.delta);
                    assertEquals(1, place.s.valueR);
                    assertEquals(place.s.transmitted ? 1 - share : share, place.s.pdf, 1e-12);
                    reflected += place.s.transmitted ? 0 : 1;
                    checkDirection(place, eta);
                }
                assertEquals(share * n, reflected, 1);
            }
        }
    }

    private static void checkDirection(Place place, double eta) {
        Vec3 n = place.normal();
        if (place.s.transmitted) {
            Vec3 bent = n.cross(place.o()).times(eta).plus(n.cross(place.i()));
            assertEquals(0, bent.length(), 1e-15);
            assertTrue(place.i().dot(n) < 0);
        } else {
            assertEquals(0, place.i().minus(place.mirrored()).length(), 1e-15);
        }
    }

    @Test
    void radianceThatIsRefractedGrowsByTheSquareOfTheIndexAndImportanceDoesNot() {
        for (Bsdf bsdf : List.of(SmoothDielectric.INSTANCE, new RoughDielectric(1e-3, true))) {
            for (double eta : new double[] {1 / 1.5, 1.5}) {
                Place place = Place.seen(bsdf, 0.95).eta(eta);
                place.s.radiance = true;
                assertTrue(bsdf.sample(place.s, 0.4, 0.6, 0.999));
                assertTrue(place.s.transmitted);
                assertEquals(eta * eta, place.s.valueG, 1e-5);
                assertTrue(bsdf.sample(place.s, 0.4, 0.6, 0));
                assertTrue(!place.s.transmitted);
                assertEquals(1, place.s.valueG, 1e-5);
                place.s.radiance = false;
                assertTrue(bsdf.sample(place.s, 0.4, 0.6, 0.999));
                assertEquals(1, place.s.valueG, 1e-5);
            }
        }
    }

    @Test
    void aPaneReflectsTwiceAndDoesNotBend() {
        ThinDielectric pane = ThinDielectric.INSTANCE;
        assertTrue(pane.isDelta() && pane.transmits());
        Place place = Place.seen(pane, 0.4).eta(1 / 1.5);
        place.s.radiance = true;
        double share = 1 - ThinDielectric.transmittance(0.4, 1 / 1.5);
        assertTrue(share > DielectricFresnel.reflectance(0.4, 1 / 1.5));
        assertTrue(pane.sample(place.s, 0, 0, share + 1e-9));
        assertEquals(0, place.i().plus(place.o()).length(), 1e-15);
        assertTrue(place.s.transmitted && place.s.delta);
        assertEquals(1 - share, place.s.pdf, 1e-15);
        assertEquals(1, place.s.valueB);
        assertTrue(pane.sample(place.s, 0, 0, share - 1e-9));
        assertEquals(0, place.i().minus(place.mirrored()).length(), 1e-15);
        assertEquals(1, place.s.valueB);
        pane.evaluate(place.s);
        assertEquals(0, place.s.valueR + place.s.pdf + pane.pdf(place.s));
    }

    @Test
    void roughGlassNeverGivesMoreThanItGets() {
        for (double alpha : new double[] {1e-4, 0.01, 0.1, 0.5, 1}) {
            for (double eta : new double[] {1 / 2.4, 1 / 1.5, 1 / 1.01, 1.01, 1.5, 2.4}) {
                for (double cosine : new double[] {1, 0.5, 0.05, 1e-3}) {
                    Place place = Place.seen(new RoughDielectric(alpha, false), cosine)
                            .eta(eta);
                    int n = 2_000;
                    double sum = 0;
                    for (int k = 0; k < n; k++) {
                        double u = random.nextDouble();
                        if (place.bsdf.sample(place.s, u, random.nextDouble(), random.nextDouble())) {
                            assertTrue(place.s.valueR <= 1 + 1e-12);
                            sum += place.s.valueR;
                        }
                    }
                    double least = alpha <= 1e-4 && cosine >= 0.05 ? 0.999 : cosine >= 0.5 ? 0.25 : 0.01;
                    assertTrue(sum >= least * n, alpha + " " + eta + " from " + cosine + ": " + sum / n);
                }
            }
        }
    }

    @Test
    void theValueOfRoughGlassIsThatOfTheTextbook() {
        int through = 0;
        for (int k = 0; k < 20_000; k++) {
            double alpha = 0.1 + 0.9 * random.nextDouble();
            double no = 1 + random.nextDouble();
            double ni = 1 + random.nextDouble();
            Place place = Place.seen(new RoughDielectric(alpha, false), 0.05 + 0.95 * random.nextDouble());
            place.eta(no / ni).to(-0.05 - 0.95 * random.nextDouble(), 7 * random.nextDouble());
            // Walter et al. 2007, equations 16 and 21; their o is where light goes to, and our path comes from there.
            Vec3 h = place.o().times(no).plus(place.i().times(ni)).normalized();
            Vec3 m = h.dot(place.normal()) < 0 ? h.negated() : h;
            double co = m.dot(place.o());
            double ci = m.dot(place.i());
            double expected = 0;
            if (co > 0 && ci < 0) {
                double out = place.o().dot(place.normal());
                double in = Math.abs(place.i().dot(place.normal()));
                double mz = m.dot(place.normal());
                double d = alpha * alpha / (Math.PI * Math.pow((alpha * alpha - 1) * mz * mz + 1, 2));
                double g = 1 / (1 + lambda(alpha, out) + lambda(alpha, in));
                double change = ni * ni / Math.pow(no * co + ni * ci, 2);
                double share = 1 - DielectricFresnel.reflectance(co, no / ni);
                expected = co * -ci / (out * in) * share * d * g * change;
                through++;
            }
            assertEquals(expected, place.f(), 1e-7 * expected);
        }
        assertTrue(through > 1_000, through + " of them refract");
    }

    private static double lambda(double alpha, double cosine) {
        double tan2 = (1 - cosine * cosine) / (cosine * cosine);
        return (Math.sqrt(1 + alpha * alpha * tan2) - 1) / 2;
    }

    @Test
    void roughGlassBetweenEqualMediaLetsAllPassStraight() {
        Place place = Place.seen(new RoughDielectric(0.5, true), 0.4).eta(1);
        place.s.radiance = true;
        assertTrue(place.bsdf.sample(place.s, 0.2, 0.3, 0.4));
        assertTrue(place.s.delta && place.s.transmitted);
        assertEquals(0, place.i().plus(place.o()).length(), 1e-15);
        assertEquals(1, place.s.valueR);
        assertEquals(0, place.bsdf.pdf(place.s));
    }
}
