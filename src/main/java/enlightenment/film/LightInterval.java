package enlightenment.film;

import enlightenment.film.VarianceDecay.Curve;
import enlightenment.film.VarianceDecay.Samples;

/**
 * The ends of the 95 % interval of a picture's squared error, of linear light, summed over its pixels; also where few pixels carry it.
 *
 * <p>A pixel's halves (A) are one contrast of its samples, its quarters (B) two. If their true ratio is R, (A + 2 B/R)/3 is what all three
 * tell of A, and it does not depend on the ratio that is found: of sums of squares of normal numbers total and ratio are independent.
 * So each is uncertain for itself, and both together are so within an ellipse: what one has of the 1.96 deviations the other lacks. Of m
 * pixels
 *
 * <ul>
 *   <li>the logarithm of B/A has the variance ψ′(m/2) + ψ′(m);
 *   <li>the picture's error, as it is, has the χ² distribution of m degrees of freedom, and what tells of it that of 3 m: their ratio
 *       has the F distribution.
 * </ul>
 *
 * <p>Ratios below 2 come from a screen that saturates, which it does in pixels that a few bright samples made bright
 * ({@link QuarterMeans#isRare}). In others a smaller one is believed only as far as it is more than chance.
 */
final class LightInterval {
    /** How many points of the half ellipse are looked at on either side of its middle. */
    private static final int STEPS = 16;

    /** The ratio of independent samples. */
    private static final double INDEPENDENT = 2;

    /** The ratio where the screen shows white whatever light is there: halves and quarters as {@link PathDecay} has them. */
    private static final double LEAST_RATIO = 1.0 / 4;

    /** The ratio of smooth light, whose variance falls as the cube of the number of samples: nothing falls faster. */
    private static final double MOST_RATIO = 8;

    /** Contrasts of four quarters. */
    private static final int CONTRASTS = 3;

    private final SampleLevel[] levels;

    /** Per level: the share of its variance in pixels that the screen may have saturated. */
    private final double[] rareShares;

    /** Degrees of freedom of the error. */
    private double carriers = 1;

    /** Degrees of freedom of the estimate of that error. */
    private double tellers = 1;

    private double ratioDeviation;

    private LightInterval(SampleLevel[] levels) {
        this.levels = levels;
        rareShares = new double[levels.length];
    }

    /** Sums over the pixels of a picture. */
    private final class Sums implements PixelFigures.Visitor {
        final double[] sums = new double[levels.length];
        double sum;
        double squares;
        double ofError;
        double ofEstimate;

        @Override
        public void pixel(float first, float second, int count, boolean rare) {
            if (count == 0) {
                return;
            }
            int k = SampleLevel.index(count, Samples.LIGHT);
            int contrasts = levels[k].hasQuarters() ? CONTRASTS : 1;
            double v = levels[k].share() * together(levels[k], first, second, within(levels[k].ratio()));
            sums[k] += v;
            rareShares[k] += rare ? v : 0;
            sum += v;
            squares += v * v;
            // The expectation of v² is (1 + 2/contrasts) σ⁴.
            ofError += v * v * contrasts / (contrasts + 2);
            ofEstimate += v * v / (contrasts + 2);
        }
    }

    /** That of a picture with these {@linkplain SampleLevel#of levels}. */
    static LightInterval of(SampleLevel[] levels, PixelFigures figures) {
        LightInterval interval = new LightInterval(levels);
        Sums all = interval.new Sums();
        figures.forEach(all);
        for (int k = 0; k < levels.length; k++) {
            interval.rareShares[k] = all.sums[k] > 0 ? interval.rareShares[k] / all.sums[k] : 0;
        }
        if (all.sum > 0) {
            // Chance makes the squares too great, by (contrasts + 2)/contrasts where there are many, and that stays
            // so: where pixels differ, chance that makes the noisiest one's estimate small makes their number look
            // great at the same time.
            interval.carriers = all.sum * all.sum / all.squares;
            interval.tellers = interval.carriers * all.ofError / all.ofEstimate;
        }
        interval.ratioDeviation = Math.sqrt(trigamma(interval.carriers / 2) + trigamma(interval.carriers));
        return interval;
    }

