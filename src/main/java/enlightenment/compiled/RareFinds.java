package enlightenment.compiled;

import enlightenment.color.DisplayCurve;
import enlightenment.sampling.Hash;
import java.util.Arrays;

/**
 * How samples find some light that few of them find: each with a small probability, and then it is worth one of many amounts, some of which
 * may be far greater than most. Immutable.
 */
public final class RareFinds {
    /** So many times is it played through what samples of a part of the picture find. */
    private static final int TRIALS = 16;

    private static final int QUARTERS = 4;

    /** Where as many finds of equal worth as tell as much are more than this, the halves of the samples tell what there is to tell. */
    private static final double ENOUGH = 2;

    /** More than so many finds are not played through. */
    private static final double MOST = 1 << 9;

    private final double probability;

    /** What finds are worth: shares of what all samples find in the mean. */
    private final double[] worth;

    /** The sums of their probabilities. */
    private final double[] cumulative;

    /** Mean square over squared mean of what a find is worth. */
    private final double spread;

    private RareFinds(double probability, double[] worth, double[] cumulative, double spread) {
        this.probability = probability;
        this.worth = worth;
        this.cumulative = cumulative;
        this.spread = spread;
    }

    /**
     * Finds by a model of them.
     *
     * @param probability that a sample finds something, positive
     * @param worth what was found, in any unit, 0 if nothing after all
     * @param weight how much each of these counts
     * @return null if nothing was found
     */
    public static RareFinds of(double probability, double[] worth, double[] weight) {
        double weights = 0;
        double sum = 0;
        double squares = 0;
        double[] upTo = new double[worth.length];
        for (int k = 0; k < worth.length; k++) {
            weights += weight[k];
            sum = Math.fma(weight[k], worth[k], sum);
            squares = Math.fma(weight[k] * worth[k], worth[k], squares);
            upTo[k] = weights;
        }
        double mean = sum / weights;
        if (!(mean > 0 && squares < Double.POSITIVE_INFINITY && probability > 0)) {
            return null;
        }
        double[] shares = new double[worth.length];
        for (int k = 0; k < worth.length; k++) {
            shares[k] = worth[k] / (mean * probability);
            upTo[k] /= weights;
        }
        return new RareFinds(probability, shares, upTo, squares / weights / (mean * mean));
    }

    /** Whether so many samples tell of themselves how far they are from the truth. */
    boolean suffice(double samples) {
        double found = samples * probability;
        return found >= ENOUGH * spread || found > MOST;
    }

    /** What happens to a part of the picture. */
    static final class Outcome {
        /** The squared error, mean of components: its mean and its variance. */
        double square;

        double variance;

        /** What the halves of the samples show of it, and the quarters: film.SampleSpread. */
        double halves;

        double quarters;
    }

    /**
     * Plays through what so many samples make of a part of the picture.
     *
     * @param key of the random numbers
     * @param numbers radiance by band: of other light, and of this light, from {@code at} on
     */
    void play(DisplayCurve curve, double samples, long key, float[] numbers, int at, Outcome out) {
        out.square = 0;
        out.halves = 0;
        out.quarters = 0;
        double squares = 0;
        double[] found = new double[QUARTERS];
        double none = StrictMath.exp(-samples * probability / QUARTERS);
        for (int trial = 0; trial < TRIALS; trial++) {
            for (int k = 0; k < QUARTERS; k++) {
                found[k] = find(none, Hash.of(key, trial, k)) / samples;
            }
            double error = 0;
            for (int c = 0; c < 3; c++) {
                error += play(curve, numbers[at + c], numbers[at + 3 + c], found, out) / 3;
            }
            out.square += error / TRIALS;
            squares += error * error / TRIALS;
        }
        out.variance = Math.max(squares - out.square * out.square, 0);
    }

    /** One band; returns the squared error. */
    private double play(DisplayCurve curve, double other, double light, double[] found, Outcome out) {
        double first = found[0] + found[1];
        double second = found[2] + found[3];
        double d = curve.nearly(other + light * (first + second)) - curve.nearly(other + light);
        double halves = curve.nearly(other + 2 * light * first) - curve.nearly(other + 2 * light * second);
        double left = curve.nearly(other + 4 * light * found[0]) - curve.nearly(other + 4 * light * found[1]);
        double right = curve.nearly(other + 4 * light * found[2]) - curve.nearly(other + 4 * light * found[3]);
        out.halves += halves * halves / (12 * TRIALS);
        out.quarters += (left * left + right * right) / (24 * TRIALS);
        return d * d;
    }

    /** What the samples of a quarter find in all, where their number has Poisson's distribution: by the product of uniform numbers. */
    private double find(double none, long key) {
        double sum = 0;
        long hash = key;
        double product = 1;
        while (true) {
            hash = Hash.next(hash, 1);
            product *= Hash.unit(hash);
            if (product <= none) {
                return sum;
            }
            hash = Hash.next(hash, 1);
            int k = Arrays.binarySearch(cumulative, Hash.unit(hash));
            sum += worth[Math.min(k < 0 ? -k - 1 : k + 1, worth.length - 1)];
        }
    }
}
