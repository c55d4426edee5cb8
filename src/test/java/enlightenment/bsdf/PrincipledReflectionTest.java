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
