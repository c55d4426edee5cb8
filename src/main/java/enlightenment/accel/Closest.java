package enlightenment.accel;

import enlightenment.geometry.Hit;
import enlightenment.geometry.Primitive;
import enlightenment.geometry.Ray;

/**
 * The closest crossing that a search has found so far. The one place that says which of two crossings is closer, so that
 * a loop over all primitives and a hierarchy find the same one, whatever the order in which they offer them.
 *
 * <p>The smaller t is closer. At the same t, bit for bit, a crossing that leaves a solid comes before one that enters,
 * because what is left ends before what is entered begins; then the lower id comes first.
 *
 * <p>A mutable work object, one per thread: it also holds the scratch memory of {@link Bvh#closest}.
 */
public final class Closest {
    private static final int NOTHING = -1;

    private double t = Double.MAX_VALUE;
    private int id = NOTHING;
    private Primitive primitive;
    private final Hit scratch = new Hit();

    final SlabTest slabs = new SlabTest();

    /** Nodes that {@link Bvh#closest} has put off, and where the ray comes into them. */
    final int[] stack = new int[Bvh.MAX_DEPTH];

    final double[] stackEntry = new double[Bvh.MAX_DEPTH];

    /** A search that has found nothing yet and accepts any distance. */
    public Closest() {}

    /** Forgets what was found; from now on crossings with t &le; limit count. */
    public void reset(double limit) {
        t = limit;
        id = NOTHING;
        primitive = null;
    }

    /** Takes the nearest crossing of ray and primitive if it is closer than what was found so far. */
    public void offer(Ray ray, Primitive candidate, int candidateId) {
        double s = candidate.nearest(ray, t);
        if (s < t || (s == t && winsTie(ray, candidate, candidateId))) {
            t = s;
            id = candidateId;
            primitive = candidate;
        }
    }

    private boolean winsTie(Ray ray, Primitive candidate, int candidateId) {
        if (primitive == null) {
            return true;
        }
        int incumbentSide = sideOf(ray, primitive);
        int side = sideOf(ray, candidate);
        return side == incumbentSide ? candidateId < id : side == Ray.INSIDE;
    }

    private int sideOf(Ray ray, Primitive p) {
        p.complete(ray, t, scratch);
        return scratch.side;
    }

    /** The ray parameter of the closest crossing, or the limit if nothing was found. */
    public double t() {
        return t;
    }

    /** The id of the primitive that is crossed there, or -1 if nothing was found. */
    public int id() {
        return id;
    }
}
