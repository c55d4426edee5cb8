package enlightenment.bsdf;

/**
 * An opaque surface of triangles with vertex normals: another Bsdf about the interpolated shading normal, times a factor that softens the
 * shadow terminator (M. J.-Y. Chiang, Y. K. Li and B. Burley, "Taming the shadow terminator", 2019): −g³ + g² + g with g = min(1, cos(n_g,
 * l) / (cos(n_s, l) · cos(n_g, n_s))), l towards the light. The factor is part of the Bsdf, so that every strategy for a path finds the
 * same light.
 *
 * <p>Light paths are corrected by |ω_i·n_s||ω_o·n_g| / (|ω_i·n_g||ω_o·n_s|), ω_i towards the light and ω_o towards the eye (E. Veach,
 * "Robust Monte Carlo methods for light transport simulation", 1997, section 5.3): {@link Scattering#fromLight} says which it is. No light
 * passes the triangle itself: where a direction is behind it, the value is 0.
 *
 * <p>Where the interpolated normal points away from the eye, its mirror image in the plane across the view is used.
 */
public final class SmoothShading implements Bsdf {
    private final Bsdf inner;

    /**
     * @param inner the scattering function about the shading normal; it transmits nothing
     */
    public SmoothShading(Bsdf inner) {
        this.inner = inner;
    }

    /** The scattering function about the shading normal. */
    public Bsdf inner() {
        return inner;
    }

    @Override
    public boolean isDelta() {
        return inner.isDelta();
    }

    @Override
    public boolean hasDelta() {
        return inner.hasDelta();
    }

    @Override
    public boolean transmits() {
        return false;
    }

    @Override
    public boolean isNarrow() {
        return inner.isNarrow();
    }

    @Override
    public boolean reflectsIfBlack() {
        return inner.reflectsIfBlack();
    }

    @Override
    public void evaluate(Scattering s) {
        double p = pdf(s);
        valueOf(s);
        s.pdf = p;
    }

    /** Sets the value by the shading normal, mirrored where needed; leaves in pdf the density for that normal, which callers replace. */
    private void valueOf(Scattering s) {
        double in = s.geometricCosineIn();
        if (!(in > 0) || !(s.geometricCosineOut() > 0)) {
            s.nothing();
            return;
        }
        double nx = s.nx;
        double ny = s.ny;
        double nz = s.nz;
        if (s.fromLight) {
            turnTo(s, s.ix, s.iy, s.iz);
        } else {
            turnTo(s, s.ox, s.oy, s.oz);
        }
        double cosineIn = s.cosineIn();
        double cosineOut = s.cosineOut();
        if (cosineIn > 0 && cosineOut > 0) {
            inner.evaluate(s);
            scale(s, factor(s, cosineIn, cosineOut));
        } else {
            s.nothing();
        }
        s.nx = nx;
        s.ny = ny;
        s.nz = nz;
    }

    /** The factor of the inner value. */
    private static double factor(Scattering s, double cosineIn, double cosineOut) {
        double in = s.geometricCosineIn();
        double out = s.geometricCosineOut();
        double between = Math.abs(s.nx * s.gx + s.ny * s.gy + s.nz * s.gz);
        double light = s.fromLight ? out / (cosineOut * between) : in / (cosineIn * between);
        double g = Math.min(light, 1);
        double soft = g * Math.fma(g, 1 - g, 1);
        return s.fromLight ? soft * (cosineOut / out) * (in / cosineIn) : soft;
    }

    private static void scale(Scattering s, double f) {
        s.value(s.valueR * f, s.valueG * f, s.valueB * f);
    }

    /** Mirrors the normal in the plane across a direction, that to the eye, if it points away from it. */
    private static void turnTo(Scattering s, double x, double y, double z) {
        double cosine = s.nx * x + s.ny * y + s.nz * z;
        if (cosine < 0) {
            s.nx -= 2 * cosine * x;
            s.ny -= 2 * cosine * y;
            s.nz -= 2 * cosine * z;
        }
    }

    @Override
    public double pdf(Scattering s) {
        if (!(s.geometricCosineIn() > 0) || !(s.geometricCosineOut() > 0)) {
            return 0;
        }
        double nx = s.nx;
        double ny = s.ny;
        double nz = s.nz;
        turnTo(s, s.ox, s.oy, s.oz);
        double p = inner.pdf(s);
        s.nx = nx;
        s.ny = ny;
        s.nz = nz;
        return p;
    }

    @Override
    public boolean sample(Scattering s, double u, double v, double choice) {
        double nx = s.nx;
        double ny = s.ny;
        double nz = s.nz;
        turnTo(s, s.ox, s.oy, s.oz);
        boolean goes = inner.sample(s, u, v, choice)
                && s.geometricCosineIn() > 0
                && s.geometricCosineOut() > 0
                && s.cosineIn() > 0
                && s.cosineOut() > 0;
        if (goes && s.delta) {
            scale(s, factor(s, s.cosineIn(), s.cosineOut()));
        }
        s.nx = nx;
        s.ny = ny;
        s.nz = nz;
        if (!goes) {
            s.nothing();
            return false;
        }
        return s.delta || reweigh(s);
    }

    /** Sets the weight of a sampled direction, from the value with the shading normal for the eye. */
    private boolean reweigh(Scattering s) {
        double p = s.pdf;
        valueOf(s);
        s.pdf = p;
        return s.weigh();
    }
}
