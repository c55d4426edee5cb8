package enlightenment.bsdf;

/**
 * Surfaces all of whose lobes are delta lobes: {@link #evaluate} and {@link #pdf} are 0, and {@link #sample} returns the only directions.
 */
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
