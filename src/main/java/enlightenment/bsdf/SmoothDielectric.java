package enlightenment.bsdf;

/**
 * A smooth border of two media, by Fresnel's equations: it reflects their share of the light and refracts the rest. Two delta lobes, of
 * which {@code choice} selects one with the probability of its share. The surface's colour is no part of the value, as of
 * {@link ClassicDielectric}.
 */
public final class SmoothDielectric implements DeltaBsdf {
    public static final SmoothDielectric INSTANCE = new SmoothDielectric();

    private SmoothDielectric() {}

    @Override
    public FlatBsdf flatForm() {
        return new FlatBsdf(FlatBsdf.Kind.GLASS);
    }

    @Override
    public boolean transmits() {
        return true;
    }

    /** Reflects if {@code choice} is below the share that is reflected. */
    @Override
    public boolean sample(Scattering s, double u, double v, double choice) {
        double share = DielectricFresnel.reflectance(s.cosineOutClamped(), s.eta);
        boolean through = choice >= share && s.refract();
        if (through) {
            s.only(1 - share, true);
        } else {
            s.reflect();
            s.only(share, false);
        }
        double value = through && s.radiance ? s.eta * s.eta : 1;
        s.value(value, value, value);
        return s.pdf > 0;
    }
}
