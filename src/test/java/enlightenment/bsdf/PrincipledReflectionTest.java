package enlightenment.bsdf;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;

/** Principled surfaces are the sum of the surfaces that they mix, and none of their lobes gives light that did not come. */
class PrincipledReflectionTest {
    private static final double[] COSINES = {1, 0.7, 0.3, 0.1, 0.03};
    private static final double[] ALPHAS = {0, 0.01, 0.1, 0.36, 1};

    /** The mean weight of evenly spread samples, which are of the lobes in turn: Halton's sequence. */
    private static double albedo(Place place) {
        int n = 30_000;
        double sum = 0;
        for (int k = 0; k < n; k++) {
            if (place.bsdf.sample(place.s, Halton.at(2, k), Halton.at(3, k), Halton.at(5, k))) {
                sum += place.s.valueR;
            }
        }
        return sum / n;
    }

    private static Bsdf metal(double alpha) {
        return Microfacets.isSmooth(alpha)
                ? new SmoothConductor(Fresnel.SCHLICK)
                : new GlossyReflection(alpha, Fresnel.SCHLICK, true);
    }

    private static Bsdf coated(double alpha, double index) {
        return Microfacets.isSmooth(alpha) ? new SmoothCoating(index, false) : new RoughCoating(alpha, index, false);
    }

    @Test
    void withoutAClearCoatItIsTheMeanOfMetalAndCoatedBase() {
        SplittableRandom random = new SplittableRandom(5);
        for (double alpha : ALPHAS) {
            for (double metallic : new double[] {0, 0.25, 1}) {
                Bsdf bsdf = new PrincipledReflection(metallic, alpha, 1.7, 0, 0.25, 1.5);
                for (int k = 0; k < 200; k++) {
                    double from = random.nextDouble();
                    double to = random.nextDouble();
                    double turn = k % 2 == 0 ? Math.PI : 7 * random.nextDouble();
                    double found = at(bsdf, from, to, turn);
                    double expected = metallic * at(metal(alpha, metallic), from, to, turn)
                            + (1 - metallic) * at(coated(alpha, 1.7, metallic), from, to, turn);
                    assertEquals(expected, found, 1e-6 * expected + 1e-12, "alpha " + alpha + ", metallic " + metallic);
                }
            }
        }
    }

    private static Bsdf metal(double alpha, double share) {
        return share == 0 ? Lambert.INSTANCE : METALS[index(alpha)];
    }

    private static Bsdf coated(double alpha, double index, double metallic) {
        return metallic == 1 ? Lambert.INSTANCE : COATED[index(alpha)];
    }

    private static final Bsdf[] METALS = new Bsdf[ALPHAS.length];
    private static final Bsdf[] COATED = new Bsdf[ALPHAS.length];

    static {
        for (int k = 0; k < ALPHAS.length; k++) {
            METALS[k] = metal(ALPHAS[k]);
            COATED[k] = coated(ALPHAS[k], 1.7);
        }
    }

    private static int index(double alpha) {
        for (int k = 0; k < ALPHAS.length; k++) {
            if (ALPHAS[k] == alpha) {
                return k;
            }
        }
        throw new AssertionError();
    }

    private static double at(Bsdf bsdf, double from, double to, double turn) {
        return Place.seen(bsdf, 0.5)
                .color(0.6, 0.6, 0.6)
                .from(from, 0)
                .to(to, turn)
                .f();
    }

    @Test
    void aWhiteSurfaceWithoutAClearCoatReflectsAllLight() {
        for (double alpha : ALPHAS) {
            for (double metallic : new double[] {0, 0.25, 0.75, 1}) {
                Bsdf bsdf = new PrincipledReflection(metallic, alpha, 1.5, 0, 0, 1.5);
                for (double cosine : COSINES) {
                    String what = "alpha " + alpha + ", metallic " + metallic + " from " + cosine;
                    assertEquals(1, albedo(Place.seen(bsdf, cosine)), 4e-3, what);
                }
            }
        }
    }

