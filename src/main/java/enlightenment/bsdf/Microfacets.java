package enlightenment.bsdf;

/**
 * The isotropic microfacet distribution of Trowbridge and Reitz (GGX) with height-correlated Smith masking-shadowing (B. Walter et al.,
 * "Microfacet models for refraction through rough surfaces", 2007, equations 33 and 34; E. Heitz, "Understanding the masking-shadowing
 * function in microfacet-based BRDFs", JCGT 2014, equation 99). α is the square of a material's {@code roughness}. All
 * forms are free of cancellation and of divisions by small cosines, down to the smallest α and to grazing directions.
 */
public final class Microfacets {
    /** The least α of a rough surface: below it a lobe is narrower than doubles can resolve directions. */
    private static final double LEAST = 1e-4;

    /**
     * A roughness of 0.25. Fitted: there paths from small lights and paths from the eye make caustics with the same variance
     * (docs/notes/caustics.md).
     */
    private static final double NARROW = 0.0625;

    final double alpha;
    private final double alpha2;
    private final double rest;

    Microfacets(double alpha) {
        if (!(alpha >= LEAST && alpha <= 1)) {
            throw new IllegalArgumentException("roughness " + alpha);
        }
        this.alpha = alpha;
        alpha2 = alpha * alpha;
        rest = (1 - alpha) * (1 + alpha);
    }

    /** Whether a surface of GGX roughness α (at least 0) is to be treated as smooth, with delta lobes: α below 1e-4. */
    public static boolean isSmooth(double alpha) {
        return !(alpha >= LEAST);
    }

    /** For code on another device. */
    double[] numbers() {
        return new double[] {alpha, alpha2, rest};
    }

    /** Whether the lobe is narrow compared to most lamps ({@link Bsdf#isNarrow}). */
    boolean isNarrow() {
        return alpha < NARROW;
    }

    /** sqrt(α² + (1 − α²)μ²), which is (1 + 2Λ)μ: of Smith's Λ without a division by μ. */
    double reach(double cosine) {
        return Math.sqrt(Math.fma(rest * cosine, cosine, alpha2));
    }

    /**
     * G2/(μo μi), height-correlated, times μi/2: with it a value is F·D·(this)/2, and it is finite for all μi &gt; 0.
     *
     * @param in |μi|, positive
     * @param out |μo|, not negative
     */
    double masking(double in, double out) {
        return 1 / Math.fma(out / in, reach(in), reach(out));
    }

    /** G1(o)/(2μo): the density of o's visible normals is D·(o·m)·2(this). */
    double visible(double out) {
        return 1 / (out + reach(out));
    }

    /** The share of G1(o) that shadowing leaves: G2/G1, the weight of a visible normal. */
    double shadowing(double in, double out) {
        return (out + reach(out)) * masking(in, out);
    }

    /** 1 − {@link #shadowing}, without cancellation. */
    double shadowed(double in, double out) {
        double reach = reach(in);
        return out * (alpha2 * (1 - in) * (1 + in) / (reach + in)) / Math.fma(out, reach, in * reach(out));
    }

    /**
     * Sets the density D of microfacets whose normal goes along the vector h, of any length, and their cosine with o; D is 0 below the
     * surface.
     */
    void at(Scattering s, double hx, double hy, double hz) {
        double z = hx * s.nx + hy * s.ny + hz * s.nz;
        double px = s.ny * hz - s.nz * hy;
        double py = s.nz * hx - s.nx * hz;
        double pz = s.nx * hy - s.ny * hx;
        double z2 = z * z;
        double p2 = px * px + py * py + pz * pz;
        double length2 = z2 + p2;
        double narrow = Math.fma(alpha2, z2, p2);
        if (!(z > 0 && narrow > 0)) {
            s.facets = 0;
            s.cosineFacet = 0;
            return;
        }
        double ratio = alpha * (length2 / narrow);
        s.facets = ratio * ratio / Math.PI;
        s.cosineFacet = Math.min(Math.max((hx * s.ox + hy * s.oy + hz * s.oz) / Math.sqrt(length2), 0), 1);
    }

    /**
     * Computes D, cosines and white single reflection, as {@link #at}, {@link #visible} and {@link #masking}, for points from..to − 1 of a
     * batch: densities of i by visible normals, values of white microfacets, and the cosines with these. Valid only where i is above the
     * surface.
     */
    void evaluate(ScatteringBatch b, int from, int to) {
        for (int n = from; n < to; n++) {
            double hx = b.ox[n] + b.ix[n];
            double hy = b.oy[n] + b.iy[n];
            double hz = b.oz[n] + b.iz[n];
            double z = hx * b.nx[n] + hy * b.ny[n] + hz * b.nz[n];
            double px = b.ny[n] * hz - b.nz[n] * hy;
            double py = b.nz[n] * hx - b.nx[n] * hz;
            double pz = b.nx[n] * hy - b.ny[n] * hx;
            double z2 = z * z;
            double p2 = px * px + py * py + pz * pz;
            double length2 = z2 + p2;
            double ratio = alpha * (length2 / Math.fma(alpha2, z2, p2));
            b.single[n] = ratio * ratio * (0.5 / Math.PI);
            // Half of the sum of two unit vectors has the length of its cosine with each of them.
            b.facet[n] = Math.min(0.5 * Math.sqrt(length2), 1);
        }
        for (int n = from; n < to; n++) {
            double in = Math.max(b.in[n], 0);
            double out = b.out[n];
            double half = b.single[n];
            double reachOut = reach(out);
            b.pdf[n] = half / (out + reachOut);
            b.single[n] = half * in / Math.fma(out, reach(in), in * reachOut);
        }
    }

    /**
     * Samples a normal visible from o, uniformly on a spherical cap (J. Dupuy and A. Benyoub, "Sampling visible GGX normals with spherical
     * caps", 2023), and stores it in i. The cap's heights come from the disk without cancellation.
     *
     * @return false if there is none
     */
    boolean sampleVisible(Scattering s, double u, double v) {
        s.toDisk(u, v);
        s.turn();
        double x = alpha * s.localOx();
        double y = alpha * s.localOy();
        double z = Math.max(s.cosineOut(), 0);
        double scale = 1 / Math.sqrt(x * x + y * y + z * z);
        double k = Math.fma(z, scale, 1);
        double q = Math.sqrt(Math.max(k * (2 - s.disk2 * k), 0));
        double hx = alpha * Math.fma(s.diskX, q, x * scale);
        double hy = alpha * Math.fma(s.diskY, q, y * scale);
        double hz = k * Math.max(1 - s.disk2, 0);
        if (!(hx * hx + hy * hy + hz * hz > 0)) {
            return false;
        }
        s.directLocal(hx, hy, hz);
        return true;
    }
}
