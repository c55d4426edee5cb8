package enlightenment.bsdf;

/**
 * A smooth interface of two media, by Fresnel's equations. Two delta lobes, reflection and refraction, of which {@code choice} selects one
 * with the probability of its share of the light. The surface's colour is not part of the value, as for {@link ClassicDielectric}.
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

    /** Reflects if {@code choice} is below the reflectance. */
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