    @Test
    void aWhiteMirrorUnderASmoothClearCoatReflectsAllLight() {
        PrincipledReflection bsdf = new PrincipledReflection(1, 0, 1.5, 0.75, 0, 1.5);
        assertTrue(bsdf.isDelta());
        for (double cosine : COSINES) {
            Place place = Place.seen(bsdf, cosine);
            assertTrue(bsdf.sample(place.s, 0, 0, 0));
            assertEquals(1, place.s.pdf);
            assertEquals(1, place.s.valueG, 1e-14);
        }
    }

    @Test
    void aClearCoatOverAWhiteSurfaceLosesLittleAndAddsNothing() {
        for (double alpha : ALPHAS) {
            for (double clearAlpha : new double[] {0, 0.1, 1}) {
                for (double metallic : new double[] {0, 0.5, 1}) {
                    Bsdf bsdf = new PrincipledReflection(metallic, alpha, 1.5, 1, clearAlpha, 1.5);
                    for (double cosine : COSINES) {
                        String what = alpha + " " + clearAlpha + " " + metallic + " from " + cosine;
                        double albedo = albedo(Place.seen(bsdf, cosine));
                        assertTrue(albedo < 1 + 4e-3, what + ": " + albedo);
                        assertTrue(albedo > 1 - 0.07 * metallic - 0.02, what + ": " + albedo);
                    }
                }
            }
        }
    }

    @Test
    void noColourReflectsMoreThanItReceives() {
        SplittableRandom random = new SplittableRandom(12);
        for (int k = 0; k < 40; k++) {
            Bsdf bsdf = new PrincipledReflection(
                    random.nextDouble(),
                    k % 3 == 0 ? 0 : random.nextDouble(),
                    1 + 2 * random.nextDouble(),
                    random.nextDouble(),
                    k % 4 == 0 ? 0 : random.nextDouble(),
                    1.5);
            double color = random.nextDouble();
            double albedo = albedo(Place.seen(bsdf, random.nextDouble()).color(color, color, color));
            assertTrue(albedo < 1 && albedo > 0.3 * color, k + " of " + color + ": " + albedo);
        }
    }

    private static Bsdf velvet(double metallic, double alpha, double share, double tint, double clearcoat) {
        return new PrincipledReflection(
                metallic, alpha, 1.5, clearcoat, 0.25, 1.5, share, tint, new PrincipledLayers());
    }

    /** Burley 2012: Fsheen = (1 − cosθd)⁵, here the half vector is between o and i. */
    @Test
    void sheenAloneIsBurleysLobeInWhiteOrTheColourOfTheSurface() {
        for (double tint : new double[] {0, 0.5, 1}) {
            Bsdf with = new PrincipledReflection(0, 1, 1, 0, 0, 1.5, 0.75, tint, new PrincipledLayers());
            for (double to : COSINES) {
                // Light from where both cosines are alike loses 1 − q, which the albedo says.
                Place place =
                        Place.seen(with, 0.3).color(0, 0.5, 0.25).from(0.3, 0).to(to, 2.5);
                double half = 0.5 * StrictMath.sqrt(2 + 2 * cosineBetween(place.s));
                double lobe = 0.75 * StrictMath.pow(1 - half, 5) * to;
                place.bsdf.evaluate(place.s);
                double base = 1 - 0.75 * Math.max(velvetAlbedo(0.3), velvetAlbedo(to));
                assertEquals(lobe * (1 - tint), place.s.valueR, 1e-12 + 1e-9 * lobe);
                assertEquals(lobe + base * 0.5 * to / Math.PI, place.s.valueG, 1e-4 * to);
                assertEquals(lobe * (1 - 0.5 * tint) + base * 0.25 * to / Math.PI, place.s.valueB, 1e-4 * to);
            }
        }
    }

    private static double cosineBetween(Scattering s) {
        return s.ox * s.ix + s.oy * s.iy + s.oz * s.iz;
    }

    /** Over directions that are evenly spread by their cosine. */
    private static double velvetAlbedo(double mu) {
        int n = 100_000;
        double sum = 0;
        for (int k = 0; k < n; k++) {
            double r = StrictMath.sqrt(Halton.at(2, k));
            double x = r * StrictMath.cos(2 * Math.PI * Halton.at(3, k));
            double between = StrictMath.sqrt(1 - mu * mu) * x + mu * StrictMath.sqrt(1 - r * r);
            sum += Math.PI * StrictMath.pow(1 - StrictMath.sqrt((1 + between) / 2), 5);
        }
        return sum / n;
    }

