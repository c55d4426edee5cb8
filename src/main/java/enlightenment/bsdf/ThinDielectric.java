package enlightenment.bsdf;

/**
 * A thin slab of glass in one medium, without thickness: it reflects, all inter-reflections between its two faces included, and transmits
 * the rest straight. Two delta lobes, of which {@code choice} selects one with the probability of its share of the light. The surface's
 * colour is not part of the value; {@link Scattering#eta} is the index of refraction of the surrounding medium over that of the slab.
 */
public final class ThinDielectric implements DeltaBsdf {
    public static final ThinDielectric INSTANCE = new ThinDielectric();

    private ThinDielectric() {}

    @Override
    public boolean transmits() {
        return true;
    }

    /**
     * The transmittance of the slab, 0..1, all inter-reflections between its faces included, without its colour: the factor of a shadow ray
     * through it. {@code transmittance} + reflectance = 1; R = 2F/(1 + F) for each polarisation.
     *
     * @param cosine of the angle between the ray's direction and the normal, of any sign
     * @param eta the index of refraction of the surrounding medium over that of the slab, positive
     */
    public static double transmittance(double cosine, double eta) {
        return 1 - DielectricFresnel.paneReflectance(Math.min(Math.abs(cosine), 1), eta);
    }

    /** Reflects if {@code choice} is below the reflectance. */
    @Override
    public boolean sample(Scattering s, double u, double v, double choice) {
        double share = DielectricFresnel.paneReflectance(s.cosineOutClamped(), s.eta);
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
