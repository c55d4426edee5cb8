package enlightenment.compiled;

/** From the share of light that a thick medium gives back to that which each of its scatterings leaves. */
final class AlbedoInversion {
    private AlbedoInversion() {}

    /**
     * The albedo of single scattering of an isotropic half-space without a border that reflects, by the fit of M. Chiang, P. Kutz and B. Burley
     * ("Practical and controllable subsurface scattering for production path tracing", 2016).
     *
     * @param givenBack the share of light that it gives back, 0..1
     */
    static double singleScattering(double givenBack) {
        double exponent = givenBack * Math.fma(givenBack, Math.fma(givenBack, -4.31805, 2.61188), -5.09406);
        return 1 - StrictMath.exp(exponent);
    }
}
