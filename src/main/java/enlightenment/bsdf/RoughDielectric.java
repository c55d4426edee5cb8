package enlightenment.bsdf;

/**
 * Frosted glass, a rough interface of two media: {@link Microfacets} that reflect and refract by Fresnel's equations (Walter et al. 2007,
 * equations 20 and 21), sampled by the normals that are visible from o; {@code choice} selects which of the two. Optionally the light that
 * single scattering loses among the microfacets is compensated on both sides by second, broad lobes (C. Kulla and A. Conty, "Revisiting
 * physically based shading at Imageworks", 2017), which are reciprocal: then no light is lost. The surface's colour is not part of the
 * value.
 *
 * <p>Valid from both sides, for {@link Scattering#radiance} and importance: f(o, i) over the squared index on i's side is reciprocal for
 * importance. Where {@link Scattering#eta} is 1 there is no interface and light passes straight, as by a delta lobe.
 */
public final class RoughDielectric implements Bsdf {
    /** The least probability of sampling visible normals. */
    private static final double LEAST_SHARE = 0.1;

    private final Microfacets facets;

    /** The compensation of energy lost by single scattering; null for none. */
    private final LostLight lost;

    /**
     * Makes a rough interface.
     *
     * @param alpha its roughness α of GGX, at most 1 and not {@linkplain Microfacets#isSmooth smooth}
     * @param compensate whether multiple scattering is compensated: makes tables, in some milliseconds, at the first use for two media
     */
    public RoughDielectric(double alpha, boolean compensate) {
        facets = new Microfacets(alpha);
        lost = compensate ? new LostLight(facets) : null;
    }

    @Override
    public boolean isDelta() {
        return false;
    }

    @Override
    public boolean isNarrow() {
        return facets.isNarrow();
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
        boolean isAny = density > 0;
        s.pdf = isAny ? density * facets.visible(out) : 0;
        double value = isAny ? density * facets.masking(Math.abs(in), out) : 0;
        if (lost != null && in != 0 && s.eta != 1) {
            double place = LostLight.place(s.eta);
            double loss = lost.loss(place, s.eta > 1, out);
            double part = part(s, place, in);
            boolean toDense = s.eta > 1 == in > 0;
            double cosine = Math.min(Math.abs(in), 1);
            value += part
                    * loss
                    * lost.loss(place, toDense, cosine)
                    * cosine
                    / (Math.PI * lost.meanLoss(place, toDense));
            s.pdf = mixed(s.pdf, loss, part * lost.density(place, toDense, cosine));
        }
        if (!(s.pdf > 0)) {
            s.nothing();
            return;
        }
        value *= radiance(s, in < 0);
        s.value(value, value, value);
    }

    /** The share of lost light that leaves on the side of i. */
    private double part(Scattering s, double place, double in) {
        double through = lost.through(place, s.eta > 1, s.eta);
        return in > 0 ? 1 - through : through;
    }

    /** The density of the mixture of both kinds of lobes. */
    private static double mixed(double single, double loss, double broad) {
        double share = share(loss);
        return Math.fma(share, single, (1 - share) * broad);
    }

    /** The probability of sampling visible normals, by the loss. */
    private static double share(double loss) {
        return Math.max(1 - loss, LEAST_SHARE);
    }

    private static double radiance(Scattering s, boolean through) {
        return through && s.radiance ? s.eta * s.eta : 1;
    }

    /** The common factor of value and density: D, the Fresnel term, and the Jacobian from normals to directions. */
    private double density(Scattering s, double in) {
        if (in > 0) {
            facets.at(s, s.ox + s.ix, s.oy + s.iy, s.oz + s.iz);
            return 0.5 * s.facets * DielectricFresnel.reflectance(s.cosineFacet, s.eta);
        }
        return in < 0 && s.eta != 1 ? through(s) : 0;
    }

    private double through(Scattering s) {
        // ηo + i is along the normal of the microfacet that refracts o to i: upwards if the denser medium is on o's
        // side.
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
        double in = s.cosineIn();
        double out = s.cosineOutClamped();
        double single = density(s, in) * facets.visible(out);
        if (lost == null || in == 0 || s.eta == 1) {
            return single;
        }
        double place = LostLight.place(s.eta);
        boolean toDense = s.eta > 1 == in > 0;
        double broad = part(s, place, in) * lost.density(place, toDense, Math.min(Math.abs(in), 1));
        return mixed(single, lost.loss(place, s.eta > 1, out), broad);
    }

    @Override
    public boolean sample(Scattering s, double u, double v, double choice) {
        if (s.eta == 1) {
            s.direct(-s.ox, -s.oy, -s.oz);
            s.certain(true);
            s.value(1, 1, 1);
            return true;
        }
        if (lost == null) {
            return sampleSingle(s, u, v, choice) && weighSingle(s);
        }
        double place = LostLight.place(s.eta);
        boolean isDense = s.eta > 1;
        double share = share(lost.loss(place, isDense, s.cosineOutClamped()));
        if (choice >= share) {
            double rest = (choice - share) / (1 - share);
            s.transmitted = rest < lost.through(place, isDense, s.eta);
            sampleLost(s, place, isDense != s.transmitted, u, v);
        } else if (!sampleSingle(s, u, v, choice / share)) {
            return false;
        }
        evaluate(s);
        return s.weigh();
    }

    /** Samples a direction of single scattering, reflected or refracted. */
    private boolean sampleSingle(Scattering s, double u, double v, double choice) {
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
        return through ? in < 0 : in > 0;
    }

    private boolean weighSingle(Scattering s) {
        double in = s.cosineIn();
        double out = s.cosineOutClamped();
        s.pdf = density(s, in) * facets.visible(out);
        double value = facets.shadowing(Math.abs(in), out) * radiance(s, s.transmitted);
        s.value(value, value, value);
        return s.pdf > 0;
    }

    /** Samples a broad lobe, on the selected side, by its table: at small α the loss is concentrated at grazing directions. */
    private void sampleLost(Scattering s, double place, boolean toDense, double u, double v) {
        s.toDisk(u, v);
        double z = lost.sample(place, toDense, Math.min(s.disk2, 1));
        double scale = s.disk2 > 0 ? Math.sqrt((1 - z) * (1 + z) / s.disk2) : 0;
        s.turn();
        s.directLocal(s.diskX * scale, s.diskY * scale, s.transmitted ? -z : z);
    }
}
