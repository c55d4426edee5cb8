package enlightenment.film;

import enlightenment.color.DisplayCurve;
import enlightenment.film.VarianceDecay.Curve;

/** Goes through the pixels of a film of linear light and gathers what their quarters tell: figures as shown, and those of light. */
final class LinearFigures {
    /** What keeps relative errors finite in the dark, as a share of the picture's mean. */
    private static final double FLOOR = 0.05;

    private static final int SIDE = FilmTile.BLOCK_SIDE;

    private final DisplayCurve curve;
    private final int left;
    private final int top;
    private final int across;

    /** Per band: (0.05 M)². */
    private final double[] floors = new double[3];

    /** Per block of pixels: squared differences of halves, as shown and of relative light. */
    private final double[] shownBlocks;

    private final double[] lightBlocks;

    private double halves;
    private double quarters;

    /** Of pixels of less than two samples. */
    private long untold;

    private long pixels;

    /** @param means the mean of each band over all pixels */
    LinearFigures(DisplayCurve curve, int x, int y, int width, int height, double[] means) {
        this.curve = curve;
        left = x / SIDE;
        top = y / SIDE;
        across = (x + width - 1) / SIDE - left + 1;
        int down = (y + height - 1) / SIDE - top + 1;
        shownBlocks = new double[across * down];
        lightBlocks = new double[across * down];
        for (int c = 0; c < 3; c++) {
            floors[c] = FLOOR * means[c] * FLOOR * means[c];
        }
    }

    /**
     * Adds a pixel.
     *
     * @param rgb its means, from {@code from} on
     * @param means those of its quarters
     * @return the first figure, as shown
     */
    double add(int column, int row, double[] rgb, int from, double[] means, int samples) {
        pixels++;
        if (samples < 2) {
            untold++;
            return QuarterMeans.halves(curve, means, QuarterMeans.QUARTERS);
        }
        double shown = QuarterMeans.halves(curve, means, samples);
        double first = 0;
        double second = 0;
        for (int c = 0; c < 3; c++) {
            double m = rgb[from + c];
            double scale = 1 / Math.max(m * m + floors[c], Double.MIN_NORMAL);
            double d = QuarterMeans.half(means, samples, 0, c) - QuarterMeans.half(means, samples, 1, c);
            first += QuarterMeans.balance(samples) * d * d * scale / 4;
            double a = means[c] - means[3 + c];
            double b = means[6 + c] - means[9 + c];
            second += (a * a + b * b) * scale / 8;
        }
        halves += first;
        quarters += samples < QuarterMeans.QUARTERS ? 2 * first : second;
        int block = (row / SIDE - top) * across + column / SIDE - left;
        shownBlocks[block] += shown;
        lightBlocks[block] += first;
        return shown;
    }

    /** What they tell together. */
    LinearError error() {
        double ratio = halves > 0 ? quarters / halves : 2;
        double share = PathDecay.share(Curve.MIDDLE, 2, Math.max(ratio, 2));
        double relative = 2 * untold > pixels ? Double.NaN : Math.sqrt(share * halves / (3.0 * Math.max(pixels, 1)));
        return new LinearError(relative, Math.max(kurtosis(shownBlocks), kurtosis(lightBlocks)));
    }

    private static double kurtosis(double[] sums) {
        double sum = 0;
        double squares = 0;
        for (double s : sums) {
            sum += s;
            squares += s * s;
        }
        return sum > 0 ? sums.length * squares / (sum * sum) : 1;
    }
}
