package enlightenment.bsdf;

/**
 * Many points at which light is scattered, for {@link Bsdf#evaluate(ScatteringBatch, int, int)}. A structure of arrays, for loops that the
 * compiler vectorizes. A mutable work object, one per thread.
 */
public final class ScatteringBatch {
    /** The directions o, towards previous vertices: unit vectors. */
    public final double[] ox;

    public final double[] oy;
    public final double[] oz;

    /** The shading normals on the side of o. */
    public final double[] nx;

    public final double[] ny;
    public final double[] nz;

    /** The directions i, towards next vertices: unit vectors. */
    public final double[] ix;

    public final double[] iy;
    public final double[] iz;

    /** The surfaces' colours, by band. */
    public final double[] red;

    public final double[] green;
    public final double[] blue;

    /** The values f·|cosθ|, by band. */
    public final double[] valueR;

    public final double[] valueG;
    public final double[] valueB;

    /** The densities per solid angle of the directions i. */
    public final double[] pdf;

    /** Cosines of i and of o with the normal; and of o with the microfacet. */
    final double[] in;

    final double[] out;
    final double[] facet;

    /** The value of single reflection at white microfacets. */
    final double[] single;

    private final Scattering one = new Scattering();

    /** Makes room for this number of points. */
    public ScatteringBatch(int size) {
        ox = new double[size];
        oy = new double[size];
        oz = new double[size];
        nx = new double[size];
        ny = new double[size];
        nz = new double[size];
        ix = new double[size];
        iy = new double[size];
        iz = new double[size];
        red = new double[size];
        green = new double[size];
        blue = new double[size];
        valueR = new double[size];
        valueG = new double[size];
        valueB = new double[size];
        pdf = new double[size];
        in = new double[size];
        out = new double[size];
        facet = new double[size];
        single = new double[size];
    }

    /** Sets surface and direction o of a point. */
    public void set(int n, Scattering s) {
        ox[n] = s.ox;
        oy[n] = s.oy;
        oz[n] = s.oz;
        nx[n] = s.nx;
        ny[n] = s.ny;
        nz[n] = s.nz;
        red[n] = s.red;
        green[n] = s.green;
        blue[n] = s.blue;
    }

    /** A single point, in an object that the next call reuses. */
    Scattering get(int n) {
        get(n, one);
        return one;
    }

    /** Copies a point, without results. */
    void get(int n, Scattering s) {
        s.ox = ox[n];
        s.oy = oy[n];
        s.oz = oz[n];
        s.nx = nx[n];
        s.ny = ny[n];
        s.nz = nz[n];
        s.ix = ix[n];
        s.iy = iy[n];
        s.iz = iz[n];
        s.red = red[n];
        s.green = green[n];
        s.blue = blue[n];
    }

    /** Colour and value of a single point, in an object that the next call reuses. */
    Scattering found(int n) {
        one.red = red[n];
        one.green = green[n];
        one.blue = blue[n];
        one.value(valueR[n], valueG[n], valueB[n]);
        one.pdf = pdf[n];
        return one;
    }

    /** Stores value and density of a point. */
    void find(int n, Scattering s) {
        valueR[n] = s.valueR;
        valueG[n] = s.valueG;
        valueB[n] = s.valueB;
        pdf[n] = s.pdf;
    }

    /** Sets value and density to 0 where i is below the surface. */
    void clearBelow(int from, int to) {
        for (int n = from; n < to; n++) {
            if (!(in[n] > 0)) {
                valueR[n] = 0;
                valueG[n] = 0;
                valueB[n] = 0;
                pdf[n] = 0;
            }
        }
    }

    /** Computes the cosines with the normal; in two loops, since the compiler does not vectorize long ones. */
    void findCosines(int from, int to) {
        for (int n = from; n < to; n++) {
            in[n] = ix[n] * nx[n] + iy[n] * ny[n] + iz[n] * nz[n];
        }
        for (int n = from; n < to; n++) {
            out[n] = Math.min(Math.max(ox[n] * nx[n] + oy[n] * ny[n] + oz[n] * nz[n], 0), 1);
        }
    }
}
