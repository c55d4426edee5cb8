package enlightenment.bsdf;

/**
 * A smooth dielectric coat over a matte base, such as varnish or polished plastic: a delta lobe, the mirror image by Fresnel's equations,
 * and the diffuse lobe of a {@link CoatedBase} with T = 1 − F. Opaque; the same on both sides.
 */
public final class SmoothCoating implements Bsdf {
    private static final int POINTS = 64;

    private final double eta;
    private final double scale;
    private final CoatedBase base;

    /**
     * Makes a coated surface, whose colour is that of the base.
     *
     * @param index the index of refraction of the coat relative to the outside, greater than 1
     * @param nonlinear whether each inter-reflection below the coat multiplies by the base's colour
     */
    public SmoothCoating(double index, boolean nonlinear) {
        eta = 1 / CoatedBase.checked(index);
        double mean = meanTransmittance(eta);
        scale = 1 / (Math.PI * mean);
        base = new CoatedBase(index, mean, nonlinear);
    }

    /** The mean transmittance 2∫Tμ dμ, integrated over μ = x⁴, in which T is smooth for indices near 1 as well. */
    static double meanTransmittance(double eta) {
        double total = 0;
        for (int k = 0; k < POINTS; k++) {
            double x = GaussLegendre.node(POINTS, k);
            double x3 = x * x * x;
            total += GaussLegendre.weight(POINTS, k) * 8 * x3 * x3 * x * transmittance(x3 * x, eta);
        }
        return Math.min(total, 1);
    }

    /** The transmittance into a coat at a cosine, 0..1. */
    static double transmittance(double cosine, double eta) {
        double refracted = Math.sqrt(DielectricFresnel.refracted2(cosine, eta));
        return Math.min(DielectricFresnel.transmittance(cosine, refracted, eta), 1);
    }

    @Override
    public boolean isDelta() {
        return false;
    }

    @Override
    public boolean hasDelta() {
        return true;
    }

    @Override
    public boolean reflectsIfBlack() {
        return true;
    }

    @Override
    public FlatBsdf flatForm() {
        return FlatBsdf.of(FlatBsdf.Kind.COAT, new double[] {eta, scale}, base.numbers());
    }

    @Override
    public boolean transmits() {
        return false;
    }

    @Override
    public void evaluate(Scattering s) {
        double in = s.cosineIn();
        if (!(in > 0)) {
            s.nothing();
            return;
        }
        double through = transmittance(s.cosineOutClamped(), eta);
        double diffuse = through * transmittance(Math.min(in, 1), eta) * in * scale;
        s.pdf = (1 - base.shareOfDelta(s, through)) * in / Math.PI;
        base.value(s, diffuse, 0);
    }

    @Override
    public double pdf(Scattering s) {
        double in = s.cosineIn();
        return in > 0 ? (1 - base.shareOfDelta(s, transmittance(s.cosineOutClamped(), eta))) * in / Math.PI : 0;
    }

    @Override
    public boolean sample(Scattering s, double u, double v, double choice) {
        double through = transmittance(s.cosineOutClamped(), eta);
        double share = base.shareOfDelta(s, through);
        if (choice < share) {
            s.reflect();
            s.only(share, false);
            double weight = (1 - through) / share;
            s.value(weight, weight, weight);
            return true;
        }
        s.sampleCosine(u, v);
        s.transmitted = false;
        evaluate(s);
        return s.weigh();
    }
}
