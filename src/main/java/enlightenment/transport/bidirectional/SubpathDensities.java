package enlightenment.transport.bidirectional;

/**
 * The densities of a subpath, from the eye or from a light, that MIS weights need: with which the other strategies would have sampled the
 * same vertices, relative to this subpath. Two numbers suffice, updated from vertex to vertex (D. van Antwerpen, "Recursive MIS computation
 * for streaming BDPT on the GPU", 2011; I. Georgiev, "Implementing vertex connection and merging", 2012, equations 31 to 36 without
 * merging). They are sums of squares, by the power heuristic with exponent 2 (E. Veach and L. Guibas, 1995). docs/notes/bidirectional.md
 * has the formulas.
 *
 * <p>Areas and squared distances, of which these numbers are squares, are in the scene's
 * {@link enlightenment.world.PhysicalScene#areaUnit}. Weights do not depend on it, but visible objects may be tiny beside the whole scene.
 */
public final class SubpathDensities {
    /** The square of this is a normal number; cosines of grazing directions, as rounded, are no smaller. */
    private static final double LEAST_COSINE = 0x1p-500;

    /** Georgiev's d<sub>VCM</sub>: the strategy in which the last edge is a connection. */
    double edge;

    /** Georgiev's d<sub>VC</sub>: all strategies that sample the last edge from the other side. */
    double beyond;

    public static double square(double x) {
        return x * x;
    }

    static double cosine(double x) {
        return Math.max(Math.abs(x), LEAST_COSINE);
    }

    void begin(double newEdge, double newBeyond) {
        edge = newEdge;
        beyond = newBeyond;
    }

    /**
     * Updates for arriving at a vertex.
     *
     * @param distance2 the squared distance from the previous vertex, in units of area
     * @param cosine between the normal there and the direction that the path came from
     */
    void arrive(double distance2, double cosine) {
        double projected = square(cosine(cosine));
        edge *= square(distance2) / projected;
        beyond /= projected;
    }

    /**
     * Updates for leaving the vertex.
     *
     * @param cosine between the normal and the sampled direction
     * @param forward the density per solid angle of this direction
     * @param reverse the density per solid angle of the reverse direction
     */
    void leave(double cosine, double forward, double reverse) {
        beyond = square(cosine(cosine) / forward) * behind(reverse);
        edge = square(1 / forward);
    }

    /**
     * Updates for a delta event, which no connection can sample. Its probability is the same in both directions, but refraction changes the
     * solid angle: solid angle times cosine times the squared index of refraction is invariant. Cosines of such vertices cancel, so they
     * are not {@linkplain #arrive arrived} at.
     *
     * @param expansion the squared index of refraction where the path came from over that where it goes
     */
    void pass(double expansion) {
        edge = 0;
        beyond *= square(expansion);
    }

    /** The sum over all other strategies for the edge before this vertex, and those before that, relative to this subpath. */
    public double behind(double reverse) {
        return Math.fma(beyond, square(reverse), edge);
    }

    /** The weight of a strategy, from the sums of squared densities of the others over its own; 0 where rounding leaves no number. */
    public static double weight(double light, double eye) {
        double weight = 1 / (1 + light + eye);
        return weight >= 0 ? weight : 0;
    }
}
