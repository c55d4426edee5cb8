package enlightenment.bsdf;

import enlightenment.frame.Basis;

/**
 * A point of a surface at which light is scattered, and what its {@link Bsdf} says. All directions are unit vectors that point away
 * from the surface. A mutable work object, one per thread.
 */
public final class Scattering {
    /** Towards where the path came from. */
    public double ox;

    public double oy;
    public double oz;

    /** The surface's normal on the side of o: no rounded product decides which side that is. */
    public double nx;

    public double ny;
    public double nz;

    /** The surface's colour here. */
    public double red = 1;

    public double green = 1;
    public double blue = 1;

    /** The index of refraction on the side of o over that of the other side; only glass asks. */
    public double eta = 1;

    /**
     * Whether radiance is scattered, along a path from the eye: at a border it changes by eta². Importance, which paths from a light carry,
     * does not, nor do the display colours of classic shading.
     */
    public boolean radiance;

    /** Towards where the path goes on. */
    public double ix;

    public double iy;
    public double iz;

    /** What {@link Bsdf#evaluate} or {@link Bsdf#sample} found, by colour component. */
    public double valueR;

    public double valueG;
    public double valueB;

    /** The density per solid angle of the direction sampled; its probability if it is one of a delta lobe. */
    public double pdf;

    /** Whether the direction sampled is one of a delta lobe. */
    public boolean delta;

    /** Whether it leads to the other side of the surface. */
    public boolean transmitted;

    final Basis basis = new Basis();
    final double[] disk = new double[3];

    /** A point without a direction yet. */
    public Scattering() {}

    /** The cosine between normal and o. */
    double cosineOut() {
        return ox * nx + oy * ny + oz * nz;
    }

    /** The cosine between normal and i. */
    double cosineIn() {
        return ix * nx + iy * ny + iz * nz;
    }

    /** Sets the direction i to that of a vector. */
    void direct(double x, double y, double z) {
        double scale = 1 / Math.sqrt(x * x + y * y + z * z);
        ix = x * scale;
        iy = y * scale;
        iz = z * scale;
    }

    void value(double r, double g, double b) {
        valueR = r;
        valueG = g;
        valueB = b;
    }

    /** Tells that the direction is the only one of a delta lobe, which was certain to be chosen. */
    void certain(boolean through) {
        pdf = 1;
        delta = true;
        transmitted = through;
    }

    /** Sets i to the mirror image of o. */
    void reflect() {
        double twice = 2 * cosineOut();
        direct(twice * nx - ox, twice * ny - oy, twice * nz - oz);
    }

    /**
     * Sets i to where o is refracted to by Snell's law.
     *
     * @return false for total internal reflection, which sets nothing
     */
    boolean refract() {
        double cosIn = Math.min(Math.max(cosineOut(), 0), 1);
        // 1 − η²(1 − c²), written so that it is c² exactly where η is 1.
        double etaCos = eta * cosIn;
        double cos2Out = Math.fma(etaCos, etaCos, (1 - eta) * (1 + eta));
        if (!(cos2Out >= 0)) {
            return false;
        }
        double along = etaCos - Math.sqrt(cos2Out);
        direct(Math.fma(along, nx, -eta * ox), Math.fma(along, ny, -eta * oy), Math.fma(along, nz, -eta * oz));
        return true;
    }
}
