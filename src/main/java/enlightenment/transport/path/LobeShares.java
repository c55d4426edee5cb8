package enlightenment.transport.path;

import enlightenment.bsdf.Bsdf;
import enlightenment.bsdf.Scattering;
import enlightenment.bsdf.ScatteringBatch;
import enlightenment.primitive.Hit;
import enlightenment.transport.bidirectional.LightDivision;
import enlightenment.transport.state.IncidentLight;
import java.util.Arrays;

/**
 * Path reuse at rough vertices, whose reflection depends on direction (at matte ones it does not). First vertices are in the order of
 * {@link PathConnections}. One per thread.
 */
final class LobeShares implements LightDivision {
    /** By first vertex, its BSDF and scattering geometry if it is rough; null if it is matte. */
    private Bsdf[] lobes = {};

    private ScatteringBatch at;

    /** Whether any first vertex is rough. */
    private boolean hasRough;

    /** By first vertex, BSDF times cosine over density, for radiance from the current second vertex; of a matte one its colour. */
    private double[] red;

    private double[] green;
    private double[] blue;

    /** By first vertex, the radiance that other paths have added. */
    private double[] gainedR;

    private double[] gainedG;
    private double[] gainedB;

    /** The scattering at a rough second vertex, a column for each first vertex that it reflects light to. */
    private ScatteringBatch from;

    /** Of that vertex, its BSDF, the shares of first vertices, and their sum. */
    private Bsdf second;

    private double[] sharesOfSecond;
    private double sumOfShares;

    private int count;

    /** The number of BSDF evaluations since {@link #begin}. */
    private int evaluations;

    /** The number of divisions of light since {@link #begin}, and the sum over them of the squared shares. */
    private int divisions;

    private double squares;

    LobeShares() {
        makeRoom(0);
    }

    void makeRoom(int size) {
        lobes = new Bsdf[size];
        at = new ScatteringBatch(size);
        red = new double[size];
        green = new double[size];
        blue = new double[size];
        gainedR = new double[size];
        gainedG = new double[size];
        gainedB = new double[size];
        from = new ScatteringBatch(size);
    }

    /** Begins a group with this number of first vertices. */
    void begin(int size) {
        hasRough = false;
        count = size;
        evaluations = 0;
        divisions = 0;
        squares = 0;
        Arrays.fill(gainedR, 0, size, 0);
        Arrays.fill(gainedG, 0, size, 0);
        Arrays.fill(gainedB, 0, size, 0);
    }

    /** Sets first vertex n. */
    void set(int n, PathCut path) {
        lobes[n] = path.firstLobes;
        if (path.firstLobes == null) {
            red[n] = path.albedo[0];
            green[n] = path.albedo[1];
            blue[n] = path.albedo[2];
        } else {
            hasRough = true;
            at.set(n, path.atFirst);
        }
    }

    /** Whether any first vertex is rough. */
    boolean hasRough() {
        return hasRough;
    }

    /**
     * Finds the densities, times π, with which rough first vertices would have sampled the direction to the second one.
     *
     * @param shares receives them; already holds those of matte ones
     */
    void find(Hit second, double[] x, double[] y, double[] z, double[] shares) {
        for (int n = 0, end; n < count; n = end) {
            end = n + 1;
            while (end < count && lobes[end] == lobes[n]) {
                end++;
            }
            if (lobes[n] != null) {
                find(second, x, y, z, n, end, shares);
            }
        }
    }

    private void find(Hit second, double[] x, double[] y, double[] z, int begin, int end, double[] shares) {
        aim(at.ix, at.iy, at.iz, second, -1, x, y, z, begin, end);
        lobes[begin].evaluate(at, begin, end);
        evaluations += end - begin;
        double px = second.px;
        double py = second.py;
        double pz = second.pz;
        double mx = second.nx * second.side;
        double my = second.ny * second.side;
        double mz = second.nz * second.side;
        for (int n = begin; n < end; n++) {
            double dx = px - x[n];
            double dy = py - y[n];
            double dz = pz - z[n];
            double dd = Math.max(dx * dx + dy * dy + dz * dz, Double.MIN_NORMAL);
            double arriving = Math.max(-(at.ix[n] * mx + at.iy[n] * my + at.iz[n] * mz), 0);
            shares[n] = Math.PI * at.pdf[n] * arriving / dd;
            double scale = 1 / Math.max(at.pdf[n], Double.MIN_NORMAL);
            red[n] = at.valueR[n] * scale;
            green[n] = at.valueG[n] * scale;
            blue[n] = at.valueB[n] * scale;
        }
    }

