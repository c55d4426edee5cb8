package enlightenment.bsdf;

/**
 * The sum of lobes that metallic-roughness workflows describe (B. Burley, "Physically based shading at Disney", 2012; Khronos, "glTF 2.0",
 * appendix B): a metal and a matte base under a dielectric coat, mixed by a share, which have their facets in common; over both a clear
 * coat. The dielectric part may have sheen on it ({@link SheenLayer}). Opaque; alike on both sides.
 *
 * <pre>f = c + min(t(μo), t(μi)) ((1 − m) (S + q g) + m (F + M)) + (1 − m) q ρ B(μo) B(μi)/(π B̄),   B = t T</pre>
 *
 * with q the smaller one of q(μo) and q(μi), which the sheen S lets through, the metallic share m, the clear coat's lobe c and transmittance t, the dielectric coat's lobe g and transmittance T, the metal's
 * single reflection F by Schlick's Fresnel term and its lobe M of multiple reflection ({@link GlossyReflection}). The minimum is
 * reciprocal and exact in the mirror direction; what it loses, and no more, is missing of what a white surface reflects.
 *
 * <p>Smooth layers are delta lobes, which share one direction and are sampled as one.
 */
public final class PrincipledReflection implements Bsdf {
    /** Parts of the integral for B̄, uniform in sqrt(μ). */
    private static final int PARTS = 2048;

    private static final int DELTA = 0;
    private static final int CLEAR = 1;
    private static final int FACETS = 2;
    private static final int MULTIPLE = 3;
    private static final int DIFFUSE = 4;
    private static final int SHEEN = 5;

    private final double metallic;
    private final DielectricLayer clear;
    private final DielectricLayer coat;
    private final SheenLayer sheen;

    /** The facets that metal and coat share; null if smooth. */
    private final Microfacets facets;

    /** The energy loss of single reflection at the metal; null if smooth or without metal. */
    private final AlbedoTable table;

    /** (1 − m)/(π B̄). */
    private final double scale;

    /**
     * A surface, whose colour is that of metal and base: makes up to three tables, in some milliseconds each.
     *
     * @param metallic the share m of metal, 0..1
     * @param alpha the roughness α of GGX of metal and coat, 0..1
     * @param index the index of refraction of the coat, at least 1; 1: there is no coat
     * @param clearcoat the share of the surface that the clear coat covers, 0..1
     * @param clearAlpha its α, 0..1
     * @param clearIndex its index of refraction, at least 1
     * @param sheenShare the share s of sheen on what is not metal, 0..1
     * @param sheenTint how much of the surface's colour the sheen has, 0..1
     * @param layers makes the tables, each once
     */
    public PrincipledReflection(
            double metallic,
            double alpha,
            double index,
            double clearcoat,
            double clearAlpha,
            double clearIndex,
            double sheenShare,
            double sheenTint,
            PrincipledLayers layers) {
        this.metallic = metallic;
        sheen = layers.sheen(metallic < 1 ? sheenShare : 0, sheenTint);
        clear = layers.layer(clearcoat, clearAlpha, clearIndex);
        coat = layers.layer(metallic < 1 ? 1 : 0, alpha, index);
        boolean hasFacets = metallic > 0 || !coat.isAbsent();
        facets = !hasFacets || Microfacets.isSmooth(alpha) ? null : new Microfacets(alpha);
        table = facets == null || metallic == 0 ? null : layers.mirrors(facets);
        scale = (1 - metallic) / (Math.PI * meanBelow());
    }

    /** A surface without sheen, whose tables are its own. */
    public PrincipledReflection(
            double metallic, double alpha, double index, double clearcoat, double clearAlpha, double clearIndex) {
        this(metallic, alpha, index, clearcoat, clearAlpha, clearIndex, 0, 0, new PrincipledLayers());
    }

    /** B̄ = 2∫Bμ dμ, by Simpson's rule over x = sqrt(μ). */
    private double meanBelow() {
        double total = 0;
        for (int k = 0; k <= PARTS; k++) {
            double x = (double) k / PARTS;
            int weight = k == 0 || k == PARTS ? 1 : k % 2 == 0 ? 2 : 4;
            total += weight * 4 * below(x * x) * x * x * x;
        }
        return total / (3 * PARTS);
    }

    /** B(μ), the share of light that reaches the matte base. */
    private double below(double cosine) {
        return clear.through(cosine) * coat.through(cosine);
    }

    @Override
    public boolean isDelta() {
        return metallic == 1 && facets == null && clear.facets == null;
    }

