package enlightenment.bsdf;

/**
 * The matte base under a dielectric coat of relative index n: light that enters the coat with the transmittance T(μo) is reflected by the base,
 * partly back to it by the coat from below, and leaves with T(μi). With T̄ = 2∫Tμ dμ, f = m T(μo)T(μi)/(π T̄), which is reciprocal and whose
 * albedo is m T(μo): a base of reflectance 1 has m = 1, so that nothing is lost.
 */
final class CoatedBase {
    /** The internal diffuse reflectance of the coat, F̄ = 1 − T̄/n²: the share of diffuse light that it reflects back to the base. */
    private final double inside;

    private final boolean nonlinear;

    /**
     * @param index n, at least 1
     * @param meanThrough T̄, 0..1
     * @param nonlinear whether each inter-reflection below the coat multiplies by the base's colour
     */
    CoatedBase(double index, double meanThrough, boolean nonlinear) {
        inside = 1 - meanThrough / (index * index);
        this.nonlinear = nonlinear;
    }

    /** For code on another device. */
    double[] numbers() {
        return new double[] {inside, nonlinear ? 1 : 0};
    }

    /** The factor m, 0..1, of a base of this reflectance ρ: ρ(1 − F̄)/(1 − ρF̄), or ρ itself. */
    double reflected(double color) {
        return nonlinear ? color * (1 - inside) / (1 - color * inside) : color;
    }

    /** The probability of sampling the coat's own reflection, by the albedos of both lobes for light from o: 1 − T(μo) and m T(μo). */
    double share(Scattering s, double through) {
        double coat = 1 - through;
        return coat > 0 ? coat / (coat + reflected(s, through)) : 0;
    }

    /**
     * The probability of sampling a delta lobe: raised where it reflects less than the base, since only this lobe finds lamps that it
     * reflects.
     */
    double shareOfDelta(Scattering s, double through) {
        double coat = 1 - through;
        double base = reflected(s, through);
        if (!(coat > 0)) {
            return 0;
        }
        return coat < base ? Math.sqrt(coat) / (Math.sqrt(coat) + Math.sqrt(base)) : coat / (coat + base);
    }

    private double reflected(Scattering s, double through) {
        return through * (reflected(s.red) + reflected(s.green) + reflected(s.blue)) / 3;
    }

    /** Sets the value to that of the base plus a colourless term. */
    void value(Scattering s, double diffuse, double coat) {
        s.value(
                Math.fma(reflected(s.red), diffuse, coat),
                Math.fma(reflected(s.green), diffuse, coat),
                Math.fma(reflected(s.blue), diffuse, coat));
    }

    static double checked(double index) {
        if (!(index > 1 && index < Double.POSITIVE_INFINITY)) {
            throw new IllegalArgumentException("refractive index " + index);
        }
        return index;
    }
}
