package enlightenment.method.cluster;

import enlightenment.shading.PathCut;

/**
 * Whether it pays that the paths of a block share what they bring: where all bring about the same, as in a furnace, they only become
 * different by it.
 *
 * <p>Of a path's value alone and of what sharing makes of it the mean is the same, so that the difference of the mean squares is that of the
 * variances. What is told of black fields decides about white ones, and the other way round, as in {@link PathNoise}; so what is decided
 * does not depend on what it is decided about.
 */
final class SharingGain {
    private final double[] gain = new double[2];
    private boolean isTrying;

    SharingGain() {}

    /** Starts over: from here on paths tell, and share. */
    void begin() {
        gain[0] = 0;
        gain[1] = 0;
        isTrying = true;
    }

    /** All that is needed was told. */
    void finish() {
        isTrying = false;
    }

    /** Whether paths through the pixels of a field colour are to share. */
    boolean isWorthIt(int field) {
        return isTrying || gain[1 - field] >= 0;
    }

    /** Tells of paths that are going to share, the first of an array: what each would bring alone. */
    void before(int field, PathCut[] paths, double[][] colors, int size) {
        for (int k = 0; isTrying && k < size; k++) {
            for (int c = 0; c < 3; c++) {
                double alone = colors[k][c] + paths[k].bringsAlone(c);
                gain[field] += alone * alone;
            }
        }
    }

    /** Tells of the same paths, after they have shared. */
    void after(int field, double[][] colors, int size) {
        for (int k = 0; isTrying && k < size; k++) {
            for (int c = 0; c < 3; c++) {
                gain[field] -= colors[k][c] * colors[k][c];
            }
        }
    }
}
