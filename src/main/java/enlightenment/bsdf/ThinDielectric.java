package enlightenment.bsdf;

/**
 * A pane without thickness, of glass in one medium: it reflects, with all that goes to and fro between its two faces, and lets the rest
 * pass straight on. Two delta lobes, of which {@code choice} selects one with the probability of its share. The surface's colour is no
 * part of the value; {@link Scattering#eta} is not asked for.
 */
public final class ThinDielectric implements DeltaBsdf {
    private final double eta;

    /**
     * A pane.
     *
     * @param index its index of refraction over that of what surrounds it, positive
     */
    public ThinDielectric(double index) {
        if (!(index > 0) || index == Double.POSITIVE_INFINITY) {
            throw new IllegalArgumentException("index of refraction " + index);
        }
        eta = 1 / index;
    }

    @Override
    public boolean transmits() {
        return true;
    }

    /**
     * The share of light that passes straight on, 0..1: what a shadow ray through the pane is worth.
     *
     * @param cosine of the angle between its direction and the normal, of any sign
     */
    public double transmittance(double cosine) {
        return 1 - DielectricFresnel.paneReflectance(Math.min(Math.abs(cosine), 1), eta);
    }

    /** Reflects if {@code choice} is below the share that is reflected. */
    @Override
    public boolean sample(Scattering s, double u, double v, double choice) {
        double share = DielectricFresnel.paneReflectance(s.cosineOutClamped(), eta);
        if (choice < share) {
            s.reflect();
            s.only(share, false);
        } else {
            s.direct(-s.ox, -s.oy, -s.oz);
            s.only(1 - share, true);
        }
        s.value(1, 1, 1);
        return s.pdf > 0;
    }
}