    @Override
    public boolean hasDelta() {
        return isMirror() || clear.isSmooth();
    }

    /** Whether metal or coat is a delta lobe. */
    private boolean isMirror() {
        return facets == null && (metallic > 0 || !coat.isAbsent());
    }

    @Override
    public boolean isNarrow() {
        return metallic == 1 && facets != null && facets.isNarrow() && clear.isNarrow();
    }

    @Override
    public boolean reflectsIfBlack() {
        return metallic > 0 || !coat.isAbsent() || !clear.isAbsent() || !sheen.isAbsent();
    }

    @Override
    public boolean transmits() {
        return false;
    }

    /** Sets the probabilities of the lobes, by the albedo of each for light from o. */
    private void choose(Scattering s, double out) {
        double[] p = s.lobes;
        double below = clear.through(out);
        double entering = coat.through(out);
        double dielectric = (1 - metallic) * sheen.through(out);
        double reflected = dielectric * (1 - entering);
        double again = 0;
        if (table != null) {
            double lost = table.loss(out);
            reflected += metallic * (1 - lost) * mean(s, false);
            again = below * metallic * lost * mean(s, true);
        } else if (metallic > 0) {
            Fresnel.SCHLICK.at(out, s);
            reflected += metallic * (s.valueR + s.valueG + s.valueB) / 3;
        }
        reflected *= below;
        double ofClear = 1 - below;
        p[CLEAR] = clear.facets == null ? 0 : ofClear;
        p[FACETS] = facets == null ? 0 : reflected;
        p[MULTIPLE] = again;
        p[DIFFUSE] = dielectric * (s.red + s.green + s.blue) / 3 * below * entering;
        p[SHEEN] = sheen.isAbsent() ? 0 : below * (1 - metallic - dielectric) * sheenColor(s);
        p[DELTA] = (clear.isSmooth() ? ofClear : 0) + (isMirror() ? reflected : 0);
        normalize(p);
    }

    private double sheenColor(Scattering s) {
        return (sheen.color(s, s.red) + sheen.color(s, s.green) + sheen.color(s, s.blue)) / 3;
    }

    /** The mean over the bands of the metal's mean reflectance F̄, or of the share that multiple reflection leaves of it. */
    private double mean(Scattering s, boolean isMultiple) {
        double r = Fresnel.SCHLICK.meanR(s);
        double g = Fresnel.SCHLICK.meanG(s);
        double b = Fresnel.SCHLICK.meanB(s);
        return (isMultiple ? table.multiple(r) + table.multiple(g) + table.multiple(b) : r + g + b) / 3;
    }

    /**
     * Normalizes the probabilities; a delta lobe that reflects less than the others gets more, since only this lobe finds lamps that it
     * reflects.
     */
    private static void normalize(double[] p) {
        double others = p[CLEAR] + p[FACETS] + p[MULTIPLE] + p[DIFFUSE] + p[SHEEN];
        double delta = p[DELTA];
        if (!(delta > 0) && !(others > 0)) {
            return;
        }
        p[DELTA] =
                delta < others ? Math.sqrt(delta) / (Math.sqrt(delta) + Math.sqrt(others)) : delta / (delta + others);
        double factor = others > 0 ? (1 - p[DELTA]) / others : 0;
        for (int k = CLEAR; k <= SHEEN; k++) {
            p[k] *= factor;
        }
    }

    /** The density of i by the visible normals of a lobe; 0 without facets. Sets the microfacet fields of s. */
    private static double visible(Scattering s, Microfacets of, double out) {
        if (of == null) {
            return 0;
        }
        of.at(s, s.ox + s.ix, s.oy + s.iy, s.oz + s.iz);
        return 0.5 * s.facets * of.visible(out);
    }

    /** The density of the broad lobes. */
    private double broad(Scattering s, double in) {
        double lost = table == null ? 0 : s.lobes[MULTIPLE] * table.density(Math.min(in, 1));
        return Math.fma(s.lobes[DIFFUSE], coat.density(in), Math.fma(s.lobes[SHEEN], SheenLayer.DENSITY, lost));
    }

