package enlightenment.bsdf;

/**
 * A dielectric layer that covers a share w of a surface. At the cosine μ it reflects wE(μ) and transmits 1 − wE(μ), with E the directional
 * albedo of single reflection at its facets, or Fresnel's reflectance where it is smooth. Immutable.
 */
final class DielectricLayer {
    /** The distribution of its facets; null if it is smooth or absent. */
    final Microfacets facets;

    private final double share;
    private final double eta;
    private final AlbedoTable table;

    /**
     * Makes a layer; a rough one has a table, computed in some milliseconds.
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

    /** Whether its lobe is a delta lobe. */
    boolean isSmooth() {
        return share > 0 && facets == null;
    }

    /** Whether its lobe is narrow, or the layer is absent. */
    boolean isNarrow() {
        return share == 0 || facets != null && facets.isNarrow();
    }

    /** The transmittance at a cosine, 0..1: 1 − wE(μ). */
    double through(double cosine) {
        if (share == 0) {
            return 1;
        }
        return Math.fma(
                share, table == null ? SmoothCoating.transmittance(cosine, eta) : table.loss(cosine), 1 - share);
    }

    /** w times the reflectance of a facet, at the cosine of incidence on the facet. */
    double reflectance(double cosine) {
        return share == 0 ? 0 : share * DielectricFresnel.reflectance(cosine, eta);
    }

    /** Samples i nearly in proportion to light that passes the layer on both ways, with {@link #density}. */
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
