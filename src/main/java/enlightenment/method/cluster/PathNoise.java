package enlightenment.method.cluster;

import enlightenment.color.DisplayCurve;
import enlightenment.method.Block;
import java.util.Arrays;

/**
 * The variance of single paths through the pixels of a block, as a display would show it, estimated from first paths of other pixels.
 *
 * <p>The pixels of a block are coloured like a chessboard: estimates for black pixels use paths through white ones alone, and vice versa.
 * So no pixel's own paths influence its number of samples.
 *
 * <p>Paths are clustered by their deterministic part ({@link Corners#keys}): the surface that they hit first, and which lamps are hidden
 * there, fully visible, or neither. The rest of a path's value, without its deterministic part, is a sample of its cluster. Its deviation
 * counts as a display would show it, were it that of the pixel's mean: more in dark pixels than in bright ones, and not at all where all is
 * white.
 */
final class PathNoise {
    private static final int MOST_CLUSTERS = 32;

    /** The index of the cluster that takes all keys beyond the others. */
    private static final int OTHERS = MOST_CLUSTERS - 1;

    /** The weight of a path through an adjacent pixel relative to one farther away. */
    private static final double NEAR = 2;

    /** The number of paths in a cluster that the mean of the whole block is worth. */
    private static final double OF_BLOCK = 8;

    private final DisplayCurve curve;
    private final Corners corners;

    /** Of the largest block, in pixels. */
    private final int side;

    private final long[] keys = new long[MOST_CLUSTERS];
    private int clusters;
    private final int[] clusterOfCorner;

    /** By pixel: the cluster that all four corners belong to; -1 if they differ. */
    private final int[] clusterOfPixel;

    private Block block;
    private int perPixel;

    /** By path: its value without the deterministic part, and its cluster. */
    private double[] rest = new double[0];

    private int[] clusterOfPath = new int[0];

    private int[] costOfPath = new int[0];

    /** By chessboard colour and cluster: the number of paths, the sums of their rest, and of their squared deviations as shown. */
    private final int[] counts = new int[2 * MOST_CLUSTERS];

    private final double[] sums = new double[3 * 2 * MOST_CLUSTERS];
    private final double[] squares = new double[2 * MOST_CLUSTERS];
    private final long[] costs = new long[2 * MOST_CLUSTERS];

    /** By chessboard colour, over all clusters: the mean squared deviation as shown. */
    private final double[] meanSquare = new double[2];

    private final double[] meanCost = new double[2];

    private final double[] meanRest = new double[6];

    /** By pixel: the sum of squared deviations as shown. */
    private final double[] ofPixel;

    private final double[] level = new double[3];
    private final double[] shownLevel = new double[3];
    private final double[] corner = new double[3];

    /** The square root of the number of samples per pixel. */
    private double root;

    PathNoise(DisplayCurve curve, Corners corners) {
        this.curve = curve;
        this.corners = corners;
        side = corners.side - 1;
        clusterOfCorner = new int[corners.nodes];
        clusterOfPixel = new int[side * side];
        ofPixel = new double[side * side];
    }

    /**
     * Begins a block whose corners were surveyed.
     *
     * @param paths the number of paths per pixel that {@link #tell} will record
     * @param samplesPerPixel the number of samples of a pixel's mean
     */
    void begin(Block target, int paths, double samplesPerPixel) {
        block = target;
        perPixel = paths;
        root = Math.sqrt(samplesPerPixel);
        clusters = 0;
        int n = ofPixel.length * paths;
        if (clusterOfPath.length < n) {
            clusterOfPath = new int[n];
            costOfPath = new int[n];
            rest = new double[3 * n];
        }
        for (int j = 0; j <= block.height(); j++) {
            for (int i = 0; i <= block.width(); i++) {
                int k = corners.node(i, j);
                clusterOfCorner[k] = cluster(corners.keys[k]);
            }
        }
        for (int j = 0; j < block.height(); j++) {
            for (int i = 0; i < block.width(); i++) {
                boolean isQuiet = corners.commonKey(i, j) != Corners.DIFFERENT;
                clusterOfPixel[pixel(i, j)] = isQuiet ? clusterOfCorner[corners.node(i, j)] : -1;
            }
        }
    }