    /** What halves and quarters tell together of the halves, if that is their ratio. */
    private static double together(SampleLevel level, double first, double second, double ratio) {
        return level.hasQuarters() ? (first + 2 * second / ratio) / CONTRASTS : first;
    }

    private static double within(double ratio) {
        return Math.min(Math.max(ratio, LEAST_RATIO), MOST_RATIO);
    }

    /** The upper end. */
    double high() {
        double high = 0;
        for (int i = -STEPS; i <= STEPS; i++) {
            double t = (double) i / STEPS;
            double sum = 0;
            for (int k = 0; k < levels.length; k++) {
                double ratio = ratioAt(k, t);
                double any = of(Curve.MOST, k, ratio);
                double floor = floor(k);
                double straight = ratio < floor ? of(Curve.MOST, k, floor) : any;
                sum += straight + rareShares[k] * (any - straight);
            }
            high = Math.max(high, sum * fQuantile(deviations(t), carriers, tellers));
        }
        return high;
    }

    /** The lower end. */
    double low() {
        double low = Double.POSITIVE_INFINITY;
        for (int i = -STEPS; i <= STEPS; i++) {
            double t = (double) i / STEPS;
            double sum = 0;
            for (int k = 0; k < levels.length; k++) {
                sum += of(Curve.LEAST, k, ratioAt(k, t));
            }
            low = Math.min(low, sum / fQuantile(deviations(t), tellers, carriers));
        }
        return low;
    }

    /**
     * The least ratio of pixels that many samples made bright: that of independent samples, or where a smaller one is found, that shrunk
     * towards it by as much of the distance as chance makes (W. James and C. Stein 1961).
     */
    private double floor(int k) {
        double distance = StrictMath.log(within(levels[k].ratio()) / INDEPENDENT);
        if (!(distance < 0)) {
            return INDEPENDENT;
        }
        double believed = Math.max(1 - ratioDeviation * ratioDeviation / (distance * distance), 0);
        return INDEPENDENT * StrictMath.exp(believed * distance);
    }

    /** What is left of the deviations where the ratio has the share t. */
    private static double deviations(double t) {
        return ErrorEstimate.TWO_SIDED_95 * Math.sqrt(1 - t * t);
    }

    private double ratioAt(int k, double t) {
        return within(within(levels[k].ratio()) * StrictMath.exp(t * ErrorEstimate.TWO_SIDED_95 * ratioDeviation));
    }

    private double of(Curve curve, int k, double ratio) {
        SampleLevel level = levels[k];
        return VarianceDecay.share(curve, level.name(), ratio, Samples.LIGHT)
                * together(level, level.first(), level.second(), ratio);
    }

    /** ψ′(x), the variance of the logarithm of a gamma distribution of shape x &gt; 0: its asymptotic series, by recurrence from x + 6. */
    static double trigamma(double x) {
        double sum = 0;
        double at = x;
        for (int k = 0; k < 6; k++) {
            sum += 1 / (at * at);
            at++;
        }
        return sum + (1 + (0.5 + (1.0 / 6 - 1 / (30 * at * at)) / at) / at) / at;
    }

    /**
     * A quantile of the F distribution: the cube root is nearly a ratio of normal numbers (E. Paulson 1942, after E. B. Wilson and M. M.
     * Hilferty 1931). With less than three degrees of freedom below that fails, and the logarithm is taken as normal.
     *
     * @param z where the quantile lies of a normal distribution, in deviations, from 0 to 2
     * @param above degrees of freedom, at least 1, as below
     */
    static double fQuantile(double z, double above, double below) {
        if (below < 3) {
            return StrictMath.exp(z * Math.sqrt(trigamma(above / 2) + trigamma(below / 2)));
        }
        double u = 2 / (9 * above);
        double v = 2 / (9 * below);
        double a = 1 - u;
        double b = 1 - v;
        double root = (a * b + z * Math.sqrt(a * a * v + b * b * u - z * z * u * v)) / (b * b - z * z * v);
        return root * root * root;
    }
}
