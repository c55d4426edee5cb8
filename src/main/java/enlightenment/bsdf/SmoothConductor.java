package enlightenment.bsdf;

/** A smooth metal, or another opaque surface that is polished: one delta lobe, the mirror image, with Fresnel's share of the light. */
public final class SmoothConductor implements DeltaBsdf {
    private final Fresnel fresnel;

    /**
     * A polished surface.
     *
     * @param fresnel what share it reflects
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
