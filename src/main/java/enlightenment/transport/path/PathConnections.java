package enlightenment.transport.path;

import enlightenment.bsdf.Lambert;
import enlightenment.primitive.Hit;
import enlightenment.primitive.Ray;
import enlightenment.transport.bidirectional.LightVertices;
import enlightenment.world.Tracer;
import enlightenment.world.light.SegmentEnds;
import java.util.Arrays;

/**
 * Path reuse: connects the first vertices of a group of paths to the second vertices of the others, with the balance heuristic
 * (P. Bekaert, M. Sbert and J. Halton, "Accelerating path tracing by re-using paths", 2002; docs/notes/cluster-sampler.md). One per thread.
 *
 * <p>First vertices are grouped by surface, so that occluder candidates are found once per surface and second vertex. Their coordinates
 * are kept in a structure of arrays, for loops that the compiler vectorizes.
 */
public final class PathConnections {
    /** One in this many light subpaths gives light to all paths of a group: docs/notes/light-vertices.md has what more and fewer bring. */
    private static final int PATHS_OF_LIGHT = 4;

    /** The number of the path that has found a point that none has. */
    private static final int NONE = -1;

    /** First vertices on further surfaces count as on one that has no id. */
    private static final int MOST_SURFACES = 6;

    private final Tracer tracer;
    private final Ray ray = new Ray();

    /** By surface: its id, the end of its first vertices in the arrays, and the first vertices as ends of segments. */
    private final int[] surfaces = new int[MOST_SURFACES];

    private final int[] sizes = new int[MOST_SURFACES];
    private final int[] ends = new int[MOST_SURFACES];
    private final SegmentEnds[] segments = new SegmentEnds[MOST_SURFACES];
    private int surfaceCount;

    /** By path: the index of the surface that its first vertex lies on. */
    private int[] surfaceOf = {};

    /** By first vertex, in the order of surfaces: its path, position, normal towards the side it is seen from, and albedo. */
    private int[] pathOf = {};

    private double[] x;
    private double[] y;
    private double[] z;
    private double[] nx;
    private double[] ny;
    private double[] nz;
    private double[] red;
    private double[] green;
    private double[] blue;
    private int count;

    /** By first vertex: its share of the current second vertex's radiance, and the radiance that it has gained. */
    private double[] shares;

    private double[] gainedR;
    private double[] gainedG;
    private double[] gainedB;

    private final LobeShares lobes = new LobeShares();

    /** Shares light subpaths; null for none. */
    private LightVertexReuse reuse;

    /** The number of light subpaths whose vertices give light to all paths of the group. */
    private int givers;

    private final double[] leaving = new double[3];

    PathConnections(Tracer tracer) {
        this.tracer = tracer;
        Arrays.setAll(segments, k -> new SegmentEnds());
    }

    /** Shares light subpaths, too. */
    void reuse(LightVertexReuse light) {
        reuse = light;
    }

    /**
     * Distributes the radiance that leaves the second vertices of paths among all first vertices that see them, weighted proportionally to
     * the density, per area, with which a path from each first vertex would have generated that second vertex. Unbiased.
     *
     * @param paths the first of an array, as by {@link PathIntegrator}; not all need give or receive
     * @param size how many of them
     * @param out by path: red, green, blue; the radiance that the path receives is added
     */
    public void share(PathCut[] paths, int size, double[][] out) {
        givers = (size + PATHS_OF_LIGHT - 1) / PATHS_OF_LIGHT;
        findSurfaces(paths, size);
        if (surfaceCount == 0) {
            return;
        }
        order(paths, size);
        for (int q = 0; q < size; q++) {
            if (reuse != null && q % PATHS_OF_LIGHT == 0) {
                giveLight(paths[q].light, paths);
            }
            if (paths[q].gives) {
                give(paths[q], q, paths);
            }
        }
        lobes.finish(pathOf, out);
        for (int k = 0; k < count; k++) {
            double[] rgb = out[pathOf[k]];
            rgb[0] += red[k] * gainedR[k];
            rgb[1] += green[k] * gainedG[k];
            rgb[2] += blue[k] * gainedB[k];
        }
    }

