package enlightenment.transport.bidirectional;

import enlightenment.bsdf.Bsdf;
import enlightenment.bsdf.Scattering;
import enlightenment.primitive.Hit;
import enlightenment.transport.state.Throughput;
import java.util.Arrays;

/**
 * The vertices of a subpath, without surfaces that it passed straight: flat arrays that grow and are reused. Vertices of delta events are
 * included, since they count for path length, but cannot be connected.
 */
public final class PathVertices {
    private static final int X = 0;
    private static final int NORMAL = 3;
    private static final int FROM = 6;
    private static final int COLOR = 9;
    private static final int POWER = 12;
    private static final int ETA = 15;
    private static final int EDGE = 16;
    private static final int BEYOND = 17;
    private static final int SURVIVAL = 18;
    private static final int ULTRAVIOLET = 19;
    private static final int MEDIUM = 20;
    private static final int SURFACE = 21;
    private static final int NUMBERS = 24;

    private static final int ID = 0;
    private static final int FACE = 1;
    private static final int BOUNCES = 2;
    private static final int COLORED = 3;
    private static final int INTS = 4;

    private int size;
    private double[] numbers = new double[16 * NUMBERS];
    private int[] ints = new int[16 * INTS];
    private Bsdf[] bsdfs = new Bsdf[16];

    void clear() {
        size = 0;
    }

    public int size() {
        return size;
    }

    /**
     * Adds a vertex with delta events only.
     *
     * @param expansion see {@link SubpathDensities#pass}
     */
    void addDelta(Hit hit, double expansion) {
        grow();
        bsdfs[size] = null;
        int k = size * NUMBERS;
        set(k + X, hit.px, hit.py, hit.pz);
        numbers[k + ETA] = expansion;
        size++;
    }

    /**
     * Adds a vertex that may be connected.
     *
     * @param s its normal, the direction that the path came from and, at an interface, the colours of transmitted light
     * @param bounces the number of events before
     * @param survival the probability of Russian roulette that the path goes on from here
     */
    void add(
            Hit hit,
            int id,
            Bsdf bsdf,
            Scattering s,
            double[] color,
            int bounces,
            SubpathDensities densities,
            double survival) {
        grow();
        bsdfs[size] = bsdf;
        int k = size * NUMBERS;
        set(k + X, hit.px, hit.py, hit.pz);
        set(k + NORMAL, s.nx, s.ny, s.nz);
        set(k + SURFACE, s.gx, s.gy, s.gz);
        set(k + FROM, s.ox, s.oy, s.oz);
        set(k + COLOR, color[0], color[1], color[2]);
        numbers[k + ETA] = s.eta;
        numbers[k + EDGE] = densities.edge;
        numbers[k + BEYOND] = densities.beyond;
        numbers[k + SURVIVAL] = survival;
        int i = size * INTS;
        ints[i + ID] = id;
        ints[i + FACE] = hit.face;
        ints[i + BOUNCES] = bounces;
        size++;
    }

    /** Bars the last vertex from being connected. */
    void bar() {
        bsdfs[size - 1] = null;
    }

    /** Sets the incident power at the last vertex. */
    void power(Throughput power) {
        int k = (size - 1) * NUMBERS;
        set(k + POWER, power.red, power.green, power.blue);
        numbers[k + ULTRAVIOLET] = power.ultraviolet;
    }

    /** Sets {@link MediumVertex#density} of the last vertex; 0 if it is on a surface. */
    void medium(double density) {
        numbers[(size - 1) * NUMBERS + MEDIUM] = density;
    }

    /** {@link Subpath#projected} of vertex k, which may be connected. */
    double projected(int k, double cosine) {
        double density = numbers[k * NUMBERS + MEDIUM];
        return density > 0 ? density : Math.abs(cosine);
    }

    /** Sets whether light of the last vertex has the colour of the path's wavelength. */
    void colored(boolean isColored) {
        ints[(size - 1) * INTS + COLORED] = isColored ? 1 : 0;
    }

    /** Whether light of vertex k has the colour of the path's wavelength, if that has one. */
    boolean isColored(int k) {
        return ints[k * INTS + COLORED] != 0;
    }

    private void set(int k, double a, double b, double c) {
        numbers[k] = a;
        numbers[k + 1] = b;
        numbers[k + 2] = c;
    }

    private void grow() {
        if (size == bsdfs.length) {
            numbers = Arrays.copyOf(numbers, 2 * numbers.length);
            ints = Arrays.copyOf(ints, 2 * ints.length);
            bsdfs = Arrays.copyOf(bsdfs, 2 * size);
        }
    }

    /** The BSDF or phase function of vertex k; null if it cannot be connected. */
    Bsdf bsdf(int k) {
        return bsdfs[k];
    }

    /** Sets a scattering, but for the direction i, from vertex k of a light subpath. */
    void get(int k, Scattering s) {
        int n = k * NUMBERS;
        s.nx = numbers[n + NORMAL];
        s.ny = numbers[n + NORMAL + 1];
        s.nz = numbers[n + NORMAL + 2];
        s.gx = numbers[n + SURFACE];
        s.gy = numbers[n + SURFACE + 1];
        s.gz = numbers[n + SURFACE + 2];
        s.fromLight = true;
        s.ox = numbers[n + FROM];
        s.oy = numbers[n + FROM + 1];
        s.oz = numbers[n + FROM + 2];
        s.red = numbers[n + COLOR];
        s.green = numbers[n + COLOR + 1];
        s.blue = numbers[n + COLOR + 2];
        s.eta = numbers[n + ETA];
    }

    /** The relative index of refraction at an interface; of a vertex of delta events its expansion. */
    double eta(int k) {
        return numbers[k * NUMBERS + ETA];
    }

    double x(int k) {
        return numbers[k * NUMBERS + X];
    }

    double y(int k) {
        return numbers[k * NUMBERS + X + 1];
    }

    double z(int k) {
        return numbers[k * NUMBERS + X + 2];
    }

    double red(int k) {
        return numbers[k * NUMBERS + POWER];
    }

    double green(int k) {
        return numbers[k * NUMBERS + POWER + 1];
    }

    double blue(int k) {
        return numbers[k * NUMBERS + POWER + 2];
    }

    double ultraviolet(int k) {
        return numbers[k * NUMBERS + ULTRAVIOLET];
    }

    double survival(int k) {
        return numbers[k * NUMBERS + SURVIVAL];
    }

    /** {@link SubpathDensities#behind} at vertex k. */
    double behind(int k, double reverse) {
        int n = k * NUMBERS;
        return Math.fma(numbers[n + BEYOND], SubpathDensities.square(reverse), numbers[n + EDGE]);
    }

    int id(int k) {
        return ints[k * INTS + ID];
    }

    int face(int k) {
        return ints[k * INTS + FACE];
    }

    /** The number of events before vertex k. */
    int bounces(int k) {
        return ints[k * INTS + BOUNCES];
    }
}
