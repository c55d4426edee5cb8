package enlightenment.bsdf;

/**
 * Smooth glass of the paper: it refracts all light, or reflects all of it at total internal reflection. The surface's colour is not part of
 * the value: surfaces that coincide are one interface of media, and the caller multiplies by the colour of each.
 */
public final class ClassicDielectric implements DeltaBsdf {
    public static final ClassicDielectric INSTANCE = new ClassicDielectric();

    private ClassicDielectric() {}

    @Override
    public FlatBsdf flatForm() {
        return new FlatBsdf(FlatBsdf.Kind.GLASS);
    }

    @Override
    public boolean transmits() {
        return true;
    }

    @Override
    public boolean sample(Scattering s, double u, double v, double choice) {
        boolean through = s.refract();
        if (!through) {
            s.reflect();
        }
        s.certain(through);
        double value = through && s.radiance ? s.eta * s.eta : 1;
        s.value(value, value, value);
        return true;
    }
}
