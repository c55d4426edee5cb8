package enlightenment.method.cluster;

/** The bilinear interpolation between the four corners of a pixel: a control variate with a known mean over the pixel. */
public final class Interpolation {
    /** Coefficients of 1, x, y and xy, for red, green and blue. */
    private final double[] corners = new double[12];

    /** Sets the pixel of the block, by its column and row there. */
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

    /** Subtracts the interpolated colour at a position within the pixel, 0..1. */
    public void subtract(double dx, double dy, double[] color) {
        double dxy = dx * dy;
        for (int c = 0; c < 3; c++) {
            int k = 4 * c;
            color[c] -= Math.fma(
                    corners[k + 3], dxy, Math.fma(corners[k + 2], dy, Math.fma(corners[k + 1], dx, corners[k])));
        }
    }

    /** The mean of a colour component over the pixel. */
    public double mean(int c) {
        int k = 4 * c;
        return corners[k] + (corners[k + 1] + corners[k + 2]) / 2 + corners[k + 3] / 4;
    }
}