    private int cluster(long key) {
        for (int k = 0; k < clusters; k++) {
            if (keys[k] == key) {
                return k;
            }
        }
        if (clusters == OTHERS) {
            return OTHERS;
        }
        keys[clusters] = key;
        return clusters++;
    }

    private int pixel(int i, int j) {
        return side * j + i;
    }

    /** Whether all four corners of a pixel have the same key. */
    boolean isQuiet(int i, int j) {
        return clusterOfPixel[pixel(i, j)] >= 0;
    }

    /**
     * Records a path.
     *
     * @param k its number in its pixel
     * @param key of the surfaces that it met
     * @param cost roughly the number of its rays, in any unit
     * @param r its value without the deterministic part; in a pixel whose corners agree, without the interpolation of the corners
     */
    void tell(int i, int j, int k, long key, int cost, double r, double g, double b) {
        int pixel = pixel(i, j);
        int n = perPixel * pixel + k;
        int own = clusterOfPixel[pixel];
        clusterOfPath[n] = own >= 0 ? own : cluster(key);
        costOfPath[n] = cost;
        rest[3 * n] = r;
        rest[3 * n + 1] = g;
        rest[3 * n + 2] = b;
    }

    private void clear() {
        Arrays.fill(counts, 0);
        Arrays.fill(sums, 0);
        Arrays.fill(costs, 0);
        Arrays.fill(squares, 0);
    }

    /** Ends a block for which no path was recorded, as all its light is deterministic; in place of {@link #finish}. */
    void finishQuiet() {
        clear();
        Arrays.fill(ofPixel, 0);
        Arrays.fill(meanSquare, 0);
        Arrays.fill(meanCost, 1);
    }

    /** Computes the statistics of the recorded paths. */
    void finish() {
        clear();
        for (int j = 0; j < block.height(); j++) {
            for (int i = 0; i < block.width(); i++) {
                addSums(i, j);
            }
        }
        findMeans();
        for (int j = 0; j < block.height(); j++) {
            for (int i = 0; i < block.width(); i++) {
                addSquares(i, j);
            }
        }
        for (int field = 0; field < 2; field++) {
            double sum = 0;
            double cost = 0;
            long paths = 0;
            for (int k = 0; k < MOST_CLUSTERS; k++) {
                sum += squares[MOST_CLUSTERS * field + k];
                cost += costs[MOST_CLUSTERS * field + k];
                paths += counts[MOST_CLUSTERS * field + k];
            }
            meanSquare[field] = paths == 0 ? 0 : sum / paths;
            meanCost[field] = paths == 0 ? 1 : cost / paths;
        }
    }

    /** The chessboard colour of a pixel, 0 or 1. */
    static int field(int i, int j) {
        return (i + j) & 1;
    }

    private void addSums(int i, int j) {
        int first = perPixel * pixel(i, j);
        for (int n = first; n < first + perPixel; n++) {
            int k = MOST_CLUSTERS * field(i, j) + clusterOfPath[n];
            counts[k]++;
            costs[k] += costOfPath[n];
            for (int c = 0; c < 3; c++) {
                sums[3 * k + c] += rest[3 * n + c];
            }
        }
    }

    /** Turns sums into means; clusters without paths get the mean of all. */
    private void findMeans() {
        for (int field = 0; field < 2; field++) {
            int from = MOST_CLUSTERS * field;
            for (int c = 0; c < 3; c++) {
                double sum = 0;
                long paths = 0;
                for (int k = from; k < from + MOST_CLUSTERS; k++) {
                    sum += sums[3 * k + c];
                    paths += counts[k];
                }
                meanRest[3 * field + c] = paths == 0 ? 0 : sum / paths;
                for (int k = from; k < from + MOST_CLUSTERS; k++) {
                    sums[3 * k + c] = counts[k] == 0 ? meanRest[3 * field + c] : sums[3 * k + c] / counts[k];
                }
            }
        }
    }

