package enlightenment.image.flip;

/**
 * The filters of ꟻLIP for a number of pixels per degree: products of a row filter and a column filter, or for blue and
 * yellow a sum of two such products. All are given as 2·{@link #radius} + 1 weights.
 */
final class FlipKernels {
    /**
     * The contrast sensitivity of the eye as sums of a·√(π/b)·exp(−π²x²/b), x in degrees (table 1 of the paper, after G.
     * Johnson and M. Fairchild 2003): b of light and dark, of red and green, a and b of blue and yellow.
     */
    private static final double B_LIGHT = 0.0047;

    private static final double B_RED = 0.0053;
    private static final double A_BLUE = 34.1;
    private static final double B_BLUE = 0.04;
    private static final double A_BLUE_NARROW = 13.5;
    private static final double B_BLUE_NARROW = 0.025;

    /** How many degrees an edge or a point takes that the eye finds at once (section 4.2). */
    private static final double FEATURE_WIDTH = 0.082;

    /** Of all filters: those that need less end in zeros. */
    final int radius;

    final double[] light;
    final double[] red;
    final double[] blue;
    final double[] blueNarrow;
    /** The parts of the two filters in their sum; together 1. */
    final double blueShare;

    final double blueNarrowShare;

    /** A Gaussian of sum 1, and its first and second derivative with positive weights of sum 1 and negative of sum −1. */
    final double[] smooth;

    final double[] edge;
    final double[] point;

    FlipKernels(double pixelsPerDegree) {
        double sigma = 0.5 * FEATURE_WIDTH * pixelsPerDegree;
        int eye = (int) Math.ceil(3 * Math.sqrt(B_BLUE / (2 * Math.PI * Math.PI)) * pixelsPerDegree);
        int feature = (int) Math.ceil(3 * sigma);
        radius = Math.max(eye, feature);
        light = normalized(sensitivity(B_LIGHT, eye, pixelsPerDegree));
        red = normalized(sensitivity(B_RED, eye, pixelsPerDegree));
        double[] wide = sensitivity(B_BLUE, eye, pixelsPerDegree);
        double[] narrow = sensitivity(B_BLUE_NARROW, eye, pixelsPerDegree);
        double wideVolume = A_BLUE * Math.sqrt(Math.PI / B_BLUE) * sum(wide) * sum(wide);
        double narrowVolume = A_BLUE_NARROW * Math.sqrt(Math.PI / B_BLUE_NARROW) * sum(narrow) * sum(narrow);
        blue = normalized(wide);
        blueNarrow = normalized(narrow);
        blueShare = wideVolume / (wideVolume + narrowVolume);
        blueNarrowShare = narrowVolume / (wideVolume + narrowVolume);
        smooth = new double[2 * radius + 1];
        edge = new double[2 * radius + 1];
        point = new double[2 * radius + 1];
        for (int i = -feature; i <= feature; i++) {
            double t = i / sigma;
            double gauss = StrictMath.exp(-0.5 * t * t);
            smooth[radius + i] = gauss;
            edge[radius + i] = -t * gauss;
            point[radius + i] = (t * t - 1) * gauss;
        }
        normalized(smooth);
        normalized(edge);
        normalized(point);
    }

    private double[] sensitivity(double b, int reach, double pixelsPerDegree) {
        double[] weights = new double[2 * radius + 1];
        for (int i = -reach; i <= reach; i++) {
            double degrees = i / pixelsPerDegree;
            weights[radius + i] = StrictMath.exp(-Math.PI * Math.PI * degrees * degrees / b);
        }
        return weights;
    }

    private static double sum(double[] weights) {
        double sum = 0;
        for (double w : weights) {
            sum += w;
        }
        return sum;
    }

    /** Scales the positive weights to the sum 1 and the negative ones to −1, in place. */
    private static double[] normalized(double[] weights) {
        double positive = 0;
        double negative = 0;
        for (double w : weights) {
            if (w > 0) {
                positive += w;
            } else {
                negative -= w;
            }
        }
        for (int i = 0; i < weights.length; i++) {
            // A zero stays one, also where there is no negative weight to divide by.
            if (weights[i] != 0) {
                weights[i] /= weights[i] > 0 ? positive : negative;
            }
        }
        return weights;
    }
}
