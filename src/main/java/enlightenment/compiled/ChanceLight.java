package enlightenment.compiled;

import enlightenment.color.DisplayCurve;
import java.util.Arrays;

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

    /** What is known of light whose finds differ is an estimate, whose squared error may be so much larger. */
    private static final double UNCERTAIN = 1.25;

    /** What the figure of the halves is taken for at most. */
    private static final double SATURATED = 4;

    private final float[] parts;

    /** How many parts there are beside each other. */
    private final int across;

    /** What counts, by part: which share of it is within what is looked at. */
    private final double[] shares;

    /** What a find is worth; null if each is worth as much as any other. */
    private final RareFinds finds;

    private ChanceLight(float[] parts, int across, double[] shares, RareFinds finds) {
        this.parts = parts;
        this.across = across;
        this.shares = shares;
        this.finds = finds;
    }

    /**
     * What is known of a rectangle of the picture.
     *
     * @param left as a share of the picture's width, less than {@code right}; and so on, from the top left
     */
    ChanceLight within(double left, double top, double right, double bottom) {
        int down = parts.length / NUMBERS / across;
        double[] inside = new double[across * down];
        for (int part = 0; part < inside.length; part++) {
            inside[part] = overlap(part % across, across, left, right) * overlap(part / across, down, top, bottom);
        }
        return new ChanceLight(parts, across, inside, finds);
    }

    /** Which share of the k-th of n equal pieces of 0..1 lies between two numbers. */
    private static double overlap(int k, int n, double from, double to) {
        return Math.max(Math.min(to * n, k + 1) - Math.max(from * n, k), 0);
    }

    /** How many parts count. */
    private double size() {
        double sum = 0;
        for (double share : shares) {
            sum += share;
        }
        return sum;
    }

    /** Gathers what is known. */
    public static final class Builder {
        private final float[] parts;
        private final int across;
        private boolean isEmpty = true;

        /**
         * @param across how many parts of the picture there are beside each other, of equal size
         * @param down how many below each other; they are numbered row by row from the top left
         */
        public Builder(int across, int down) {
            parts = new float[NUMBERS * across * down];
            this.across = across;
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
            return build(null);
        }

        /**
         * What was gathered of light that samples find so, whatever probabilities were set; null if there is none of such light.
         *
         * @param finds null if each find is worth as much as any other
         */
        public ChanceLight build(RareFinds finds) {
            double[] all = new double[parts.length / NUMBERS];
            Arrays.fill(all, 1);
            return isEmpty ? null : new ChanceLight(parts, across, all, finds);
        }
    }

    /** What it does to the error of a picture with so many samples per pixel. */
    public ChanceError error(DisplayCurve curve, double samples) {
        if (finds != null) {
            return finds.suffice(samples) ? ChanceError.NONE : unequal(curve, samples);
        }
        double shortfall = 0;
        double sum = 0;
        double variance = 0;
        double[] square = new double[2];
        for (int at = 0; at < parts.length; at += NUMBERS) {
            double mean = samples * parts[at + 6];
            double share = shares[at / NUMBERS];
            if (mean < ENOUGH && share > 0) {
                squared(curve, at, mean, square);
                shortfall += share * Math.max(square[0] - (mean > 0 ? told(curve, at, mean) : 0), 0);
                sum += share * square[0];
                variance += share * square[1];
            }
        }
        double pixels = size();
        return new ChanceError(shortfall / pixels, (sum + ONE_IN_40 * Math.sqrt(Math.max(variance, 0))) / pixels);
    }

    /** The same where finds differ in what they are worth. */
    private ChanceError unequal(DisplayCurve curve, double samples) {
        RareFinds.Outcome part = new RareFinds.Outcome();
        double sum = 0;
        double variance = 0;
        double halves = 0;
        double quarters = 0;
        for (int k = 0; k < shares.length; k++) {
            if (shares[k] > 0) {
                finds.play(curve, samples, k, parts, NUMBERS * k, part);
                sum += shares[k] * part.square;
                variance += shares[k] * part.variance;
                halves += shares[k] * part.halves;
                quarters += shares[k] * part.quarters;
            }
        }
        double pixels = size();
        // Other noise beside it, where the screen does not saturate, keeps what is told from being all of that share.
        double told = halves * Math.sqrt(share(halves, quarters));
        double most = UNCERTAIN * (sum + ONE_IN_40 * Math.sqrt(variance));
        return new ChanceError(Math.max(sum - told, 0) / pixels, most / pixels);
    }

    /** How much of the figure of the halves is told (film.PathDecay): where the screen saturates it is more. */
    private static double share(double halves, double quarters) {
        return Math.min(Math.max(2 * halves / Math.max(quarters, Double.MIN_NORMAL), 1), SATURATED);
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
            double share = shares[at / NUMBERS];
            found += share * parts[at + 6];
            squared(curve, at, 0, square);
            sum += share * square[0];
        }
        double pixels = size();
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
        return halves * share(halves, quarters);
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
