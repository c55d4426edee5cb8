package enlightenment.bsdf;

import enlightenment.color.Rgb;

/**
 * The Fresnel reflectance of an opaque glossy surface or one of its microfacets, 0..1 by colour component: by Schlick's formula from the
 * surface's colour, or by Fresnel's equations of a metal times that colour.
 */
public final class Fresnel {
    /** Metals with a larger index reflect all light, up to rounding, and their fourth powers could overflow. */
    private static final double LARGEST = 0x1p100;

    /**
     * The surface's colour F₀ at normal incidence, white at grazing incidence: F₀ + (1 − F₀)(1 − c)⁵ (C. Schlick, "An inexpensive BRDF
     * model for physically-based rendering", 1994).
     */
    public static final Fresnel SCHLICK = new Fresnel(null, null);

    /** The number of points of Gauss-Legendre quadrature for the mean over directions. */
    private static final int POINTS = 16;

    private final Rgb eta;
    private final Rgb k;
    private final double meanR;
    private final double meanG;
    private final double meanB;

    private Fresnel(Rgb eta, Rgb k) {
        this.eta = eta;
        this.k = k;
        meanR = eta == null ? 0 : mean(eta.r(), k.r());
        meanG = eta == null ? 0 : mean(eta.g(), k.g());
        meanB = eta == null ? 0 : mean(eta.b(), k.b());
    }

    /**
     * The unpolarised Fresnel reflectance of a metal of the complex index of refraction η + ik, relative to the medium of incidence
     * (as in {@code Conductor}), multiplied by the surface's colour (M. Born and E. Wolf, "Principles of Optics", 1999,
     * section 14.2).
     *
     * @param eta the real part, by band, greater than 0
     * @param k the imaginary part (extinction coefficient), by band, at least 0
     * @throws IllegalArgumentException for numbers out of range
     */
    public static Fresnel conductor(Rgb eta, Rgb k) {
        if (!(Math.min(Math.min(eta.r(), eta.g()), eta.b()) > 0)) {
            throw new IllegalArgumentException("refractive index " + eta);
        }
        if (!(Math.min(Math.min(k.r(), k.g()), k.b()) >= 0)) {
            throw new IllegalArgumentException("extinction " + k);
        }
        return new Fresnel(bounded(eta), bounded(k));
    }

    private static Rgb bounded(Rgb index) {
        return new Rgb(Math.min(index.r(), LARGEST), Math.min(index.g(), LARGEST), Math.min(index.b(), LARGEST));
    }

    /** For code on another device: 1 if it is Schlick's, η and k by band, mean reflectances by band. */
    double[] numbers() {
        Rgb n = eta == null ? Rgb.BLACK : eta;
        Rgb e = eta == null ? Rgb.BLACK : k;
        return new double[] {eta == null ? 1 : 0, n.r(), n.g(), n.b(), e.r(), e.g(), e.b(), meanR, meanG, meanB};
    }

    /** Whether a surface of black colour still reflects: by Schlick's approximation, at grazing angles. */
    boolean reflectsIfBlack() {
        return eta == null;
    }

    /** Sets the value to the reflectance at the cosine of incidence c, 0..1. */
    void at(double c, Scattering s) {
        if (eta == null) {
            double w = towardsWhite(c);
            s.value(Math.fma(1 - s.red, w, s.red), Math.fma(1 - s.green, w, s.green), Math.fma(1 - s.blue, w, s.blue));
        } else {
            s.value(
                    s.red * conductor(c, eta.r(), k.r()),
                    s.green * conductor(c, eta.g(), k.g()),
                    s.blue * conductor(c, eta.b(), k.b()));
        }
    }

    /** Sets the values of points from..to − 1 of a batch to the reflectance at the cosines with their microfacets. */
    void at(ScatteringBatch b, int from, int to) {
        if (eta == null) {
            schlick(b.facet, b.red, b.valueR, from, to);
            schlick(b.facet, b.green, b.valueG, from, to);
            schlick(b.facet, b.blue, b.valueB, from, to);
        } else {
            conductor(b.facet, eta.r(), k.r(), b.red, b.valueR, from, to);
            conductor(b.facet, eta.g(), k.g(), b.green, b.valueG, from, to);
            conductor(b.facet, eta.b(), k.b(), b.blue, b.valueB, from, to);
        }
    }

