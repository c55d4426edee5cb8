package enlightenment.transport.bidirectional;

/**
 * What the weight of a way to find a path must know of a part of it, from the eye or from a light, that ends at a vertex: how likely the
 * same vertices are to be found in the other ways, relative to how this part found them. All of it fits into two numbers, which change
 * from vertex to vertex (D. van Antwerpen, "Recursive MIS computation for streaming BDPT on the GPU", 2011; I. Georgiev, "Implementing
 * vertex connection and merging", 2012, equations 31 to 36 without merging). They are sums of squares, since weights go by the power
 * heuristic with exponent 2 (E. Veach and L. Guibas, 1995). docs/notes/bidirectional.md has the formulas.
 *
 * <p>Areas and squared distances, of which these numbers are squares, are in the scene's {@link
 * enlightenment.world.PhysicalScene#areaUnit}. Weights do not depend on it, but what is seen may be tiny beside the whole scene.
 */
public final class SubpathDensities {
    /** Its square is a normal number. What rounding makes of a direction along a surface is no smaller. */
    private static final double LEAST_COSINE = 0x1p-500;

    /** Georgiev's d<sub>VCM</sub>: of the way in which the last edge is a connection. */
    double edge;

    /** Georgiev's d<sub>VC</sub>: of all ways that have made the last edge from the other side. */
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
     * The path has come to a vertex.
     *
     * @param distance2 the squared distance from the one before, in units of area
     * @param cosine between the normal there and the direction that it came from
     */
    void arrive(double distance2, double cosine) {
        double projected = square(cosine(cosine));
        edge *= square(distance2) / projected;
        beyond /= projected;
    }

    /**
     * It leaves the vertex.
     *
     * @param cosine between the normal and the direction in which it does
     * @param forward the density per solid angle of this direction
     * @param reverse the density per solid angle of the direction that it came from, if it came from where it goes
     */
    void leave(double cosine, double forward, double reverse) {
        beyond = square(cosine(cosine) / forward) * behind(reverse);
        edge = square(1 / forward);
    }

    /**
     * A delta event, which no connection can make. It is as likely in both directions, but refraction narrows what comes from one side and
     * widens what comes from the other: solid angle times cosine times the squared index of refraction is what does not change. Cosines of
     * such vertices cancel, so they are not {@linkplain #arrive arrived} at.
     *
     * @param expansion the squared index of refraction where the path came from over that where it goes
     */
    void pass(double expansion) {
        edge = 0;
        beyond *= square(expansion);
    }

    /** Of all ways that make the edge before this vertex, and those behind, in another way than this part of the path. */
    public double behind(double reverse) {
        return Math.fma(beyond, square(reverse), edge);
    }

    /** The weight of a way, from the sums of squares of the densities of the others over its own; 0 where doubles cannot tell. */
    public static double weight(double light, double eye) {
        double weight = 1 / (1 + light + eye);
        return weight >= 0 ? weight : 0;
    }
}
