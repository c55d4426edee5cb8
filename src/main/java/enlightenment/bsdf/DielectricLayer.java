package enlightenment.bsdf;

/**
 * A dielectric layer over something else, present to a share of the surface: of light at the cosine μ it reflects wE(μ) and passes
 * 1 − wE(μ) on, with w the share and E the directional albedo of single reflection at its facets, or Fresnel's reflectance where it is
 * smooth. Immutable.
 */
final class DielectricLayer {
    /** The distribution of its facets; null where it is smooth or absent. */
    final Microfacets facets;

    private final double share;
    private final double eta;
    private final AlbedoTable table;

    /**
     * A layer: if it is rough, makes a table, in some milliseconds.
     *
     * @param share w, 0..1; 0: there is none
     * @param alpha the roughness α of GGX, 0..1
     * @param index the index of refraction relative to the outside, at least 1; 1: there is none
     */
    DielectricLayer(double share, double alpha, double index) {
        this.share = index == 1 ? 0 : share;
        eta = 1 / index;
        facets = this.share == 0 || Microfacets.isSmooth(alpha) ? null : new Microfacets(alpha);
        table = facets == null ? null : new AlbedoTable(new VisibleNormals.OfCoat(facets, eta));
    }

    boolean isAbsent() {
        return share == 0;
    }

    /** Whether it reflects into a single direction. */
    boolean isSmooth() {
        return share > 0 && facets == null;
    }

    /** Whether its lobe is narrow, or there is none. */
    boolean isNarrow() {
        return share == 0 || facets != null && facets.isNarrow();
    }

    /** The share of light that passes at a cosine, 0..1: 1 − wE(μ). */
    double through(double cosine) {
        if (share == 0) {
            return 1;
        }
        return Math.fma(
                share, table == null ? SmoothCoating.transmittance(cosine, eta) : table.loss(cosine), 1 - share);
    }

    /** w times the reflectance of a facet, at the cosine of incidence there. */
    double reflectance(double cosine) {
        return share == 0 ? 0 : share * DielectricFresnel.reflectance(cosine, eta);
    }

    /** Samples i about as what has passed the layer on both ways: with {@link #density}. */
    void sampleBelow(Scattering s, double u, double v) {
        if (table == null) {
            s.sampleCosine(u, v);
        } else {
            table.sampleDirection(s, u, v);
        }
    }

    /** The density per solid angle of {@link #sampleBelow} at a positive cosine. */
    double density(double cosine) {
        return table == null ? cosine / Math.PI : table.density(Math.min(cosine, 1));
    }
}
