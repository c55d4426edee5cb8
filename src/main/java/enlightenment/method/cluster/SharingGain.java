package enlightenment.method.cluster;

import enlightenment.transport.path.PathConnections;
import enlightenment.transport.path.PathCut;
import java.util.Arrays;

/**
 * Decides whether path reuse pays in a block: where all paths have about the same value, as in a furnace, it only adds variance through
 * the weights; and where lobes are narrow, connections contribute little but cost BSDF evaluations.
 *
 * <p>A path's value with and without reuse has the same expectation, so the difference of the second moments is that of the variances.
 * Black pixels of the chessboard decide for white ones and vice versa, as in {@link PathNoise}, so that no decision depends on the
 * pixel's own samples.
 */
final class SharingGain {
    /**
     * The cost of a BSDF evaluation at a rough surface, relative to that of a scattering event of a path: measured in rooms with metals and
     * with rough walls, 1/45 to 1/22 (docs/notes/cluster-sampler.md).
     */
    private static final double COST = 1 / 32.0;

    private static final int FIELDS = 2;

    /** By chessboard colour: the sum over paths of the reduction of the second moment by reuse. */
    private final double[] gain = new double[FIELDS];

    /**
     * By chessboard colour: the number of divisions of light at rough vertices, and the sums of squared shares: 1 where a path kept all.
     */
    private final long[] divisions = new long[FIELDS];

    private final double[] squares = new double[FIELDS];

    /** By chessboard colour: the number of BSDF evaluations at rough surfaces, and of events of paths. */
    private final long[] evaluations = new long[FIELDS];

    private final long[] events = new long[FIELDS];
    private final double[] brought = new double[3];
    private boolean isTrying;

    SharingGain() {}

    /** Begins the trial in a block: paths are recorded, and share. */
    void begin() {
        Arrays.fill(gain, 0);
        Arrays.fill(divisions, 0);
        Arrays.fill(squares, 0);
        Arrays.fill(evaluations, 0);
        Arrays.fill(events, 0);
        isTrying = true;
    }

    /** Ends the trial. */
    void finish() {
        isTrying = false;
    }

    /** Whether paths through the pixels of a chessboard colour should share. */
    boolean isWorthIt(int field) {
        return isTrying || gain[1 - field] >= 0 && pays(1 - field);
    }

    /**
     * Whether variance times time may be less with reuse between rough surfaces. Radiance does not enter: the first few paths may have
     * missed light that is bright and rare.
     */
    private boolean pays(int field) {
        return squares[field] * (events[field] + COST * evaluations[field])
                <= (double) divisions[field] * events[field];
    }

    /**
     * Records what each path would have as its value without reuse; call before sharing.
     *
     * @param paths the first of an array
     */
    void before(int field, PathCut[] paths, double[][] colors, int size) {
        for (int k = 0; isTrying && k < size; k++) {
            paths[k].bringsAlone(brought);
            for (int c = 0; c < 3; c++) {
                double alone = colors[k][c] + brought[c];
                gain[field] += alone * alone;
            }
        }
    }

    /**
     * Records the values of the same paths after sharing.
     *
     * @param eventsOf the number of events of each path
     * @param shared has connected them
     */
    void after(int field, double[][] colors, int[] eventsOf, int size, PathConnections shared) {
        if (!isTrying) {
            return;
        }
        for (int k = 0; k < size; k++) {
            for (int c = 0; c < 3; c++) {
                gain[field] -= colors[k][c] * colors[k][c];
            }
            events[field] += 1 + eventsOf[k];
        }
        evaluations[field] += shared.evaluations();
        divisions[field] += shared.divisions();
        squares[field] += shared.squares();
    }
}
