package enlightenment.compiled;

import enlightenment.color.DisplayCurve;

/**
 * Light that paths from the eye find by chance only, as far as it is known where it is: caustics that are seen in mirrors or through glass.
 * In a pixel where a sample finds it with the probability q, and n samples were taken, n q find it in the mean; the numbers have Poisson's
 * distribution. From that follows how far the pixel is from the truth in the mean, and what the halves of its samples tell of that: where
 * hardly any pixel has met such light they tell next to nothing. Immutable.
 */
public final class ChanceLight {
    /** Numbers of a part of the picture: other light and this light by band, and q. */
    private static final int NUMBERS = 7;

    /** Where more find it in the mean, the halves of the samples tell what there is to tell. */
    private static final double ENOUGH = 2;

    /** The same of all pixels that share what they find: with fewer, most of it hangs on one or two. */
    private static final double ENOUGH_TOGETHER = 8;

    /** Of so many in the mean one of 4,000 times more find it than this. */
    private static final int MOST = 8;

    /** 97.5 % of a normal distribution lie below so many deviations. */
    private static final double ONE_IN_40 = 1.96;

    /** What the figure of the halves is taken for at most. */
    private static final double SATURATED = 4;

    private final float[] parts;

    private ChanceLight(float[] parts) {
        this.parts = parts;
    }

    /** Gathers what is known. */
    public static final class Builder {
        private final float[] parts;
        private boolean isEmpty = true;

        /** @param parts how many parts of the picture there are, of equal size */
        public Builder(int parts) {
            this.parts = new float[NUMBERS * parts];
        }

        /**
         * Sets what is in a part.
         *
         * @param other radiance of all other light, by band
         * @param light radiance of this light, by band
         * @param found how many of a sample find it; 0 for light that none ever finds
         */
        public void set(int part, double[] other, double[] light, double found) {
            int at = NUMBERS * part;
            for (int c = 0; c < 3; c++) {
                parts[at + c] = (float) other[c];
                parts[at + 3 + c] = (float) light[c];
            }
            parts[at + 6] = (float) found;
            isEmpty &= !(found > 0 || light[0] + light[1] + light[2] > 0);
        }

        /** What was gathered; null if there is none of such light. */
        public ChanceLight build() {
            return isEmpty ? null : new ChanceLight(parts);
        }
    }

    /** What it does to the error of a picture with so many samples per pixel. */
    public ChanceError error(DisplayCurve curve, double samples) {
        double shortfall = 0;
        double sum = 0;
        double variance = 0;
        double[] square = new double[2];
        for (int at = 0; at < parts.length; at += NUMBERS) {
            double mean = samples * parts[at + 6];
            if (mean < ENOUGH) {
                squared(curve, at, mean, square);
                shortfall += Math.max(square[0] - (mean > 0 ? told(curve, at, mean) : 0), 0);
                sum += square[0];
                variance += square[1];
            }
        }
        double pixels = parts.length / (double) NUMBERS;
        return new ChanceError(shortfall / pixels, (sum + ONE_IN_40 * Math.sqrt(Math.max(variance, 0))) / pixels);
    }

    /**
     * What it does to the error of a picture whose pixels show together what any of them has found: all of it is lacking, and nothing tells
     * of it, or in the mean enough samples find it.
     *
     * @param together how many pixels do so
     */
    public ChanceError error(DisplayCurve curve, double samples, double together) {
        double found = 0;
        double sum = 0;
        double[] square = new double[2];
        for (int at = 0; at < parts.length; at += NUMBERS) {
            found += parts[at + 6];
            squared(curve, at, 0, square);
            sum += square[0];
        }
        double pixels = parts.length / (double) NUMBERS;
        return samples * together * found / pixels < ENOUGH_TOGETHER
                ? new ChanceError(sum / pixels, sum / pixels)
                : ChanceError.NONE;
    }

    /**
     * The squared error of a part, mean of components.
     *
     * @param mean how many samples find the light in the mean
     * @param out receives its mean and its variance
     */
    private void squared(DisplayCurve curve, int at, double mean, double[] out) {
        double[] probability = poisson(mean);
        double squares = 0;
        out[0] = 0;
        for (int k = 0; k <= MOST; k++) {
            double error = 0;
            if (probability[k] == 0) {
                continue;
            }
            for (int c = 0; c < 3; c++) {
                double light = parts[at + 3 + c];
                double met = k == 0 ? 0 : light * k / mean;
                double d = curve.nearly(parts[at + c] + met) - curve.nearly(parts[at + c] + light);
                error += d * d / 3;
            }
            out[0] += probability[k] * error;
            squares += probability[k] * error * error;
        }
        out[1] = squares - out[0] * out[0];
    }

    /** What is told of that in the mean: by the halves of the samples, and where the screen saturates by more (film.PathDecay). */
    private double told(DisplayCurve curve, int at, double mean) {
        double[] half = poisson(mean / 2);
        double[] quarter = poisson(mean / 4);
        double halves = 0;
        double quarters = 0;
        for (int c = 0; c < 3; c++) {
            double other = parts[at + c];
            double light = parts[at + 3 + c];
            halves += difference(curve, other, 2 * light / mean, half) / 12;
            quarters += difference(curve, other, 4 * light / mean, quarter) / 12;
        }
        return halves * Math.min(Math.max(2 * halves / Math.max(quarters, Double.MIN_NORMAL), 1), SATURATED);
    }

    /** The mean squared difference of two independent numbers of finds, as they show. */
    private static double difference(DisplayCurve curve, double other, double each, double[] probability) {
        double sum = 0;
        double[] shown = new double[MOST + 1];
        for (int k = 0; k <= MOST; k++) {
            shown[k] = curve.nearly(other + each * k);
            for (int j = 0; j < k; j++) {
                double d = shown[k] - shown[j];
                sum += 2 * probability[k] * probability[j] * d * d;
            }
        }
        return sum;
    }

    private static double[] poisson(double mean) {
        double[] probability = new double[MOST + 1];
        probability[0] = StrictMath.exp(-mean);
        for (int k = 1; k <= MOST; k++) {
            probability[k] = probability[k - 1] * mean / k;
        }
        return probability;
    }
}
