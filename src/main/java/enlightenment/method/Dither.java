package enlightenment.method;

/**
 * A threshold for each pixel, evenly spread over 0..1 in every neighbourhood: for choosing a share of the pixels without
 * clumps. The lattice of M. Roberts, "The unreasonable effectiveness of quasirandom sequences", 2018: multiples of 1/g and
 * 1/g², where g is the root of g³ = g + 1, the plane's analogue of the golden section.
 */
public final class Dither {
    private static final double PLASTIC = 1.32471795724474602596;
    private static final double STEP_X = 1 / PLASTIC;
    private static final double STEP_Y = STEP_X / PLASTIC;

    private Dither() {}

    /** The threshold of a pixel, in [0, 1). */
    public static double at(int x, int y) {
        double t = x * STEP_X + y * STEP_Y;
        return t - Math.floor(t);
    }
}
