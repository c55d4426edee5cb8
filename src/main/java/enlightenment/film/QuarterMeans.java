package enlightenment.film;

import enlightenment.color.DisplayCurve;

/**
 * What the four quarters of a pixel's samples of linear light tell of its error, in what a screen shows: as {@link SampleSpread}, of
 * the means after the display curve. The quarters are those of {@link TilePasses#firstSample}; where one has no samples it repeats the
 * one before it.
 *
 * <p>Quarters may differ by a sample in size. Figures are then scaled to what equal ones would tell of independent samples.
 */
final class QuarterMeans {
    static final int QUARTERS = 4;

    /** Red, green and blue of the first quarter, then of the second, and so on. */
    static final int PER_PIXEL = 3 * QUARTERS;

    private QuarterMeans() {}

    /** How many of a pixel's samples belong to a quarter. */
    static int size(int samples, int quarter) {
        return TilePasses.firstSample(samples, quarter + 1, QUARTERS)
                - TilePasses.firstSample(samples, quarter, QUARTERS);
    }

    /**
     * The means of a pixel's quarters.
     *
     * @param sums per quarter those of red, green and blue
     * @param samples of the pixel, at least 1
     * @param out gets {@link #PER_PIXEL} numbers; 0 where a sum is no finite number
     */
    static void of(double[] sums, int samples, float[] out, int from) {
        for (int q = 0; q < QUARTERS; q++) {
            int size = size(samples, q);
            for (int c = 0; c < 3; c++) {
                int k = from + 3 * q + c;
                if (size == 0) {
                    out[k] = out[k - 3];
                } else {
                    float mean = (float) (sums[3 * q + c] / size);
                    out[k] = Float.isFinite(mean) ? mean : 0;
                }
            }
        }
    }

    /** The mean of component c of the first (0) or second (1) half. */
    static double half(double[] quarters, int samples, int half, int c) {
        int q = 2 * half;
        double a = size(samples, q);
        double b = size(samples, q + 1);
        double first = quarters[3 * q + c];
        double second = quarters[3 * q + 3 + c];
        return a == 0 || b == 0 ? 0.5 * (first + second) : (a * first + b * second) / (a + b);
    }

    /** What brings (A − B)²/4 of halves of unequal size to what it would be of equal ones; 1 for less than two samples. */
    static double balance(int samples) {
        double a = size(samples, 0) + size(samples, 1);
        double b = size(samples, 2) + size(samples, 3);
        return samples < 2 ? 1 : 4 * a * b / ((a + b) * (a + b));
    }

    /** (A − B)²/4 for the two halves as they are shown, mean of the components; 0 for less than two samples. */
    static double halves(DisplayCurve curve, double[] quarters, int samples) {
        if (samples < 2) {
            return 0;
        }
        double sum = 0;
        for (int c = 0; c < 3; c++) {
            double d = curve.nearly(half(quarters, samples, 0, c)) - curve.nearly(half(quarters, samples, 1, c));
            sum += d * d;
        }
        return balance(samples) * sum / 12;
    }

    /**
     * Whether few samples carry the pixel's light, so that the screen may hide part of its noise. A mean of k rare samples has a relative
     * deviation of 1/√k: if the quarters show less than ½, more than four such samples were met, one for each quarter. Where other light
     * hides that they are few, the display curve decides ({@link #isFlattened}). With less than four samples it cannot be known, and is
     * assumed.
     */
    static boolean isRare(DisplayCurve curve, double[] quarters, int samples) {
        if (samples < QUARTERS) {
            return true;
        }
        double squares = 0;
        double variance = 0;
        for (int c = 0; c < 3; c++) {
            double first = half(quarters, samples, 0, c);
            double second = half(quarters, samples, 1, c);
            double a = quarters[c] - quarters[3 + c];
            double b = quarters[6 + c] - quarters[9 + c];
            squares += (first + second) * (first + second) / 4;
            variance += ((first - second) * (first - second) / 4 + (a * a + b * b) / 8) / 3;
        }
        return QUARTERS * variance > squares || isFlattened(curve, quarters, samples);
    }

    /**
     * Whether the curve flattens at the mean. The largest deviation of a quarter then shows upwards less than half of what it shows
     * downwards.
     */
    private static boolean isFlattened(DisplayCurve curve, double[] quarters, int samples) {
        double up = 0;
        double down = 0;
        for (int c = 0; c < 3; c++) {
            double mean = (half(quarters, samples, 0, c) + half(quarters, samples, 1, c)) / 2;
            double off = 0;
            for (int q = 0; q < QUARTERS; q++) {
                off = Math.max(off, Math.abs(quarters[3 * q + c] - mean));
            }
            double shown = curve.nearly(mean);
            up += curve.nearly(mean + off) - shown;
            down += shown - curve.nearly(mean - off);
        }
        return 2 * up < down;
    }

    /**
     * {@link #halves} for the two quarters of each half, mean of both. Below four samples it is twice the halves, as of independent
     * samples.
     */
    static double quarters(DisplayCurve curve, double[] quarters, int samples) {
        return samples < QUARTERS
                ? 2 * halves(curve, quarters, samples)
                : (difference(curve, quarters, samples, 0) + difference(curve, quarters, samples, 2)) / 24;
    }

    private static double difference(DisplayCurve curve, double[] quarters, int samples, int quarter) {
        double sum = 0;
        for (int c = 0; c < 3; c++) {
            double d = curve.nearly(quarters[3 * quarter + c]) - curve.nearly(quarters[3 * quarter + 3 + c]);
            sum += d * d;
        }
        double a = size(samples, quarter);
        double b = size(samples, quarter + 1);
        // (1/a + 1/b)/4 of the variance of a sample, where equal ones tell 2/n.
        return sum * 8 * a * b / (samples * (a + b));
    }
}
