package enlightenment.bsdf;

/**
 * Frosted glass, a rough border of two media: {@link Microfacets} that reflect and refract by Fresnel's equations (Walter et al. 2007,
 * equations 20 and 21), sampled by the normals that are visible from o; {@code choice} selects which of the two. Light that hits it
 * more than once is lost: docs/bsdfs.md says how much. The surface's colour is no part of the value.
 *
 * <p>From both sides, for {@link Scattering#radiance} and importance: f(o, i) over the squared index on i's side is reciprocal for importance.
 * Where {@link Scattering#eta} is 1 there is no border and light passes straight, as by a delta lobe.
 */
public final class RoughDielectric implements Bsdf {
    private final Microfacets facets;

    /**
     * A rough border.
     *
     * @param alpha its roughness α of GGX, at most 1 and not {@linkplain Microfacets#isSmooth smooth}
     */
    public RoughDielectric(double alpha) {
        facets = new Microfacets(alpha);
    }

    @Override
    public boolean isDelta() {
        return false;
    }

    @Override
    public boolean transmits() {
        return true;
    }

    @Override
    public void evaluate(Scattering s) {
        double in = s.cosineIn();
        double out = s.cosineOutClamped();
        double density = density(s, in);
        if (!(density > 0)) {
            s.nothing();
            return;
        }
        s.pdf = density * facets.visible(out);
        double value = density * facets.masking(Math.abs(in), out) * radiance(s, in < 0);
        s.value(value, value, value);
    }

    private static double radiance(Scattering s, boolean through) {
        return through && s.radiance ? s.eta * s.eta : 1;
    }

    /** What value and density have in common: D, Fresnel's share, and the change of solid angle from normals to directions. */
    private double density(Scattering s, double in) {
        if (in > 0) {
            facets.at(s, s.ox + s.ix, s.oy + s.iy, s.oz + s.iz);
            return 0.5 * s.facets * DielectricFresnel.reflectance(s.cosineFacet, s.eta);
        }
        return in < 0 && s.eta != 1 ? through(s) : 0;
    }

    private double through(Scattering s) {
        // ηo + i goes along the normal of the microfacet that refracts o to i: up if the denser medium is on o's side.
        double sign = s.eta > 1 ? 1 : -1;
        double hx = sign * Math.fma(s.eta, s.ox, s.ix);
        double hy = sign * Math.fma(s.eta, s.oy, s.iy);
        double hz = sign * Math.fma(s.eta, s.oz, s.iz);
        facets.at(s, hx, hy, hz);
        double length2 = hx * hx + hy * hy + hz * hz;
        double there = -(hx * s.ix + hy * s.iy + hz * s.iz) / Math.sqrt(length2);
        if (!(s.facets > 0 && s.cosineFacet > 0 && there > 0)) {
            return 0;
        }
        double share = DielectricFresnel.transmittance(s.cosineFacet, there, s.eta);
        return 2 * share * s.facets * s.cosineFacet * there / length2;
    }

    @Override
    public double pdf(Scattering s) {
        return density(s, s.cosineIn()) * facets.visible(s.cosineOutClamped());
    }

    @Override
    public boolean sample(Scattering s, double u, double v, double choice) {
        if (s.eta == 1) {
            s.direct(-s.ox, -s.oy, -s.oz);
            s.certain(true);
            s.value(1, 1, 1);
            return true;
        }
        if (!facets.sampleVisible(s, u, v)) {
            return false;
        }
        double c = Math.min(Math.max(s.ox * s.ix + s.oy * s.iy + s.oz * s.iz, 0), 1);
        boolean through = choice >= DielectricFresnel.reflectance(c, s.eta);
        if (through) {
            s.refractFrom(s.ix, s.iy, s.iz, c);
        } else {
            s.reflectFrom(s.ix, s.iy, s.iz);
        }
        s.transmitted = through;
        s.delta = false;
        double in = s.cosineIn();
        if (!(through ? in < 0 : in > 0)) {
            return false;
        }
        double out = s.cosineOutClamped();
        s.pdf = density(s, in) * facets.visible(out);
        double value = facets.shadowing(Math.abs(in), out) * radiance(s, through);
        s.value(value, value, value);
        return s.pdf > 0;
    }
}
