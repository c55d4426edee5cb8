package enlightenment.bsdf;

/**
 * A smooth interface of two media on triangles with vertex normals: {@link SmoothDielectric} about the shading normal. Light that would
 * leave to the wrong side of the triangle is lost, and so is light from behind the shading normal; both are symmetric in the direction of
 * light.
 *
 * <p>Light paths are corrected by |ω_i·n_s||ω_o·n_g| / (|ω_i·n_g||ω_o·n_s|), ω_i towards the light and ω_o towards the eye (E. Veach,
 * "Robust Monte Carlo methods for light transport simulation", 1997, section 5.3): {@link Scattering#fromLight} says which it is. Where the
 * two normals are equal, it is a {@link SmoothDielectric}.
 */
public final class SmoothRefraction implements DeltaBsdf {
    public static final SmoothRefraction INSTANCE = new SmoothRefraction();

    private SmoothRefraction() {}

    @Override
    public FlatBsdf flatForm() {
        return new FlatBsdf(FlatBsdf.Kind.SMOOTH_GLASS);
    }

    @Override
    public boolean transmits() {
        return true;
    }

    /** Reflects if {@code choice} is below the reflectance. */
    @Override
    public boolean sample(Scattering s, double u, double v, double choice) {
        boolean goes = s.cosineOut() > 0 && SmoothDielectric.INSTANCE.sample(s, u, v, choice);
        double side = s.transmitted ? -1 : 1;
        if (!goes || !(side * s.geometricCosineIn() > 0) || !(side * s.cosineIn() > 0)) {
            s.nothing();
            return false;
        }
        if (s.fromLight) {
            double f = (s.cosineOut() / s.geometricCosineOut()) * (s.geometricCosineIn() / s.cosineIn());
            s.value(s.valueR * f, s.valueG * f, s.valueB * f);
        }
        return true;
    }
}