    /** Sets unit vectors from a point to others, or the opposite. */
    private static void aim(
            double[] toX,
            double[] toY,
            double[] toZ,
            Hit from,
            double sign,
            double[] x,
            double[] y,
            double[] z,
            int begin,
            int end) {
        double px = from.px;
        double py = from.py;
        double pz = from.pz;
        for (int n = begin; n < end; n++) {
            double dx = x[n] - px;
            double dy = y[n] - py;
            double dz = z[n] - pz;
            // Coincident points would divide by 0; no light goes from one to the other.
            double scale = sign / Math.sqrt(Math.max(dx * dx + dy * dy + dz * dz, Double.MIN_NORMAL));
            toX[n] = dx * scale;
            toY[n] = dy * scale;
            toZ[n] = dz * scale;
        }
    }

    /** Divides the radiance that leaves a matte second vertex, given as its ratio to the sum of the shares. */
    void giveMatte(double[] shares, double sum, double r, double g, double b) {
        double square = 0;
        for (int n = 0; n < count; n++) {
            square = Math.fma(shares[n], shares[n], square);
        }
        note(square, sum);
        for (int n = 0; n < count; n++) {
            gainedR[n] = Math.fma(red[n] * shares[n], r, gainedR[n]);
            gainedG[n] = Math.fma(green[n] * shares[n], g, gainedG[n]);
            gainedB[n] = Math.fma(blue[n] * shares[n], b, gainedB[n]);
        }
    }

    /**
     * Sets the rough vertex whose light is divided next.
     *
     * @param at the surface there, with colour and normal
     */
    void begin(Hit vertex, Scattering at, Bsdf bsdf, double[] x, double[] y, double[] z, double[] shares, double sum) {
        aim(from.ox, from.oy, from.oz, vertex, 1, x, y, z, 0, count);
        fill(from.nx, from.ny, from.nz, at.nx, at.ny, at.nz);
        fill(from.red, from.green, from.blue, at.red, at.green, at.blue);
        second = bsdf;
        sharesOfSecond = shares;
        sumOfShares = sum;
    }

    @Override
    public double aim(double ix, double iy, double iz) {
        turn(ix, iy, iz);
        double density = 0;
        for (int n = 0; n < count; n++) {
            density += sharesOfSecond[n] * from.pdf[n];
        }
        return density / sumOfShares;
    }

    @Override
    public void divide(double r, double g, double b) {
        divide(sumOfShares, r, g, b);
    }

    private void divide(double sum, double r, double g, double b) {
        double scale = 1 / sum;
        for (int n = 0; n < count; n++) {
            double share = sharesOfSecond[n] * scale;
            gainedR[n] = Math.fma(red[n] * share, from.valueR[n] * r, gainedR[n]);
            gainedG[n] = Math.fma(green[n] * share, from.valueG[n] * g, gainedG[n]);
            gainedB[n] = Math.fma(blue[n] * share, from.valueB[n] * b, gainedB[n]);
        }
    }

    /** Divides the light that the rough second vertex reflects, of a path that has gone on alone. */
    void giveRough(PathCut giver) {
        IncidentLight lamp = giver.lamp;
        if (lamp.density > 0) {
            turn(lamp.dx, lamp.dy, lamp.dz);
            give(lamp.density, lamp.hasExtent ? 1 : 0, lamp.red, lamp.green, lamp.blue);
        }
        if (giver.wentOn) {
            turn(giver.onX, giver.onY, giver.onZ);
            give(0, 1, giver.given[0], giver.given[1], giver.given[2]);
            if (giver.metDensity > 0) {
                give(giver.metDensity, 1, giver.met[0], giver.met[1], giver.met[2]);
            }
        }
    }

