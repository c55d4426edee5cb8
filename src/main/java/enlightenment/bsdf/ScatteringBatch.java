package enlightenment.bsdf;

/**
 * Many points at which light is scattered: what a {@link Bsdf} says of each, at once. Coordinates lie side by side, for loops that
 * the compiler makes vector instructions of. A mutable work object, one per thread.
 */
public final class ScatteringBatch {
    /** Towards where paths came from: unit vectors. */
    public final double[] ox;

    public final double[] oy;
    public final double[] oz;

    /** The surfaces' normals on the side of o. */
    public final double[] nx;

    public final double[] ny;
    public final double[] nz;

    /** Towards where paths go on: unit vectors. */
    public final double[] ix;

    public final double[] iy;
    public final double[] iz;

    /** The surfaces' colours. */
    public final double[] red;

    public final double[] green;
    public final double[] blue;

    /** What was found, f·|cosθ|. */
    public final double[] valueR;

    public final double[] valueG;
    public final double[] valueB;

    /** The densities per solid angle of the directions i. */
    public final double[] pdf;

    /** Cosines of i and of o with the normal; and of o with that of the microfacet. */
    final double[] in;

    final double[] out;
    final double[] facet;

    /** What a surface of white microfacets reflects. */
    final double[] single;

    private final Scattering one = new Scattering();

    /** Room for so many points. */
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

    /** A point alone, until another is asked for. */
    Scattering get(int n) {
        get(n, one);
        return one;
    }

    /** Writes a point. */
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

    /** The colour of a point alone, and what was found there, until another is asked for. */
    Scattering found(int n) {
        one.red = red[n];
        one.green = green[n];
        one.blue = blue[n];
        one.value(valueR[n], valueG[n], valueB[n]);
        one.pdf = pdf[n];
        return one;
    }

    /** Sets what was found at a point. */
    void find(int n, Scattering s) {
        valueR[n] = s.valueR;
        valueG[n] = s.valueG;
        valueB[n] = s.valueB;
        pdf[n] = s.pdf;
    }

    /** Makes it nothing where i is below the surface. */
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

    /** Finds the cosines with the normal; in two loops, since long ones become no vector instructions. */
    void findCosines(int from, int to) {
        for (int n = from; n < to; n++) {
            in[n] = ix[n] * nx[n] + iy[n] * ny[n] + iz[n] * nz[n];
        }
        for (int n = from; n < to; n++) {
            out[n] = Math.min(Math.max(ox[n] * nx[n] + oy[n] * ny[n] + oz[n] * nz[n], 0), 1);
        }
    }
}
