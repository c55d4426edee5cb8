package enlightenment.bsdf;

/** Surfaces all of whose lobes are delta lobes: only {@link #sample} finds what they do. */
public sealed interface DeltaBsdf extends Bsdf
        permits SpecularReflection,
                SmoothConductor,
                ClassicDielectric,
                SmoothDielectric,
                SmoothRefraction,
                ThinDielectric {
    @Override
    default boolean isDelta() {
        return true;
    }

    @Override
    default void evaluate(Scattering s) {
        s.nothing();
    }

    @Override
    default double pdf(Scattering s) {
        return 0;
    }
}
