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

    /** Tells of paths that are going to share: what each would bring alone. */
    void before(int field, PathCut[] paths, double[][] colors, int members, int index, int[] count) {
        for (int m = 0; isTrying && m < members; m++) {
            if (index < count[m]) {
                for (int c = 0; c < 3; c++) {
                    double alone = colors[m][c] + (paths[m].gives() ? paths[m].brings(paths[m], 1, c) : 0);
                    gain[field] += alone * alone;
                }
            }
        }
    }

    /** Tells of the same paths, after they have shared. */
    void after(int field, double[][] colors, int members, int index, int[] count) {
        for (int m = 0; isTrying && m < members; m++) {
            if (index < count[m]) {
                for (int c = 0; c < 3; c++) {
                    gain[field] -= colors[m][c] * colors[m][c];
                }
            }
        }
    }
}