    @Override
    public void evaluate(Scattering s) {
        double in = s.cosineIn();
        if (!(in > 0)) {
            s.nothing();
            return;
        }
        double out = s.cosineOutClamped();
        double clamped = Math.min(in, 1);
        choose(s, out);
        double pdf = Math.fma(s.lobes[CLEAR], visible(s, clear.facets, out), broad(s, in));
        double clearLobe = clear.facets == null
                ? 0
                : 0.5 * s.facets * clear.facets.masking(in, out) * clear.reflectance(s.cosineFacet);
        s.pdf = Math.fma(s.lobes[FACETS], visible(s, facets, out), pdf);
        double passing = Math.min(clear.through(out), clear.through(clamped));
        double uncovered = Math.min(sheen.through(out), sheen.through(clamped));
        double diffuse = uncovered * below(out) * below(clamped) * in * scale;
        double single = facets == null ? 0 : passing * 0.5 * s.facets * facets.masking(in, out);
        double grey = Math.fma(
                single * (1 - metallic) * uncovered, coat.reflectance(facets == null ? 1 : s.cosineFacet), clearLobe);
        double fibres = passing * (1 - metallic) * sheen.lobe(s) * in;
        double red = Math.fma(fibres, sheen.color(s, s.red), grey);
        double green = Math.fma(fibres, sheen.color(s, s.green), grey);
        double blue = Math.fma(fibres, sheen.color(s, s.blue), grey);
        if (table == null) {
            s.value(Math.fma(s.red, diffuse, red), Math.fma(s.green, diffuse, green), Math.fma(s.blue, diffuse, blue));
            return;
        }
        double lost = passing * metallic * table.loss(out) * table.loss(clamped) * in / (Math.PI * table.meanLoss);
        double metal = metallic * single;
        Fresnel.SCHLICK.at(s.cosineFacet, s);
        s.value(
                sum(red, s.red, diffuse, s.valueR, metal, table.multiple(Fresnel.SCHLICK.meanR(s)) * lost),
                sum(green, s.green, diffuse, s.valueG, metal, table.multiple(Fresnel.SCHLICK.meanG(s)) * lost),
                sum(blue, s.blue, diffuse, s.valueB, metal, table.multiple(Fresnel.SCHLICK.meanB(s)) * lost));
    }

    private static double sum(double rest, double color, double diffuse, double fresnel, double metal, double again) {
        return Math.fma(color, diffuse, Math.fma(fresnel, metal, rest + again));
    }

    @Override
    public double pdf(Scattering s) {
        double in = s.cosineIn();
        if (!(in > 0)) {
            return 0;
        }
        double out = s.cosineOutClamped();
        choose(s, out);
        double pdf = Math.fma(s.lobes[CLEAR], visible(s, clear.facets, out), broad(s, in));
        return Math.fma(s.lobes[FACETS], visible(s, facets, out), pdf);
    }

    @Override
    public boolean sample(Scattering s, double u, double v, double choice) {
        double out = s.cosineOutClamped();
        choose(s, out);
        double[] p = s.lobes;
        s.transmitted = false;
        if (choice < p[DELTA]) {
            reflect(s, out);
            return true;
        }
        double left = choice - p[DELTA] - p[CLEAR];
        boolean isClear = left < 0;
        left -= isClear ? 0 : p[FACETS];
        if (left < 0) {
            if (!(isClear ? clear.facets : facets).sampleVisible(s, u, v)) {
                return false;
            }
            s.reflectFrom(s.ix, s.iy, s.iz);
        } else if (!sampleBroad(s, u, v, left)) {
            return false;
        }
        evaluate(s);
        return s.weigh();
    }

    /**
     * Samples a broad lobe.
     *
     * @param left the number that selects the lobe, less the probabilities of the lobes before
     */
    private boolean sampleBroad(Scattering s, double u, double v, double left) {
        double[] p = s.lobes;
        if (left < p[MULTIPLE]) {
            table.sampleDirection(s, u, v);
        } else if (left - p[MULTIPLE] < p[SHEEN]) {
            s.sampleHemisphere(u, v);
        } else if (p[DIFFUSE] > 0) {
            coat.sampleBelow(s, u, v);
        } else {
            return false;
        }
        return true;
    }

    /** Samples the delta lobe. */
    private void reflect(Scattering s, double out) {
        double probability = s.lobes[DELTA];
        double below = clear.through(out);
        double grey = clear.isSmooth() ? 1 - below : 0;
        double metal = 0;
        if (isMirror()) {
            grey += below * (1 - metallic) * sheen.through(out) * (1 - coat.through(out));
            metal = below * metallic;
        }
        Fresnel.SCHLICK.at(out, s);
        s.reflect();
        s.only(probability, false);
        s.value(
                Math.fma(metal, s.valueR, grey) / probability,
                Math.fma(metal, s.valueG, grey) / probability,
                Math.fma(metal, s.valueB, grey) / probability);
    }
}
