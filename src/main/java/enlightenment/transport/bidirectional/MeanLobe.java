package enlightenment.transport.bidirectional;

import enlightenment.bsdf.Bsdf;
import enlightenment.bsdf.Scattering;

/**
 * The BSDF of a rough vertex that a group of paths shares, in place of its own: its density is the group's, and its value is 1, since
 * {@link LightDivision} finds what it reflects to each of the paths. One per thread.
 */
final class MeanLobe implements Bsdf {
    private Bsdf own;
    private LightDivision division;

    /**
     * Sets the vertex.
     *
     * @param lobe its BSDF, opaque, without delta lobes, not narrow
     * @param by divides its light
     */
    void set(Bsdf lobe, LightDivision by) {
        own = lobe;
        division = by;
    }

    @Override
    public boolean isDelta() {
        return false;
    }

    @Override
    public boolean transmits() {
        return false;
    }

    @Override
    public void evaluate(Scattering s) {
        s.pdf = division.aim(s.ix, s.iy, s.iz);
        value(s, s.geometricCosineIn() > 0 ? 1 : 0);
    }

    private static void value(Scattering s, double of) {
        s.valueR = of;
        s.valueG = of;
        s.valueB = of;
    }

    @Override
    public double pdf(Scattering s) {
        return own.pdf(s);
    }

    /** Samples a direction of the path that the vertex was found by, with the density of all of them. */
    @Override
    public boolean sample(Scattering s, double u, double v, double choice) {
        if (!own.sample(s, u, v, choice)) {
            return false;
        }
        s.pdf = division.aim(s.ix, s.iy, s.iz);
        value(s, 1 / s.pdf);
        return s.pdf >= Double.MIN_NORMAL;
    }
}
