package enlightenment.film;

import enlightenment.film.VarianceDecay.Curve;
import enlightenment.film.VarianceDecay.Samples;
import java.util.Arrays;

/** The sums over all pixels with the same number of samples, a power of two, and what follows from them; or over those of all other numbers. */
final class SampleLevel {
    /** Levels of 2^0 .. 2^30 samples, and one for other numbers. */
    private static final int LEVELS = 32;

    private static final int OTHERS = LEVELS - 1;

    /** With fewer pixels than this a ratio of their halves and quarters says little, and that of all pixels is taken. */
    private static final int ENOUGH = 200;

    /** From this level on pixels have quarters. */
    private static final int OF_QUARTERS = 2;

    /** Binary logarithm of the number of samples, or −1. */
    private final int name;

    private double first;
    private double second;
    private double firstSquared;
    private double product;
    private double secondSquared;
    private long pixels;

    /** The ratio of the second figure to the first, of these pixels or of all. */
    private double ratio;

    private double share = 1;
    private double least = 1;
    private double most = 1;

    private SampleLevel(int name) {
        this.name = name;
    }

    /** The levels of a picture, each judged. */
    static SampleLevel[] of(PixelFigures figures, Samples kind) {
        SampleLevel[] levels = new SampleLevel[LEVELS];
        Arrays.setAll(levels, k -> new SampleLevel(k == OTHERS ? -1 : k));
        SampleLevel pooled = new SampleLevel(-1);
        int least = VarianceDecay.leastPooled(kind);
        figures.forEach((first, second, count, rare) -> {
            if (count > 0) {
                int k = index(count, kind);
                levels[k].add(first, second);
                if (k >= least && k != OTHERS) {
                    pooled.add(first, second);
                }
            }
        });
        for (int k = 0; k < LEVELS; k++) {
            boolean own = k < OF_QUARTERS || k == OTHERS || levels[k].pixels >= ENOUGH && levels[k].first > 0;
            levels[k].judge(own ? levels[k] : pooled, kind);
        }
        return levels;
    }

    /** The level of pixels with this many samples. */
    static SampleLevel of(SampleLevel[] levels, int count, Samples kind) {
        return levels[index(count, kind)];
    }

    /** Its place among all levels. */
    static int index(int count, Samples kind) {
        if (count == 3 && kind == Samples.LIGHT) {
            // They tell no more than two.
            return 1;
        }
        return Integer.bitCount(count) == 1 ? Integer.numberOfTrailingZeros(count) : OTHERS;
    }

    private void add(double a, double b) {
        first += a;
        second += b;
        firstSquared += a * a;
        product += a * b;
        secondSquared += b * b;
        pixels++;
    }

    private double ownRatio() {
        return first > 0 ? second / first : 0;
    }

    /** How far chance may have taken the ratio, in 95 of 100 cases. */
    private double uncertainty() {
        if (!(first > 0)) {
            return 0;
        }
        double r = ownRatio();
        double squares = secondSquared - 2 * r * product + r * r * firstSquared;
        return ErrorEstimate.TWO_SIDED_95 * Math.sqrt(Math.max(squares, 0)) / first;
    }

    /** @param of the level whose ratio is taken */
    private void judge(SampleLevel of, Samples kind) {
        ratio = of.ownRatio();
        double off = of.uncertainty();
        share = VarianceDecay.share(Curve.MIDDLE, name, ratio, kind);
        // Shares grow or fall with the ratio, or both.
        least = share;
        most = share;
        for (double at : new double[] {ratio - off, ratio + off}) {
            least = Math.min(VarianceDecay.share(Curve.LEAST, name, at, kind), least);
            most = Math.max(VarianceDecay.share(Curve.MOST, name, at, kind), most);
        }
    }

    /** Binary logarithm of the number of samples, or −1. */
    int name() {
        return name;
    }

    /** Whether its pixels have four samples or more: their quarters tell something beside the halves. */
    boolean hasQuarters() {
        return name < 0 || name >= OF_QUARTERS;
    }

    /** The sum of the first figures. */
    double first() {
        return first;
    }

    /** The sum of the second figures. */
    double second() {
        return second;
    }

    /** The ratio of the second figure to the first, of these pixels or, where they are few, of all; 0 where there are none. */
    double ratio() {
        return ratio;
    }

    /** The variance as a share of the first figure, in the middle of its interval. */
    double share() {
        return share;
    }

    /** The lower end of that interval. */
    double least() {
        return least;
    }

    /** The upper end of that interval. */
    double most() {
        return most;
    }
}
