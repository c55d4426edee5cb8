package enlightenment.classic.cluster;

import enlightenment.film.FilmTile;
import enlightenment.method.Block;

/**
 * How many samples each pixel of a block needs, as the survey shows it: the expected variance of a single sample, once from
 * where in the pixel it lies, once from which light point it takes.
 *
 * <p>An edge (corners whose rays met different things) makes a sample vary as much as the corners do; without one, what the
 * interpolation between the corners misses is a share of their second differences. Only the shares' ratios matter. They were
 * chosen for the least error at equal cost on shipped scenes (docs/notes/cluster-laboratory.md); the result changes by a few per cent if
 * they are doubled or halved.
 */
final class SampleDemand {
    private static final double OF_EDGE = 2;
    private static final double OF_CURVATURE = 0.1;
    private static final double OF_TWIST = 0.3;

    /** What every pixel gets of its block's curvature: what the corners miss here they may have seen there. */
    private static final double OF_BLOCK = 0.003;

    /**
     * The least of the corners' variance at an edge: between surfaces that are alike at the corners there may be others. It costs
     * nothing that could be measured; without it a lit face between dark ones, narrower than a pixel, was never found.
     */
    private static final double LEAST_AT_EDGE = 0x1p-13;

    /** What a pixel may hide between its corners, unless nothing is there; what its neighbours hide tells more ({@link Evidence}). */
    private static final double UNSEEN = 0x1p-27;

    /** A second difference of three corners of variance v each has the variance (1 + 4 + 1) v. */
    private static final double NOISE_OF_SECOND_DIFFERENCE = 6;

    private final double[] second = new double[(FilmTile.BLOCK_SIDE + 1) * (FilmTile.BLOCK_SIDE + 1)];

    /** Per pixel of the block, row by row of 8. */
    final double[] film = new double[FilmTile.BLOCK_SIDE * FilmTile.BLOCK_SIDE];

    /** By pixel as {@link #film}: variance from an edge through the pixel, also from one that no corner shows. */
    final double[] edge = new double[FilmTile.BLOCK_SIDE * FilmTile.BLOCK_SIDE];

    final double[] light = new double[FilmTile.BLOCK_SIDE * FilmTile.BLOCK_SIDE];

    /** Whether no pixel has variance from its light points. */
    boolean lightIsSettled;

    /** One that stays as this one is now. */
    SampleDemand copy() {
        SampleDemand copy = new SampleDemand();
        System.arraycopy(film, 0, copy.film, 0, film.length);
        System.arraycopy(edge, 0, copy.edge, 0, edge.length);
        System.arraycopy(light, 0, copy.light, 0, light.length);
        copy.lightIsSettled = lightIsSettled;
        return copy;
    }

    /** Works out the needs of a block from its survey. */
    void of(Survey survey, Block block) {
        double mean = secondDifferences(survey, block);
        lightIsSettled = !survey.hasDoubtfulLight();
        for (int j = 0; j < block.height(); j++) {
            for (int i = 0; i < block.width(); i++) {
                int k = FilmTile.BLOCK_SIDE * j + i;
                film[k] = OF_BLOCK * mean;
                edge[k] = survey.isEmpty() ? 0 : UNSEEN;
                addCorners(survey, i, j, k);
                light[k] = lightIsSettled ? 0 : survey.lightVariance(i, j);
            }
        }
    }

    /** Takes into account that proposals divide the variance from light points by {@code gain}. */
    void guided(double gain) {
        for (int k = 0; k < light.length; k++) {
            light[k] /= gain;
        }
    }

    /** The share of a pixel's expected variance that is due to its light points, if each sample takes this many. */
    double ofLight(int pixel, int points) {
        double ofPoints = light[pixel] / points;
        double all = film[pixel] + edge[pixel] + ofPoints;
        return all > 0 ? ofPoints / all : 0;
    }

    private void addCorners(Survey survey, int i, int j, int pixel) {
        int k = survey.node(i, j);
        int below = k + survey.side;
        if (survey.commonKey(i, j) == Survey.DIFFERENT) {
            edge[pixel] = OF_EDGE * Math.max(cornerVariance(survey.rgb, 3 * k, 3 * below), LEAST_AT_EDGE);
        } else {
            double curvature = (second[k] + second[k + 1] + second[below] + second[below + 1]) / 4;
            film[pixel] += OF_CURVATURE * curvature + OF_TWIST * twist(survey.rgb, 3 * k, 3 * below);
        }
    }

    private static double cornerVariance(double[] rgb, int k, int below) {
        double sum = 0;
        for (int c = 0; c < 3; c++) {
            double p = rgb[k + c];
            double q = rgb[k + 3 + c];
            double r = rgb[below + c];
            double s = rgb[below + 3 + c];
            double mean = (p + q + r + s) / 4;
            sum += (p - mean) * (p - mean)
                    + (q - mean) * (q - mean)
                    + (r - mean) * (r - mean)
                    + (s - mean) * (s - mean);
        }
        return sum / 12;
    }

    /** How far the four corners are from a plane. */
    private static double twist(double[] rgb, int k, int below) {
        double sum = 0;
        for (int c = 0; c < 3; c++) {
            double d = rgb[k + c] - rgb[k + 3 + c] - rgb[below + c] + rgb[below + 3 + c];
            sum += d * d;
        }
        return sum / 3;
    }

    /** Squared second differences at each corner, in both directions; returns their mean over the corners. */
    private double secondDifferences(Survey survey, Block block) {
        int columns = block.width() + 1;
        int rows = block.height() + 1;
        double sum = 0;
        for (int j = 0; j < rows; j++) {
            for (int i = 0; i < columns; i++) {
                int k = survey.node(i, j);
                double s = 0;
                if (columns >= 3) {
                    int inner = Math.min(Math.max(i, 1), columns - 2);
                    s += squared(survey, survey.node(inner, j), 1);
                }
                if (rows >= 3) {
                    int inner = Math.min(Math.max(j, 1), rows - 2);
                    s += squared(survey, survey.node(i, inner), survey.side);
                }
                second[k] = s;
                sum += s;
            }
        }
        return sum / (columns * rows);
    }

    private static double squared(Survey survey, int node, int step) {
        double[] rgb = survey.rgb;
        double sum = 0;
        for (int c = 0; c < 3; c++) {
            int k = 3 * node + c;
            double d = rgb[k - 3 * step] - 2 * rgb[k] + rgb[k + 3 * step];
            sum += d * d;
        }
        return Math.max(sum / 3 - NOISE_OF_SECOND_DIFFERENCE * survey.lightNoise(node), 0);
    }
}