    private void addSquares(int i, int j) {
        int field = field(i, j);
        findLevel(i, j, field);
        int pixel = pixel(i, j);
        int first = perPixel * pixel;
        double sum = 0;
        for (int n = first; n < first + perPixel; n++) {
            int k = MOST_CLUSTERS * field + clusterOfPath[n];
            double square = 0;
            for (int c = 0; c < 3; c++) {
                double d = shown(rest[3 * n + c] - sums[3 * k + c], c);
                square += d * d;
            }
            squares[k] += square / 3;
            sum += square / 3;
        }
        ofPixel[pixel] = sum;
    }

    /** Sets the expected radiance of a pixel, as the mean of its corners. */
    private void findLevel(int i, int j, int field) {
        Arrays.fill(level, 0);
        for (int k = 0; k < 4; k++) {
            toCorner(i, j, k, field);
            for (int c = 0; c < 3; c++) {
                level[c] += corner[c] / 4;
            }
        }
        for (int c = 0; c < 3; c++) {
            shownLevel[c] = curve.nearly(level[c]);
        }
    }

    /** Sets the expected radiance at a corner of a pixel. */
    private void toCorner(int i, int j, int which, int field) {
        int node = corners.node(i + (which & 1), j + (which >> 1));
        int k = MOST_CLUSTERS * field + clusterOfCorner[node];
        for (int c = 0; c < 3; c++) {
            corner[c] = corners.rgb[3 * node + c] + sums[3 * k + c];
        }
    }

    /** The deviation of a sample as shown: that of the mean of the pixel's samples, multiplied by the square root of their number. */
    private double shown(double deviation, int c) {
        return root * (curve.nearly(level[c] + deviation / root) - shownLevel[c]);
    }

    /** The variance, as shown, of one sample of a pixel, without that of the interpolation between its corners. */
    double variance(int i, int j) {
        int field = 1 - field(i, j);
        int own = clusterOfPixel[pixel(i, j)];
        if (own < 0) {
            double sum = 0;
            for (int k = 0; k < 4; k++) {
                int cluster = clusterOfCorner[corners.node(i + (k & 1), j + (k >> 1))];
                sum += of(field, cluster, 0, 0);
            }
            return sum / 4;
        }
        double near = 0;
        int count = 0;
        for (int k = 0; k < 4; k++) {
            int x = i + (k < 2 ? 2 * k - 1 : 0);
            int y = j + (k < 2 ? 0 : 2 * k - 5);
            if (x >= 0 && y >= 0 && x < block.width() && y < block.height() && clusterOfPixel[pixel(x, y)] == own) {
                near += ofPixel[pixel(x, y)];
                count += perPixel;
            }
        }
        return of(field, own, near, count);
    }

    /** The mean square of a cluster, in which paths of adjacent pixels weigh more. */
    private double of(int field, int cluster, double near, int nearPaths) {
        int k = MOST_CLUSTERS * field + cluster;
        return ((NEAR - 1) * near + squares[k] + OF_BLOCK * meanSquare[field])
                / ((NEAR - 1) * nearPaths + counts[k] + OF_BLOCK);
    }

    /** The mean cost of a path through a pixel, in the unit of {@link #tell}. */
    double cost(int i, int j) {
        int field = 1 - field(i, j);
        double sum = 0;
        for (int k = 0; k < 4; k++) {
            int n = MOST_CLUSTERS * field + clusterOfCorner[corners.node(i + (k & 1), j + (k >> 1))];
            sum += (costs[n] + OF_BLOCK * meanCost[field]) / (counts[n] + OF_BLOCK);
        }
        return sum / 4;
    }

    /** The variance, as shown, of the interpolation between a pixel's corners: of an edge that passes between them. */
    double edge(int i, int j) {
        int own = clusterOfPixel[pixel(i, j)];
        if (own >= 0) {
            return 0;
        }
        int field = 1 - field(i, j);
        Arrays.fill(level, 0);
        double sum = 0;
        for (int k = 0; k < 4; k++) {
            toCorner(i, j, k, field);
            for (int c = 0; c < 3; c++) {
                double v = curve.nearly(corner[c]);
                level[c] += v / 4;
                sum += v * v;
            }
        }
        double squaredMeans = level[0] * level[0] + level[1] * level[1] + level[2] * level[2];
        return Math.max(sum / 12 - squaredMeans / 3, 0);
    }
}
