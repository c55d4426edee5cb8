package enlightenment.bsdf;

import enlightenment.frame.Basis;
import enlightenment.sampling.Warp;

/**
 * A point at which light is scattered, with the results of its {@link Bsdf}. All directions are unit vectors that point away from the
 * surface. A mutable work object, one per thread.
 */
public final class Scattering {
    /** The direction o, towards the path's previous vertex. */
    public double ox;

    public double oy;
    public double oz;

    /** The shading normal on the side of o: no rounded product decides which side that is. */
    public double nx;

    public double ny;
    public double nz;

    /** The geometric normal, on the same side as {@link #nx}; equal to it where there is no other shading normal. */
    public double gx;

    public double gy;
    public double gz;

    /** Whether o leads to a light, along a light path; read where the two normals differ. */
    public boolean fromLight;

    /** The surface's colour at the point, by band. */
    public double red = 1;

    public double green = 1;
    public double blue = 1;

    /** The relative index of refraction η = n_o/n_i: on the side of o over that of the other side; positive, read by dielectrics only. */
    public double eta = 1;

    /**
     * The transport mode: true for radiance, along paths from the eye, which transmission scales by {@link #eta}²; false for importance
     * transport, along paths from a light, and for the display colours of classic shading, which it does not scale (E. Veach, "Robust
     * Monte Carlo methods for light transport simulation", 1997, section 5.2).
     */
    public boolean radiance;

    /** The direction i, towards the path's next vertex. */
    public double ix;

    public double iy;
    public double iz;

    /** By colour component: f·|cosθ| per steradian after {@link Bsdf#evaluate}, f·|cosθ|/{@link #pdf} after {@link Bsdf#sample}. */
    public double valueR;

    public double valueG;
    public double valueB;

    /** The density of the direction i, per solid angle; its discrete probability, 0..1, if it was sampled from a delta lobe. */
    public double pdf;

    /** Whether the sampled direction is that of a delta lobe. */
    public boolean delta;

    /** Whether the sampled direction leads to the other side of the surface. */
    public boolean transmitted;

    private final Basis basis = new Basis();
    private final double[] disk = new double[3];

    /** The point of the unit disk from which the last direction was sampled. */
    double diskX;

    double diskY;

    /** The squared distance of that point from the disk's centre. */
    double disk2;

    /** The cosine between o and the last microfacet's normal, and that normal's density D. */
    double cosineFacet;

    double facets;

    /** The probabilities of the lobes of a {@link PrincipledReflection}, as last set. */
    final double[] lobes = new double[6];

    /** Makes a point without directions. */
    public Scattering() {}

    /** Copies point, colour and direction o of another one. */
    public void arriveAs(Scattering from) {
        ox = from.ox;
        oy = from.oy;
        oz = from.oz;
        nx = from.nx;
        ny = from.ny;
        nz = from.nz;
        gx = from.gx;
        gy = from.gy;
        gz = from.gz;
        fromLight = from.fromLight;
        red = from.red;
        green = from.green;
        blue = from.blue;
        eta = from.eta;
        radiance = from.radiance;
    }

    /** The cosine between the geometric normal and i. */
    public double geometricCosineIn() {
        return ix * gx + iy * gy + iz * gz;
    }

    /** The cosine between the geometric normal and o. */
    public double geometricCosineOut() {
        return ox * gx + oy * gy + oz * gz;
    }

    /** The cosine between the shading normal and o. */
    double cosineOut() {
        return ox * nx + oy * ny + oz * nz;
    }

    /** The cosine between the shading normal and o, clamped to 0..1 against rounding. */
    double cosineOutClamped() {
        return Math.min(Math.max(cosineOut(), 0), 1);
    }

    /** The cosine between the shading normal and i. */
    double cosineIn() {
        return ix * nx + iy * ny + iz * nz;
    }

    /** Sets the direction o to that of a vector of any length. */
    public void arriveFrom(double x, double y, double z) {
        double scale = 1 / Math.sqrt(x * x + y * y + z * z);
        ox = x * scale;
        oy = y * scale;
        oz = z * scale;
    }

    /** Sets the direction i to that of a vector of any length. */
    public void direct(double x, double y, double z) {
        double scale = 1 / Math.sqrt(x * x + y * y + z * z);
        ix = x * scale;
        iy = y * scale;
        iz = z * scale;
    }

    /** Sets the basis around the normal, for {@link #localOx} and {@link #directLocal}. */
    void turn() {
        basis.around(nx, ny, nz);
    }

    /** The x of o in the basis, in which the normal is z. */
    double localOx() {
        return ox * basis.ax + oy * basis.ay + oz * basis.az;
    }

