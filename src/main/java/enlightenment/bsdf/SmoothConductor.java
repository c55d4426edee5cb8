package enlightenment.bsdf;

/** A smooth metal, or another polished opaque surface: one delta lobe, the mirror image, with the Fresnel reflectance. */
public final class SmoothConductor implements DeltaBsdf {
    private final Fresnel fresnel;

    /**
     * Makes a polished surface.
     *
     * @param fresnel its reflectance
     */
    public SmoothConductor(Fresnel fresnel) {
        this.fresnel = fresnel;
    }

    @Override
    public boolean reflectsIfBlack() {
        return fresnel.reflectsIfBlack();
    }

    @Override
    public FlatBsdf flatForm() {
        return new FlatBsdf(FlatBsdf.Kind.METAL, fresnel.numbers());
    }

    @Override
    public boolean transmits() {
        return false;
    }

    @Override
    public boolean sample(Scattering s, double u, double v, double choice) {
        s.reflect();
        s.certain(false);
        fresnel.at(s.cosineOutClamped(), s);
        return true;
    }
}
