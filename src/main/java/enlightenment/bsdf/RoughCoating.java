package enlightenment.bsdf;

/**
 * A rough dielectric coat over a matte base, such as satin paint: {@link Microfacets} that reflect by Fresnel's equations, and the diffuse
 * lobe of a {@link CoatedBase}, where T is everything that single reflection does not reflect: light that meets a second facet enters the
 * coat there, except for the few percent of its reflectance. Opaque; the same on both sides.
 */
public final class RoughCoating implements Bsdf {
    private final Microfacets facets;
    private final double eta;
    private final AlbedoTable through;
    private final double scale;
    private final CoatedBase base;

    /**
     * Makes a coated surface, whose colour is that of the base; computes a table, in some milliseconds.
     *
     * @param alpha the roughness α of GGX of the coat, at most 1 and not {@linkplain Microfacets#isSmooth smooth}
     * @param index the index of refraction of the coat relative to the outside, greater than 1
     * @param nonlinear whether each inter-reflection below the coat multiplies by the base's colour
     */
    public RoughCoating(double alpha, double index, boolean nonlinear) {
        facets = new Microfacets(alpha);
        eta = 1 / CoatedBase.checked(index);
        through = new AlbedoTable(new VisibleNormals.OfCoat(facets, eta));
        scale = 1 / (Math.PI * through.meanLoss);
        base = new CoatedBase(index, through.meanLoss, nonlinear);
    }

    @Override
    public boolean isDelta() {
        return false;
    }

    @Override
    public boolean reflectsIfBlack() {
        return true;
    }

    @Override
    public FlatBsdf flatForm() {
        return FlatBsdf.of(
                FlatBsdf.Kind.ROUGH_COAT,
                new double[] {eta, scale},
                base.numbers(),
                facets.numbers(),
                through.numbers());
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
        double out = s.cosineOutClamped();
        double entering = through.loss(out);
        facets.at(s, s.ox + s.ix, s.oy + s.iy, s.oz + s.iz);
        double coat = 0.5 * s.facets * facets.masking(in, out) * DielectricFresnel.reflectance(s.cosineFacet, eta);
        s.pdf = mixed(s, in, out, entering);
        base.value(s, entering * through.loss(Math.min(in, 1)) * in * scale, coat);
    }

    /** The density of the mixture of both lobes; call after {@link Microfacets#at}. */
    private double mixed(Scattering s, double in, double out, double entering) {
        double share = base.share(s, entering);
        return Math.fma(share, 0.5 * s.facets * facets.visible(out), (1 - share) * through.density(Math.min(in, 1)));
    }

    @Override
    public double pdf(Scattering s) {
        double in = s.cosineIn();
        if (!(in > 0)) {
            return 0;
        }
        double out = s.cosineOutClamped();
        facets.at(s, s.ox + s.ix, s.oy + s.iy, s.oz + s.iz);
        return mixed(s, in, out, through.loss(out));
    }

    @Override
    public boolean sample(Scattering s, double u, double v, double choice) {
        s.transmitted = false;
        if (choice >= base.share(s, through.loss(s.cosineOutClamped()))) {
            through.sampleDirection(s, u, v);
        } else if (facets.sampleVisible(s, u, v)) {
            s.reflectFrom(s.ix, s.iy, s.iz);
        } else {
            return false;
        }
        evaluate(s);
        return s.weigh();
    }
}
