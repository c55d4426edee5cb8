package enlightenment.method.cluster;

/** The colour between the four corners of a pixel, bilinear: a control variate, whose mean over the pixel is known. */
public final class Interpolation {
    /** Constant, by x, by y and by xy, for red, green and blue. */
    private final double[] corners = new double[12];

    /** Turns to a pixel of the block. */
    public void between(Corners survey, int i, int j) {
        int upper = 3 * survey.node(i, j);
        int lower = upper + 3 * survey.side;
        for (int c = 0; c < 3; c++) {
            double p = survey.rgb[upper + c];
            double q = survey.rgb[upper + 3 + c];
            double r = survey.rgb[lower + c];
            double s = survey.rgb[lower + 3 + c];
            corners[4 * c] = p;
            corners[4 * c + 1] = q - p;
            corners[4 * c + 2] = r - p;
            corners[4 * c + 3] = p - q - r + s;
        }
    }

    /** Subtracts the colour at a place in the pixel from one. */
    public void subtract(double dx, double dy, double[] color) {
        double dxy = dx * dy;
        for (int c = 0; c < 3; c++) {
            int k = 4 * c;
            color[c] -= Math.fma(
                    corners[k + 3], dxy, Math.fma(corners[k + 2], dy, Math.fma(corners[k + 1], dx, corners[k])));
        }
    }

    /** The mean of a component over the pixel. */
    public double mean(int c) {
        int k = 4 * c;
        return corners[k] + (corners[k + 1] + corners[k + 2]) / 2 + corners[k + 3] / 4;
    }
}
