package enlightenment.bsdf;

/**
 * Rough metal and other opaque glossy surfaces: {@link Microfacets} that reflect, f = F·D·G2/(4 μo μi), sampled by the normals that are
 * visible from o. Optionally the light that single scattering loses among the microfacets is compensated by a second, broad lobe (C. Kulla
 * and A. Conty, "Revisiting physically based shading at Imageworks", 2017), which is reciprocal: a white surface then reflects all light.
 */
public final class GlossyReflection implements Bsdf {
    /** The least probability of sampling visible normals. */
    private static final double LEAST_SHARE = 0.1;

    private final Microfacets facets;
    private final Fresnel fresnel;
    private final AlbedoTable table;

    /**
     * Makes a rough surface.
     *
     * @param alpha its roughness α of GGX, at most 1 and not {@linkplain Microfacets#isSmooth smooth}
     * @param fresnel the reflectance of a microfacet
     * @param compensate whether multiple scattering is compensated: makes a table, in some milliseconds
     */
    public GlossyReflection(double alpha, Fresnel fresnel, boolean compensate) {
        facets = new Microfacets(alpha);
        this.fresnel = fresnel;
        table = compensate ? new AlbedoTable(new VisibleNormals.OfMirrors(facets)) : null;
    }

    @Override
    public boolean isDelta() {
        return false;
    }

    @Override
    public boolean reflectsIfBlack() {
        return fresnel.reflectsIfBlack();
    }

    @Override
    public boolean isNarrow() {
        return facets.isNarrow();
    }

    @Override
    public FlatBsdf flatForm() {
        return FlatBsdf.of(
                FlatBsdf.Kind.ROUGH_METAL,
                fresnel.numbers(),
                facets.numbers(),
                new double[] {table == null ? 0 : 1},
                table == null ? new double[0] : table.numbers());
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
        double single = single(s, in, out);
        s.pdf = visible(s, out);
        fresnel.at(s.cosineFacet, s);
        if (table == null) {
            s.value(s.valueR * single, s.valueG * single, s.valueB * single);
        } else {
            compensate(s, in, out, single);
        }
    }

    @Override
    public void evaluate(ScatteringBatch b, int from, int to) {
        b.findCosines(from, to);
        facets.evaluate(b, from, to);
        fresnel.at(b, from, to);
        if (table == null) {
            multiply(b.valueR, b.single, from, to);
            multiply(b.valueG, b.single, from, to);
            multiply(b.valueB, b.single, from, to);
        } else {
            for (int n = from; n < to; n++) {
                Scattering s = b.found(n);
                compensate(s, Math.max(b.in[n], 0), b.out[n], b.single[n]);
                b.find(n, s);
            }
        }
        b.clearBelow(from, to);
    }

    private static void multiply(double[] value, double[] by, int from, int to) {
        for (int n = from; n < to; n++) {
            value[n] *= by[n];
        }
    }

    /** Sets the value to the reflectance of a microfacet at normal incidence. */
    public void reflectAtNormal(Scattering s) {
        fresnel.at(1, s);
    }

    /** Sets D, and returns the value of single reflection at a white surface. */
    private double single(Scattering s, double in, double out) {
        facets.at(s, s.ox + s.ix, s.oy + s.iy, s.oz + s.iz);
        return 0.5 * s.facets * facets.masking(in, out);
    }

    private double visible(Scattering s, double out) {
        return 0.5 * s.facets * facets.visible(out);
    }

    /** Adds the compensating lobe to value and density, given the value of white single reflection. */
    private void compensate(Scattering s, double in, double out, double single) {
        double lost = table.loss(out);
        double r = fresnel.meanR(s);
        double g = fresnel.meanG(s);
        double b = fresnel.meanB(s);
        double moreR = table.multiple(r);
        double moreG = table.multiple(g);
        double moreB = table.multiple(b);
        s.pdf = mixed(s.pdf, share(r + g + b, moreR + moreG + moreB, lost), in);
        double more = lost * table.loss(in) * in / (Math.PI * table.meanLoss);
        s.value(
                Math.fma(s.valueR, single, moreR * more),
                Math.fma(s.valueG, single, moreG * more),
                Math.fma(s.valueB, single, moreB * more));
    }

    /** The probability of sampling visible normals, by the albedos of both lobes for light from o. */
    private static double share(double first, double more, double lost) {
        double single = first * (1 - lost);
        double both = Math.fma(more, lost, single);
        return both > 0 ? Math.max(single / both, LEAST_SHARE) : 1;
    }

    private double mixed(double visible, double share, double in) {
        return Math.fma(share, visible, (1 - share) * table.density(in));
    }

    @Override
    public double pdf(Scattering s) {
        double in = s.cosineIn();
        if (!(in > 0)) {
            return 0;
        }
        double out = s.cosineOutClamped();
        facets.at(s, s.ox + s.ix, s.oy + s.iy, s.oz + s.iz);
        return table == null ? visible(s, out) : mixed(visible(s, out), share(s, out), in);
    }

    private double share(Scattering s, double out) {
        double r = fresnel.meanR(s);
        double g = fresnel.meanG(s);
        double b = fresnel.meanB(s);
        return share(r + g + b, table.multiple(r) + table.multiple(g) + table.multiple(b), table.loss(out));
    }

    @Override
    public boolean sample(Scattering s, double u, double v, double choice) {
        s.transmitted = false;
        double out = s.cosineOutClamped();
        if (table != null && choice >= share(s, out)) {
            table.sampleDirection(s, u, v);
        } else if (facets.sampleVisible(s, u, v)) {
            s.reflectFrom(s.ix, s.iy, s.iz);
        } else {
            return false;
        }
        evaluate(s);
        return s.weigh();
    }
}
