package enlightenment.bsdf;

/** A perfect mirror: one delta lobe, whose reflectance is the surface's colour at every angle. */
public final class SpecularReflection implements DeltaBsdf {
    public static final SpecularReflection INSTANCE = new SpecularReflection();

    private SpecularReflection() {}

    @Override
    public FlatBsdf flatForm() {
        return new FlatBsdf(FlatBsdf.Kind.MIRROR);
    }

    @Override
    public boolean transmits() {
        return false;
    }

    @Override
    public boolean sample(Scattering s, double u, double v, double choice) {
        s.reflect();
        s.certain(false);
        s.value(s.red, s.green, s.blue);
        return true;
    }
}
