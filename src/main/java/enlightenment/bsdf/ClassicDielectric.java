package enlightenment.bsdf;

/**
 * Smooth glass as the paper has it: it refracts all light, or reflects all of it where Snell's law has no solution. The surface's colour
 * is no part of the value: surfaces that coincide are one border of media, and whoever crosses it is filtered by each of them.
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
