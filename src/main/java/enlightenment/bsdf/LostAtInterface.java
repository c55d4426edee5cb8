package enlightenment.bsdf;

/**
 * The energy loss of single scattering at a rough interface of two media, from both sides, and the share of it that is transmitted. Sides
 * are named by their index of refraction: rare for the lower, dense for the higher one.
 *
 * <p>With L = 1 − E the loss of a side and L̄ its mean, lost light leaves on either side in proportion to that side's Lμ. From one side the
 * share t is transmitted, 1 − t reflected; reciprocity requires t L̄ n² to be the same from both sides, {@link #through} here, where n is 1
 * on the rare side. One number is then left to choose: on the rare side lost light meets the surface again from outside, and is reflected
 * like diffuse light, less so the rougher the surface is, since it has more chances to get through. Compared with random walks among facets
 * (E. Heitz, J. Hanika, E. d'Eon and C. Dachsbacher, "Multiple-scattering microfacet BSDFs with the Smith model", 2016):
 * docs/notes/bsdfs.md.
 */
final class LostAtInterface {
    /** The reduction of the reflected share at the roughest surface. */
    private static final double LESS_AT_ROUGHEST = 0.75;

    private static final int POINTS = 32;

    final AlbedoTable rare;
    final AlbedoTable dense;

    /** t L̄ n², the same from both sides. */
    final double through;

    /**
     * Makes the losses of an interface.
     *
     * @param index of the dense side over that of the rare side, at least 1
     */
    LostAtInterface(Microfacets facets, double index) {
        rare = new AlbedoTable(new VisibleNormals.OfInterface(facets, 1 / index));
        dense = new AlbedoTable(new VisibleNormals.OfInterface(facets, index));
        double back = meanReflectance(1 / index) * (1 - LESS_AT_ROUGHEST * facets.alpha);
        through = (1 - back) * rare.meanLoss;
    }

    /** The diffuse reflectance of a smooth interface. */
    private static double meanReflectance(double eta) {
        double sum = 0;
        for (int i = 0; i < POINTS; i++) {
            double c = GaussLegendre.node(POINTS, i);
            sum += GaussLegendre.weight(POINTS, i) * 2 * c * DielectricFresnel.reflectance(c, eta);
        }
        return sum;
    }
}
