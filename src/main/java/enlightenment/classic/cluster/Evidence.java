package enlightenment.classic.cluster;

import enlightenment.film.FilmTile;
import enlightenment.method.Block;

/**
 * What the first samples of a block's pixels met that its corners had not shown: evidence that other pixels hide as much. A
 * pixel's demand is raised by the samples of the others only, so that its own stay unbiased.
 *
 * <p>Pixels whose corners met the same and pixels whose corners did not are judged apart: beside the outline of a large thing the
 * former hide nothing, between wires thinner than a pixel they hide as much as the latter. The shares were chosen for the least
 * error at equal cost (docs/notes/cluster-laboratory.md).
 */
final class Evidence {
    /** How much more a touching pixel tells than one that is further away. */
    private static final double NEAR = 8;

    /**
     * What a pixel needs of the variance that others hide, where its corners agree. {@link SampleDemand} counts an edge about six times
     * what it leaves of variance.
     */
    private static final double OF_QUIET = 6;

    /** {@link #OF_QUIET} for pixels whose corners differ; their own corners predict most of them better. */
    private static final double OF_EDGE = 1;

    /** How much a sample counts whose path met just what the corners' did: colours that bend are no edges. */
    private static final double OF_SAME_PATH = 0.3;

    private final double[] surprise = new double[FilmTile.BLOCK_SIDE * FilmTile.BLOCK_SIDE];
    private final boolean[] quiet = new boolean[FilmTile.BLOCK_SIDE * FilmTile.BLOCK_SIDE];

    /** Sums and numbers of the pixels whose corners differ, and of the others. */
    private final double[] sums = new double[2];

    private final int[] pixels = new int[2];

    private boolean withOwn;

    /**
     * Forgets what was told.
     *
     * @param ofOwnToo whether a pixel is to learn from its own samples, too: only where they are no part of the picture
     */
    void begin(boolean ofOwnToo) {
        withOwn = ofOwnToo;
        for (int kind = 0; kind < 2; kind++) {
            sums[kind] = 0;
            pixels[kind] = 0;
        }
    }

    /**
     * What a sample shows that the corners had not: its squared difference from the control variate, less the noise expected.
     *
     * @param color the sample minus what the corners let expect
     * @param samePath whether it met what all the corners of its pixel met
     * @param lightPoints how many points of each light it took
     */
    static double of(double[] color, boolean samePath, SampleDemand needs, int pixel, int lightPoints) {
        double squared = (color[0] * color[0] + color[1] * color[1] + color[2] * color[2]) / 3;
        // Where lights are partly hidden, their noise is expected.
        if (!samePath) {
            return squared - needs.light[pixel] / lightPoints;
        }
        return needs.light[pixel] > 0 ? 0 : OF_SAME_PATH * (squared - needs.film[pixel]);
    }

    /** Takes note of the mean surprise of the first samples of a pixel, and whether its corners met the same. */
    void tell(int pixel, boolean isQuiet, double mean) {
        quiet[pixel] = isQuiet;
        surprise[pixel] = mean;
        sums[kind(pixel)] += mean;
        pixels[kind(pixel)]++;
    }

    private int kind(int pixel) {
        return quiet[pixel] ? 1 : 0;
    }

    /** Lets what the other pixels hide raise the needs of each. */
    void raise(SampleDemand needs, Block block) {
        if (sums[0] <= 0 && sums[1] <= 0) {
            return;
        }
        for (int j = 0; j < block.height(); j++) {
            for (int i = 0; i < block.width(); i++) {
                int k = FilmTile.BLOCK_SIDE * j + i;
                double others = others(block, i, j);
                needs.edge[k] =
                        quiet[k] ? needs.edge[k] + OF_QUIET * others : Math.max(needs.edge[k], OF_EDGE * others);
            }
        }
    }

    /** The mean surprise of the other pixels of the same kind, those that touch this one counted more. */
    private double others(Block block, int i, int j) {
        int k = FilmTile.BLOCK_SIDE * j + i;
        int kind = kind(k);
        double near = 0;
        int count = 0;
        for (int y = Math.max(j - 1, 0); y <= Math.min(j + 1, block.height() - 1); y++) {
            for (int x = Math.max(i - 1, 0); x <= Math.min(i + 1, block.width() - 1); x++) {
                int n = FilmTile.BLOCK_SIDE * y + x;
                if ((n != k || withOwn) && kind(n) == kind) {
                    near += surprise[n];
                    count++;
                }
            }
        }
        double far = sums[kind] - (withOwn ? 0 : surprise[k]) - near;
        double weight = NEAR * count + (pixels[kind] - (withOwn ? 0 : 1) - count);
        return weight == 0 ? 0 : Math.max((NEAR * near + far) / weight, 0);
    }
}
