package enlightenment.film;

import enlightenment.color.DisplayCurve;
import enlightenment.film.VarianceDecay.Curve;

/**
 * The error of what paths splatted over pixels of linear light with one to three samples. Such pixels tell only that of their samples; but
 * the paths are of four groups all the same, whose halves and quarters tell of them what those of four samples do: that the screen shows
 * less of their noise than there is, too.
 */
final class FewSamplesSplats {
    /** From this number on a pixel's samples have quarters. */
    private static final int MANY = QuarterMeans.QUARTERS;

    /** Binary logarithm of the number of groups. */
    private static final int LEVEL = 2;

    private final DisplayCurve curve;

    /** Per pixel: both figures of its samples, and both of what was splatted. */
    private final float[] figures;

    private final double[] means = new double[QuarterMeans.PER_PIXEL];

    private FewSamplesSplats(DisplayCurve curve, int pixels) {
        this.curve = curve;
        figures = new float[Math.multiplyExact(4, pixels)];
    }

    /** Those of pixels with these numbers of samples; null where none of them has few. */
    static FewSamplesSplats of(DisplayCurve curve, int[] counts) {
        for (int count : counts) {
            if (areFew(count)) {
                return new FewSamplesSplats(curve, counts.length);
            }
        }
        return null;
    }

    /** Whether these are so few samples that they have no quarters. */
    static boolean areFew(int count) {
        return count > 0 && count < MANY;
    }

    /**
     * Adds a pixel with few samples.
     *
     * @param before the film before paths were splatted
     * @param after the film with them, which has what one or two samples tell of their error
     */
    void add(int pixel, int count, Film before, Film after) {
        float[] out = figures;
        out[4 * pixel] = after.halves(pixel);
        out[4 * pixel + 1] = after.quarters(pixel);
        if (count == MANY - 1) {
            for (int i = 0; i < means.length; i++) {
                means[i] = before.ofQuarter(pixel, i) + after.mean(pixel, i % 3) - before.mean(pixel, i % 3);
            }
            out[4 * pixel] = (float) QuarterMeans.halves(curve, means, count);
            out[4 * pixel + 1] = (float) QuarterMeans.quarters(curve, means, count);
        }
        for (int i = 0; i < means.length; i++) {
            means[i] = before.mean(pixel, i % 3) + after.ofQuarter(pixel, i) - before.ofQuarter(pixel, i);
        }
        out[4 * pixel + 2] = (float) QuarterMeans.halves(curve, means, MANY);
        out[4 * pixel + 3] = (float) QuarterMeans.quarters(curve, means, MANY);
    }

    /**
     * Writes the figures of pixels with few samples, so that what was splatted is as large in both as the variance that it leaves.
     *
     * @return whether most of the error is of splats that make pixels bright one by one, and most of those that will be are not so yet
     */
    boolean putTo(float[] first, float[] second, int[] counts) {
        double a = 0;
        double b = 0;
        double samples = 0;
        for (int i = 0; i < counts.length; i++) {
            samples += figures[4 * i];
            a += figures[4 * i + 2];
            b += figures[4 * i + 3];
        }
        double share = a > 0 ? PathDecay.share(Curve.MIDDLE, LEVEL, b / a) : 0;
        for (int i = 0; i < counts.length; i++) {
            if (areFew(counts[i])) {
                double splatted = share * figures[4 * i + 2];
                first[i] = (float) (figures[4 * i] + splatted);
                second[i] = (float) (figures[4 * i + 1] + splatted);
            }
        }
        return b < a && share * a > samples;
    }
}