    /** The number of BSDF evaluations at rough surfaces in the last {@link #share}. */
    public int evaluations() {
        return lobes.evaluations();
    }

    /** The number of divisions of light by rough surfaces in the last {@link #share}. */
    public int divisions() {
        return lobes.divisions();
    }

    /** The sum over these divisions of the squared shares: 1 where all light went to one path, less where several received a part. */
    public double squares() {
        return lobes.squares();
    }

    private void findSurfaces(PathCut[] paths, int size) {
        if (surfaceOf.length < size) {
            makeRoom(size);
        }
        surfaceCount = 0;
        for (int p = 0; p < size; p++) {
            if (paths[p].takes) {
                Hit at = paths[p].first;
                int k = surface(at, paths[p].firstId);
                segments[k].add(at.px, at.py, at.pz);
                sizes[k]++;
                surfaceOf[p] = k;
            }
        }
        int end = 0;
        for (int k = 0; k < surfaceCount; k++) {
            segments[k].finish();
            ends[k] = end;
            end += sizes[k];
        }
        count = end;
        lobes.begin(count);
    }

    /** The id to leave out of tests of rays that leave the surface; -1 if it has several elements, as rays may hit others of them. */
    private static int left(Hit at, int id) {
        return at.primitive.hasElements() ? -1 : id;
    }

    /** The index of a surface, which is added if it is new. */
    private int surface(Hit at, int id) {
        for (int k = 0; k < surfaceCount; k++) {
            if (surfaces[k] == id) {
                return k;
            }
        }
        if (surfaceCount == MOST_SURFACES) {
            segments[MOST_SURFACES - 1].mix();
            return MOST_SURFACES - 1;
        }
        surfaces[surfaceCount] = id;
        sizes[surfaceCount] = 0;
        segments[surfaceCount].clear(left(at, id));
        return surfaceCount++;
    }

    private void makeRoom(int size) {
        surfaceOf = new int[size];
        pathOf = new int[size];
        x = new double[size];
        y = new double[size];
        z = new double[size];
        nx = new double[size];
        ny = new double[size];
        nz = new double[size];
        red = new double[size];
        green = new double[size];
        blue = new double[size];
        shares = new double[size];
        lobes.makeRoom(size);
        gainedR = new double[size];
        gainedG = new double[size];
        gainedB = new double[size];
    }

    /** Puts first vertices in the order of their surfaces, and moves each surface's end behind them. */
    private void order(PathCut[] paths, int size) {
        for (int p = 0; p < size; p++) {
            if (paths[p].takes) {
                int k = ends[surfaceOf[p]]++;
                Hit at = paths[p].first;
                pathOf[k] = p;
                x[k] = at.px;
                y[k] = at.py;
                z[k] = at.pz;
                nx[k] = at.nx * at.side;
                ny[k] = at.ny * at.side;
                nz[k] = at.nz * at.side;
                red[k] = paths[p].albedo[0];
                green[k] = paths[p].albedo[1];
                blue[k] = paths[p].albedo[2];
                lobes.set(k, paths[p]);
                gainedR[k] = 0;
                gainedG[k] = 0;
                gainedB[k] = 0;
            }
        }
    }

    /** Gives the light of a light subpath's vertices to all first vertices that see them. */
    private void giveLight(LightVertices light, PathCut[] to) {
        for (int v = 0; v < light.size(); v++) {
            if (!light.gives(v)) {
                continue;
            }
            double sum = findSeen(light.hit(v), light.id(v), NONE, to);
            if (!(sum > 0)) {
                continue;
            }
            double density = sum / Math.PI / givers;
            if (light.bsdf(v) != Lambert.INSTANCE) {
                lobes.begin(light.hit(v), light.scattering(v), light.bsdf(v), x, y, z, shares, sum);
                light.divide(v, density, lobes);
                continue;
            }
            light.leave(v, density, leaving);
            double scale = 1 / (Math.PI * givers);
            giveMatte(sum, scale * leaving[0], scale * leaving[1], scale * leaving[2]);
        }
    }

