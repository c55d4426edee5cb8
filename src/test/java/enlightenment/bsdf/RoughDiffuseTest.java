package enlightenment.bsdf;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import enlightenment.sampling.SphereCells;
import org.junit.jupiter.api.Test;

/** The rough matte surface keeps energy and has the albedo that its authors state. */
class RoughDiffuseTest {
    private static double albedo(double roughness, double color, double cosine) {
        Place place = Place.seen(new RoughDiffuse(roughness), cosine).color(color, color, color);
        SphereCells cells = new SphereCells(place.normal(), 1, 12, 12);
        return cells.integral(place::valueAt, 1e-7);
    }

    @Test
    void aWhiteOneReflectsAllLightFromEveryDirection() {
        for (double r : new double[] {0, 0.5, 1}) {
            for (double cosine : new double[] {1, 0.7, 0.3, 0.05, 1e-3}) {
                assertEquals(1, albedo(r, 1, cosine), 1e-5, r + " from " + cosine);
            }
        }
    }

    @Test
    void aGreyOneHasTheAlbedoOfTheClosedForm() {
        double[] cosines = {0.05, 0.3, 0.7, 1};
        double[] known = {0.4965, 0.4780, 0.4503, 0.4390};
        for (int k = 0; k < 4; k++) {
            assertEquals(known[k], albedo(1, 0.5, cosines[k]), 1e-4);
        }
    }

    @Test
    void withoutRoughnessItIsLambert() {
        Place rough = Place.seen(new RoughDiffuse(0), 0.3).color(0.8, 0.5, 0).to(0.6, 2);
        Place smooth = Place.seen(Lambert.INSTANCE, 0.3).color(0.8, 0.5, 0).to(0.6, 2);
        rough.bsdf.evaluate(rough.s);
        smooth.bsdf.evaluate(smooth.s);
        assertEquals(smooth.s.valueR, rough.s.valueR, 1e-16);
        assertEquals(smooth.s.valueG, rough.s.valueG, 1e-16);
        assertEquals(0, rough.s.valueB);
        assertEquals(smooth.s.pdf, rough.s.pdf, 1e-16);
    }

    @Test
    void moreLightGoesBackThanOnward() {
        Place back = Place.seen(new RoughDiffuse(1), 0.3).to(0.3, 0.7);
        Place onward = Place.seen(new RoughDiffuse(1), 0.3).to(0.3, 0.7 + Math.PI);
        assertEquals(true, back.f() > 2 * onward.f());
    }

    @Test
    void roughnessIsAShare() {
        assertThrows(IllegalArgumentException.class, () -> new RoughDiffuse(-0.1));
        assertThrows(IllegalArgumentException.class, () -> new RoughDiffuse(Double.NaN));
        assertThrows(IllegalArgumentException.class, () -> new RoughDiffuse(1.1));
    }
}