    private static void schlick(double[] c, double[] color, double[] out, int from, int to) {
        for (int n = from; n < to; n++) {
            out[n] = Math.fma(1 - color[n], towardsWhite(c[n]), color[n]);
        }
    }

    /** (1 − c)⁵. */
    private static double towardsWhite(double c) {
        double m = Math.max(1 - c, 0);
        double m2 = m * m;
        return m2 * m2 * m;
    }

    private static void conductor(double[] c, double eta, double k, double[] color, double[] out, int from, int to) {
        if (!(k >= eta && eta * k > 0)) {
            for (int n = from; n < to; n++) {
                out[n] = color[n] * conductor(c[n], eta, k);
            }
            return;
        }
        // A true metal: of a and b the latter is always the greater one, and a = ηk/b.
        double twice = 2 * eta * k;
        for (int n = from; n < to; n++) {
            double c2 = c[n] * c[n];
            double s2 = Math.max((1 - c[n]) * (1 + c[n]), 0);
            double t = s2 - (eta - k) * (eta + k);
            double sum = Math.sqrt(Math.fma(t, t, twice * twice));
            double ac = twice * Math.sqrt(2 / (sum + t)) * c[n];
            double perpendicular = (sum + c2 - ac) / (sum + c2 + ac);
            double whole = Math.fma(c2, sum, s2 * s2);
            out[n] = 0.5 * color[n] * perpendicular * (1 + (whole - ac * s2) / (whole + ac * s2));
        }
    }

    /** The mean reflectance 2∫F c dc over cosine-weighted directions, of the red component. */
    double meanR(Scattering s) {
        return eta == null ? schlickMean(s.red) : s.red * meanR;
    }

    /** The mean reflectance 2∫F c dc over cosine-weighted directions, of the green component. */
    double meanG(Scattering s) {
        return eta == null ? schlickMean(s.green) : s.green * meanG;
    }

    /** The mean reflectance 2∫F c dc over cosine-weighted directions, of the blue component. */
    double meanB(Scattering s) {
        return eta == null ? schlickMean(s.blue) : s.blue * meanB;
    }

    /** Schlick's mean reflectance: 2∫(1 − c)⁵ c dc is 1/21. */
    private static double schlickMean(double color) {
        return color + (1 - color) / 21;
    }

    /** The reflectance of a metal for unpolarised light at the cosine of incidence c. */
    static double conductor(double c, double eta, double k) {
        double c2 = c * c;
        double s2 = Math.max((1 - c) * (1 + c), 0);
        double twice = 2 * eta * k;
        // a + ib is the root of (η + ik)² − sin²θ; of a² and b² the greater comes from a sum, the other one from their
        // product.
        double t = (eta - k) * (eta + k) - s2;
        double sum = Math.sqrt(Math.fma(t, t, twice * twice));
        double a2 = t >= 0 ? 0.5 * (sum + t) : 0.5 * twice * twice / (sum - t);
        double ac = 2 * Math.sqrt(a2) * c;
        double perpendicular = share(sum + c2, ac);
        double parallel = perpendicular * share(Math.fma(c2, sum, s2 * s2), ac * s2);
        return 0.5 * (perpendicular + parallel);
    }

    private static double share(double sum, double difference) {
        return sum > 0 ? Math.max(sum - difference, 0) / (sum + difference) : 1;
    }

    private static double mean(double eta, double k) {
        double total = 0;
        for (int i = 0; i < POINTS; i++) {
            double x = GaussLegendre.node(POINTS, i);
            total += GaussLegendre.weight(POINTS, i) * 2 * x * conductor(x, eta, k);
        }
        return Math.min(total, 1);
    }
}