    /**
     * Finds the shares of a point with this id in the first vertices that see it; returns their sum.
     *
     * @param number of the path that has found the point
     */
    private double findSeen(Hit at, int id, int number, PathCut[] to) {
        findShares(at.px, at.py, at.pz, at.nx * at.side, at.ny * at.side, at.nz * at.side);
        if (lobes.hasRough()) {
            lobes.find(at, x, y, z, shares);
        }
        double sum = 0;
        int from = 0;
        for (int k = 0; k < surfaceCount; k++) {
            if (hasShares(from, ends[k])) {
                boolean mayBeHidden = tracer.prepareSegments(at.px, at.py, at.pz, left(at, id), segments[k], sizes[k]);
                for (int n = from; n < ends[k]; n++) {
                    boolean isTested = mayBeHidden && shares[n] > 0 && pathOf[n] != number;
                    if (isTested && isOccluded(n, to[pathOf[n]].first, at)) {
                        shares[n] = 0;
                    }
                    sum += shares[n];
                }
            }
            from = ends[k];
        }
        return sum;
    }

    /** Whether any first vertex of a range has a share, so that there is something to test; a share that is no number becomes none. */
    private boolean hasShares(int from, int end) {
        boolean has = false;
        for (int n = from; n < end; n++) {
            if (shares[n] > 0) {
                has = true;
            } else {
                shares[n] = 0;
            }
        }
        return has;
    }

    private void give(PathCut giver, int number, PathCut[] to) {
        double sum = findSeen(giver.second, giver.secondId, number, to);
        if (!(sum > 0)) {
            return;
        }
        boolean isRough = giver.secondLobes != null;
        if (isRough) {
            lobes.begin(giver.second, giver.atSecond, giver.secondLobes, x, y, z, shares, sum);
        }
        if (giver.isOpenEnded) {
            reuse.finish(giver, sum / Math.PI / givers, lobes);
        }
        if (!isRough) {
            giveMatte(sum, giver.given[0] / sum, giver.given[1] / sum, giver.given[2] / sum);
        } else if (!giver.isOpenEnded) {
            lobes.giveRough(giver);
        }
    }

    /** Divides the radiance that leaves a matte vertex, given as its ratio to the sum of the shares. */
    private void giveMatte(double sum, double r, double g, double b) {
        if (lobes.hasRough()) {
            lobes.giveMatte(shares, sum, r, g, b);
        } else {
            gain(r, g, b);
        }
    }

    /**
     * Sets the densities per area, up to a common factor, with which paths from the first vertices would have found a second one,
     * visibility aside.
     */
    private void findShares(double bx, double by, double bz, double mx, double my, double mz) {
        for (int k = 0; k < count; k++) {
            double dx = x[k] - bx;
            double dy = y[k] - by;
            double dz = z[k] - bz;
            double dd = dx * dx + dy * dy + dz * dz;
            double leaving = Math.max(-(nx[k] * dx + ny[k] * dy + nz[k] * dz), 0);
            double arriving = Math.max(mx * dx + my * dy + mz * dz, 0);
            shares[k] = leaving / dd * (arriving / dd);
        }
    }

    private void gain(double r, double g, double b) {
        for (int k = 0; k < count; k++) {
            gainedR[k] += shares[k] * r;
            gainedG[k] += shares[k] * g;
            gainedB[k] += shares[k] * b;
        }
    }

    private boolean isOccluded(int n, Hit a, Hit b) {
        ray.set(b.px, b.py, b.pz, x[n] - b.px, y[n] - b.py, z[n] - b.pz, 0).from(b, b.side);
        ray.alsoFrom(a, a.side);
        return tracer.occludedSegment(ray);
    }
}
