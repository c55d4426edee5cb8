package enlightenment.bsdf;

/**
 * Rough matte surfaces such as plaster or clay: the energy-preserving form of Oren and Nayar's model (J. Portsmouth, P. Kutz and S. Hill,
 * "EON: a practical energy-preserving rough diffuse BRDF", JCGT 2025). A white one reflects all light, from every direction and at every
 * roughness; with roughness 0 it is {@link Lambert}. Reciprocal, the same on both sides.
 *
 * <p>The cosine alone is a poor density: towards the origin of grazing light the value grows like 1/max(μo, μi). So a share of the samples
 * is uniform over the hemisphere.
 */
public final class RoughDiffuse implements Bsdf {
    private static final double C1 = 0.5 - 2 / (3 * Math.PI);
    private static final double C2 = 2 / 3.0 - 28 / (15 * Math.PI);
    private static final double TWO_THIRDS = 2 / 3.0;

    private final double r;
    private final double scale;
    private final double mean;
    private final double multiple;

    /**
     * Makes a surface of one roughness.
     *
     * @param roughness 0 (Lambert) to 1
     */
    public RoughDiffuse(double roughness) {
        if (!(roughness >= 0 && roughness <= 1)) {
            throw new IllegalArgumentException("roughness " + roughness);
        }
        r = roughness;
        scale = 1 / (1 + C1 * r) / Math.PI;
        mean = (1 + C2 * r) / (1 + C1 * r);
        // (1 − E(μo))(1 − E(μi))/(1 − Ē) with 1 − E = rA(c1 − G/π) and 1 − Ē = rA(c1 − c2): r needs no division.
        multiple = r * scale / (C1 - C2);
    }

    @Override
    public boolean isDelta() {
        return false;
    }

    @Override
    public FlatBsdf flatForm() {
        return new FlatBsdf(FlatBsdf.Kind.ROUGH_MATTE, r, scale, mean, multiple, C1);
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
        s.pdf = density(in, out);
        double cosine = s.ox * s.ix + s.oy * s.iy + s.oz * s.iz - in * out;
        // i's cosine is in the product first: 1/max(μo, μi) alone could overflow.
        double retro = cosine > 0 ? cosine * (in / Math.max(in, out)) : cosine * in;
        double single = scale * Math.max(Math.fma(r, retro, in), 0);
        double more = multiple * lost(out) * lost(in) * in;
        s.value(value(s.red, single, more), value(s.green, single, more), value(s.blue, single, more));
    }

    @Override
    public void evaluate(ScatteringBatch b, int from, int to) {
        b.findCosines(from, to);
        lost(b.in, b.valueR, from, to);
        lost(b.out, b.valueG, from, to);
        for (int n = from; n < to; n++) {
            double in = b.in[n];
            double out = b.out[n];
            double cosine = b.ox[n] * b.ix[n] + b.oy[n] * b.iy[n] + b.oz[n] * b.iz[n] - in * out;
            double retro = Math.fma(Math.max(cosine, 0), in / Math.max(in, out), Math.min(cosine, 0) * in);
            b.single[n] = scale * Math.max(Math.fma(r, retro, in), 0);
            b.facet[n] = multiple * b.valueG[n] * b.valueR[n] * in;
        }
        for (int n = from; n < to; n++) {
            b.pdf[n] = density(b.in[n], b.out[n]);
        }
        values(b.red, b.single, b.facet, b.valueR, from, to);
        values(b.green, b.single, b.facet, b.valueG, from, to);
        values(b.blue, b.single, b.facet, b.valueB, from, to);
        b.clearBelow(from, to);
    }

    private static void lost(double[] cosines, double[] out, int from, int to) {
        for (int n = from; n < to; n++) {
            out[n] = lost(Math.max(cosines[n], 0));
        }
    }

    private void values(double[] color, double[] single, double[] more, double[] out, int from, int to) {
        for (int n = from; n < to; n++) {
            out[n] = value(color[n], single[n], more[n]);
        }
    }

    private double value(double color, double single, double more) {
        return color * Math.fma(color * mean / (1 - color * (1 - mean)), more, single);
    }

    /** c1 − G(μ)/π: the loss of single scattering, over rA. */
    private static double lost(double cosine) {
        double c = Math.min(cosine, 1);
        double m = Math.sqrt(1 - c);
        double s = m * Math.sqrt(1 + c);
        double g = s * (m * arc(c) - s * c + TWO_THIRDS * (c * (1 + s + s * s) / (1 + s) - 1));
        return Math.max(C1 - g / Math.PI, 0);
    }

    /** acos(x)/sqrt(1 − x) for 0 ≤ x ≤ 1 to 2.2e-8: Abramowitz and Stegun 4.4.46. */
    private static double arc(double x) {
        double p = Math.fma(x, -0.0012624911, 0.0066700901);
        p = Math.fma(x, p, -0.0170881256);
        p = Math.fma(x, p, 0.0308918810);
        p = Math.fma(x, p, -0.0501743046);
        p = Math.fma(x, p, 0.0889789874);
        p = Math.fma(x, p, -0.2145988016);
        return Math.fma(x, p, 1.5707963050);
    }

    @Override
    public double pdf(Scattering s) {
        double in = s.cosineIn();
        return in > 0 ? density(in, s.cosineOutClamped()) : 0;
    }

    private double density(double in, double out) {
        double even = even(out);
        return Math.fma(even, 0.5 - in, in) / Math.PI;
    }

    /** The probability of sampling uniformly over the hemisphere. */
    private double even(double out) {
        return 0.5 * r * (1 - out) * (1 - out);
    }

    @Override
    public boolean sample(Scattering s, double u, double v, double choice) {
        if (choice < even(s.cosineOutClamped())) {
            s.sampleHemisphere(u, v);
        } else {
            s.sampleCosine(u, v);
        }
        s.transmitted = false;
        evaluate(s);
        return s.weigh();
    }
}