    @Test
    void sheenAddsNothingAndLosesLittleOfAWhiteSurface() {
        for (double alpha : ALPHAS) {
            for (double share : new double[] {0.25, 1}) {
                Bsdf bsdf = velvet(0, alpha, share, 0.5, 0);
                for (double cosine : COSINES) {
                    double albedo = albedo(Place.seen(bsdf, cosine));
                    assertTrue(albedo < 1 + 4e-3 && albedo > 0.9, alpha + " from " + cosine + ": " + albedo);
                }
            }
        }
    }

    @Test
    void sheenOfAnyColourReflectsNoMoreThanItReceives() {
        SplittableRandom random = new SplittableRandom(13);
        for (int k = 0; k < 40; k++) {
            Bsdf bsdf = velvet(
                    random.nextDouble(),
                    k % 3 == 0 ? 0 : random.nextDouble(),
                    random.nextDouble(),
                    random.nextDouble(),
                    k % 2 == 0 ? 0 : random.nextDouble());
            // A saturated blue, whose luminance is a fourteenth of its largest component.
            Place place = Place.seen(bsdf, random.nextDouble()).color(0, 0, 1);
            int n = 20_000;
            double[] sum = new double[3];
            for (int j = 0; j < n; j++) {
                if (bsdf.sample(place.s, Halton.at(2, j), Halton.at(3, j), Halton.at(5, j))) {
                    sum[0] += place.s.valueR / n;
                    sum[1] += place.s.valueG / n;
                    sum[2] += place.s.valueB / n;
                }
            }
            assertTrue(sum[0] < 1 && sum[1] < 1 && sum[2] < 1 + 4e-3, k + ": " + sum[2]);
        }
    }

    @Test
    void sheenOfMetalIsNone() {
        SplittableRandom random = new SplittableRandom(14);
        Bsdf with = velvet(1, 0.36, 1, 1, 0.5);
        Bsdf without = velvet(1, 0.36, 0, 0, 0.5);
        for (int k = 0; k < 100; k++) {
            double from = random.nextDouble();
            double to = random.nextDouble();
            assertEquals(at(without, from, to, k), at(with, from, to, k));
        }
    }

    @Test
    void sheenIsReciprocal() {
        SplittableRandom random = new SplittableRandom(15);
        Bsdf bsdf = velvet(0.25, 0.5, 0.8, 0.7, 0.5);
        for (int k = 0; k < 200; k++) {
            double from = random.nextDouble();
            double to = random.nextDouble();
            double there = at(bsdf, from, to, k);
            assertEquals(there, at(bsdf, to, from, k), 1e-9 * there);
        }
    }

    @Test
    void blackVelvetIsSeenByItsSheenAlone() {
        Bsdf bsdf = new PrincipledReflection(0, 1, 1, 0, 0, 1.5, 1, 1, new PrincipledLayers());
        assertTrue(bsdf.reflectsIfBlack());
        for (double cosine : COSINES) {
            assertEquals(velvetAlbedo(cosine), albedo(Place.seen(bsdf, cosine).color(0, 0, 0)), 1e-3);
        }
    }

    @Test
    void itHasADeltaLobeWhereALayerIsSmooth() {
        assertTrue(new PrincipledReflection(0.5, 0, 1.5, 0, 0, 1.5).hasDelta());
        assertTrue(new PrincipledReflection(0.5, 0.5, 1.5, 0.5, 0, 1.5).hasDelta());
        assertFalse(new PrincipledReflection(0.5, 0.5, 1.5, 0, 0, 1.5).hasDelta());
        assertFalse(new PrincipledReflection(0, 0, 1, 0, 0, 1.5).hasDelta());
        assertFalse(new PrincipledReflection(1, 0, 1.5, 1, 0.5, 1.5).isDelta());
        assertTrue(new PrincipledReflection(1, 0.01, 1.5, 1, 0.01, 1.5).isNarrow());
        assertFalse(new PrincipledReflection(1, 0.01, 1.5, 1, 0.5, 1.5).isNarrow());
    }
}
