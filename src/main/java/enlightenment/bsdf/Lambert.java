package enlightenment.bsdf;

/** Matte: f = colour/π on the side of o, the same on both sides of the surface. Sampled in proportion to the cosine. */
public final class Lambert implements Bsdf {
    public static final Lambert INSTANCE = new Lambert();

    private Lambert() {}

    @Override
    public boolean isDelta() {
        return false;
    }

    @Override
    public FlatBsdf flatForm() {
        return new FlatBsdf(FlatBsdf.Kind.MATTE);
    }

    @Override
    public boolean transmits() {
        return false;
    }

    @Override
    public void evaluate(Scattering s) {
        double p = pdf(s);
        s.pdf = p;
        s.value(s.red * p, s.green * p, s.blue * p);
    }

    @Override
    public double pdf(Scattering s) {
        return Math.max(s.cosineIn(), 0) / Math.PI;
    }

    /** Malley's method: uniform in the disk below the hemisphere. */
    @Override
    public boolean sample(Scattering s, double u, double v, double choice) {
        s.sampleCosine(u, v);
        s.pdf = pdf(s);
        s.delta = false;
        s.transmitted = false;
        s.value(s.red, s.green, s.blue);
        return s.pdf > 0;
    }
}