    /** Evaluates the BSDF of the rough second vertex for light from a direction. */
    private void turn(double ix, double iy, double iz) {
        fill(from.ix, from.iy, from.iz, ix, iy, iz);
        second.evaluate(from, 0, count);
        evaluations += count;
    }

    private void fill(double[] a, double[] b, double[] c, double x, double y, double z) {
        Arrays.fill(a, 0, count, x);
        Arrays.fill(b, 0, count, y);
        Arrays.fill(c, 0, count, z);
    }

    /** Divides incident radiance over the sum of all densities with which all paths would have sampled it: the light's and the lobe's. */
    private void give(double ofLight, double byLobe, double r, double g, double b) {
        if (!(r > 0 || g > 0 || b > 0)) {
            return;
        }
        double sum = 0;
        double square = 0;
        for (int n = 0; n < count; n++) {
            double density = sharesOfSecond[n] * Math.fma(byLobe, from.pdf[n], ofLight);
            sum += density;
            square = Math.fma(density, density, square);
        }
        if (!(sum >= Double.MIN_NORMAL)) {
            return;
        }
        note(square, sum);
        divide(sum, r, g, b);
    }

    private void note(double square, double sum) {
        divisions++;
        squares += square / sum / sum;
    }

    /** The number of divisions of light by rough surfaces. */
    int divisions() {
        return divisions;
    }

    /** The sum over these divisions of the squared shares. */
    double squares() {
        return squares;
    }

    /** The number of BSDF evaluations at rough surfaces, for all second vertices. */
    int evaluations() {
        return evaluations;
    }

    /** Adds the radiance that first vertices have gained to their paths. */
    void finish(int[] pathOf, double[][] out) {
        for (int n = 0; n < count; n++) {
            double[] rgb = out[pathOf[n]];
            rgb[0] += gainedR[n];
            rgb[1] += gainedG[n];
            rgb[2] += gainedB[n];
        }
    }

    /** Writes the radiance of a path by its own second vertex, without reuse; 0 if the path was not cut. */
    static void alone(PathCut path, double[] out) {
        out[0] = 0;
        out[1] = 0;
        out[2] = 0;
        if (!path.gives) {
            return;
        }
        leaving(path, out);
        if (path.firstLobes == null) {
            scale(out, path.albedo[0], path.albedo[1], path.albedo[2], 1);
            return;
        }
        Scattering s = path.atFirst;
        s.direct(path.second.px - path.first.px, path.second.py - path.first.py, path.second.pz - path.first.pz);
        path.firstLobes.evaluate(s);
        scale(out, s.valueR, s.valueG, s.valueB, s.pdf > 0 ? 1 / s.pdf : 0);
    }

    private static void scale(double[] rgb, double r, double g, double b, double by) {
        rgb[0] *= r * by;
        rgb[1] *= g * by;
        rgb[2] *= b * by;
    }

    private static void leaving(PathCut path, double[] out) {
        if (path.secondLobes == null) {
            System.arraycopy(path.given, 0, out, 0, 3);
            return;
        }
        Scattering s = path.atSecond;
        s.arriveFrom(path.first.px - path.second.px, path.first.py - path.second.py, path.first.pz - path.second.pz);
        IncidentLight lamp = path.lamp;
        if (lamp.density > 0) {
            s.ix = lamp.dx;
            s.iy = lamp.dy;
            s.iz = lamp.dz;
            path.secondLobes.evaluate(s);
            addReflected(s, lamp.red, lamp.green, lamp.blue, lamp.density + (lamp.hasExtent ? s.pdf : 0), out);
        }
        if (path.wentOn) {
            s.ix = path.onX;
            s.iy = path.onY;
            s.iz = path.onZ;
            path.secondLobes.evaluate(s);
            addReflected(s, path.given[0], path.given[1], path.given[2], s.pdf, out);
            if (path.metDensity > 0) {
                addReflected(s, path.met[0], path.met[1], path.met[2], path.metDensity + s.pdf, out);
            }
        }
    }

    private static void addReflected(Scattering s, double r, double g, double b, double density, double[] out) {
        if (density > 0) {
            out[0] += s.valueR * r / density;
            out[1] += s.valueG * g / density;
            out[2] += s.valueB * b / density;
        }
    }
}