    /** The y of o in the basis. */
    double localOy() {
        return ox * basis.bx + oy * basis.by + oz * basis.bz;
    }

    /** Sets the direction i to that of a vector of the basis. */
    void directLocal(double x, double y, double z) {
        direct(
                Math.fma(x, basis.ax, Math.fma(y, basis.bx, z * nx)),
                Math.fma(x, basis.ay, Math.fma(y, basis.by, z * ny)),
                Math.fma(x, basis.az, Math.fma(y, basis.bz, z * nz)));
    }

    /** Sets the direction i to that of a vector of a basis in which the direction of travel, −o, is z. */
    void directFrom(double x, double y, double z) {
        basis.around(-ox, -oy, -oz);
        direct(
                Math.fma(x, basis.ax, Math.fma(y, basis.bx, -z * ox)),
                Math.fma(x, basis.ay, Math.fma(y, basis.by, -z * oy)),
                Math.fma(x, basis.az, Math.fma(y, basis.bz, -z * oz)));
    }

    /** Maps the unit square to the unit disk, preserving area, and stores the point. */
    void toDisk(double u, double v) {
        Warp.toDisk(u, v, disk);
        diskX = disk[0];
        diskY = disk[1];
        disk2 = disk[2];
    }

    /** Samples i with density proportional to the cosine, by Malley's method: uniform in the disk below the hemisphere. */
    void sampleCosine(double u, double v) {
        toDisk(u, v);
        turn();
        directLocal(diskX, diskY, Math.sqrt(Math.max(1 - disk2, 0)));
    }

    /**
     * Samples i with its density at a Lambertian surface; the vector is of unit length only up to rounding, which rays do not need better.
     * The density may be 0.
     */
    public void sampleMatte(double u, double v) {
        toDisk(u, v);
        turn();
        double z = Math.sqrt(Math.max(1 - disk2, 0));
        ix = Math.fma(diskX, basis.ax, Math.fma(diskY, basis.bx, z * nx));
        iy = Math.fma(diskX, basis.ay, Math.fma(diskY, basis.by, z * ny));
        iz = Math.fma(diskX, basis.az, Math.fma(diskY, basis.bz, z * nz));
        pdf = z / Math.PI;
        delta = false;
        transmitted = false;
    }

    /** Samples i uniformly on the hemisphere: its height is as uniform as the squared radius in a disk. */
    void sampleHemisphere(double u, double v) {
        toDisk(u, v);
        turn();
        double s = Math.sqrt(2 - disk2);
        directLocal(diskX * s, diskY * s, 1 - disk2);
    }

    /** Completes {@link Bsdf#sample} from value and density of the direction i; returns whether the density is positive. */
    boolean weigh() {
        delta = false;
        double p = pdf;
        if (!(p > 0)) {
            return false;
        }
        value(valueR / p, valueG / p, valueB / p);
        return true;
    }

    /** Sets value and density to 0: no sample leads this way. */
    void nothing() {
        value(0, 0, 0);
        pdf = 0;
    }

    void value(double r, double g, double b) {
        valueR = r;
        valueG = g;
        valueB = b;
    }

    /** Completes the sample of a delta lobe that was chosen with certainty. */
    void certain(boolean through) {
        only(1, through);
    }

    /** Completes the sample of a delta lobe that was chosen with a probability. */
    void only(double probability, boolean through) {
        pdf = probability;
        delta = true;
        transmitted = through;
    }

    /** Sets i to the mirror image of o. */
    void reflect() {
        reflectFrom(nx, ny, nz);
    }

    /** Sets i to the mirror image of o at a surface with normal m. */
    void reflectFrom(double mx, double my, double mz) {
        double twice = 2 * (ox * mx + oy * my + oz * mz);
        direct(twice * mx - ox, twice * my - oy, twice * mz - oz);
    }

    /**
     * Sets i to the refracted direction of o by Snell's law.
     *
     * @return false for total internal reflection, which sets nothing
     */
    boolean refract() {
        return refractFrom(nx, ny, nz, cosineOutClamped());
    }

    /** Sets i to the refracted direction at a surface with normal m, whose cosine with o is c, 0..1; see {@link #refract}. */
    boolean refractFrom(double mx, double my, double mz, double c) {
        // 1 − η²(1 − c²), written so that it is c² exactly where η is 1.
        double etaCos = eta * c;
        double cos2Out = Math.fma(etaCos, etaCos, (1 - eta) * (1 + eta));
        if (!(cos2Out >= 0)) {
            return false;
        }
        double along = etaCos - Math.sqrt(cos2Out);
        direct(Math.fma(along, mx, -eta * ox), Math.fma(along, my, -eta * oy), Math.fma(along, mz, -eta * oz));
        return true;
    }
}
