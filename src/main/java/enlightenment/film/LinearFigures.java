package enlightenment.film;

import enlightenment.color.DisplayCurve;
import enlightenment.film.VarianceDecay.Curve;

/** Goes through the pixels of a film of linear light and gathers what their quarters tell: figures as shown, and those of light. */
final class LinearFigures {
    /** What keeps relative errors finite in the dark, as a share of the picture's mean. */
    private static final double FLOOR = 0.05;

    /** Side of the blocks of pixels in which pixels are compared to tell heavy tails. */
    private static final int SIDE = 32;

    private final DisplayCurve curve;
    private final int left;
    private final int top;
    private final int across;

    /** Per band: (0.05 M)². */
    private final double[] floors = new double[3];

    /** Per block of pixels: as shown, and of relative light. */
    private final Spread[] shownBlocks;

    private final Spread[] lightBlocks;
    private double halves;
    private double quarters;

    /** Of pixels of less than two samples. */
    private long untold;

    private long pixels;

    /** Of all pixels, as shown. */
    private double shownHalves;

    private double shownQuarters;

    /** Of the last pixel, as shown. */
    private double first;

    private double second;

    /** @param means the mean of each band over all pixels */
    LinearFigures(DisplayCurve curve, int x, int y, int width, int height, double[] means) {
        this.curve = curve;
        left = x / SIDE;
        top = y / SIDE;
        across = (x + width - 1) / SIDE - left + 1;
        int down = (y + height - 1) / SIDE - top + 1;
        shownBlocks = blocks(Math.multiplyExact(across, down));
        lightBlocks = blocks(Math.multiplyExact(across, down));
        for (int c = 0; c < 3; c++) {
            floors[c] = FLOOR * means[c] * FLOOR * means[c];
        }
    }

    /** Bytes of memory that those of a picture of this size take. */
    static long memory(int columns, int rows) {
        // Of both kinds of blocks: a reference, a header and three numbers.
        return (columns / SIDE + 2L) * (rows / SIDE + 2L) * 2 * (Integer.BYTES + 16 + 3 * Long.BYTES);
    }

    private static Spread[] blocks(int count) {
        Spread[] blocks = new Spread[count];
        for (int i = 0; i < count; i++) {
            blocks[i] = new Spread();
        }
        return blocks;
    }

    /**
     * Adds a pixel.
     *
     * @param rgb its light: not its own means alone where those are noisy, since a bright sample makes them bright as well
     * @param means those of its quarters
     */
    void add(int column, int row, double[] rgb, double[] means, int samples) {
        pixels++;
        if (samples < 2) {
            untold++;
            first = QuarterMeans.halves(curve, means, QuarterMeans.QUARTERS);
            return;
        }
        first = QuarterMeans.halves(curve, means, samples);
        second = QuarterMeans.quarters(curve, means, samples);
        shownHalves += first;
        shownQuarters += second;
        double half = 0;
        double quarter = 0;
        for (int c = 0; c < 3; c++) {
            double scale = 1 / Math.max(rgb[c] * rgb[c] + floors[c], Double.MIN_NORMAL);
            double d = QuarterMeans.half(means, samples, 0, c) - QuarterMeans.half(means, samples, 1, c);
            half += QuarterMeans.balance(samples) * d * d * scale / 4;
            double a = means[c] - means[3 + c];
            double b = means[6 + c] - means[9 + c];
            quarter += (a * a + b * b) * scale / 8;
        }
        halves += half;
        quarters += samples < QuarterMeans.QUARTERS ? 2 * half : quarter;
        int block = (row / SIDE - top) * across + column / SIDE - left;
        shownBlocks[block].add(first);
        lightBlocks[block].add(half);
    }

    /** The first figure of the last pixel, as shown; of a single sample only what was splatted. */
    double first() {
        return first;
    }

    /** The second; only of two or more samples. */
    double second() {
        return second;
    }

    /**
     * What they tell together.
     *
     * @param isGrowing whether it is known otherwise that most pixels that will be bright are not so yet
     */
    LinearError error(boolean isGrowing) {
        double ratio = halves > 0 ? quarters / halves : 2;
        double share = PathDecay.share(Curve.MIDDLE, 2, Math.max(ratio, 2));
        double relative = 2 * untold > pixels ? Double.NaN : Math.sqrt(share * halves / (3.0 * Math.max(pixels, 1)));
        return new LinearError(
                relative,
                Math.max(kurtosis(shownBlocks), kurtosis(lightBlocks)),
                isGrowing || shownQuarters < shownHalves);
    }

    /** Sums of squared differences, and of their squares, of a block. */
    private static final class Spread {
        private double sum;
        private double squares;
        private long pixels;

        void add(double value) {
            sum += value;
            squares += value * value;
            pixels++;
        }
    }

    /** Of blocks that differ in how noisy they are: each is compared with its own mean. */
    private static double kurtosis(Spread[] blocks) {
        double squares = 0;
        double expected = 0;
        for (Spread block : blocks) {
            squares += block.squares;
            expected += block.pixels == 0 ? 0 : block.sum * block.sum / block.pixels;
        }
        return expected > 0 ? squares / expected : 1;
    }
}
