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
    private final Figures figures;

    private final double[] means = new double[QuarterMeans.PER_PIXEL];
    private final float[] four = new float[4];

    /** Sums over pixels with few samples: the first figure of the samples, and both of what was splatted. */
    private double ofSamples;

    private double first;
    private double second;
    private boolean areSome;

    /** Keeps four numbers of each pixel, which come and go in the order of pixels. */
    interface Figures {
        /** Keeps those of a pixel. */
        void put(long pixel, float[] four);

        /** Reads those of a pixel; zeros if none were kept. */
        void get(long pixel, float[] four);

        /** Releases files. */
        default void release() {}
    }

    FewSamplesSplats(DisplayCurve curve, Figures figures) {
        this.curve = curve;
        this.figures = figures;
    }

    /** Splats of a picture with its figures in memory, which is allocated with the first of them. */
    static FewSamplesSplats inMemory(DisplayCurve curve, int pixels) {
        return new FewSamplesSplats(curve, new Figures() {
            private float[] all;

            @Override
            public void put(long pixel, float[] four) {
                if (all == null) {
                    all = new float[Math.multiplyExact(4, pixels)];
                }
                System.arraycopy(four, 0, all, 4 * (int) pixel, 4);
            }

            @Override
            public void get(long pixel, float[] four) {
                System.arraycopy(all, 4 * (int) pixel, four, 0, 4);
            }
        });
    }

    /** Whether these are so few samples that they have no quarters. */
    static boolean areFew(int count) {
        return count > 0 && count < MANY;
    }

    /**
     * Adds a pixel with few samples, in the order of pixels.
     *
     * @param before the pixel before paths were splatted
     * @param after with them; has what one or two samples tell of their error
     */
    void add(long pixel, FilmPixel before, FilmPixel after) {
        int count = after.samples;
        four[0] = after.halves;
        four[1] = after.quarters;
        if (count == MANY - 1) {
            for (int i = 0; i < means.length; i++) {
                means[i] = before.ofQuarters[i] + after.means[i % 3] - before.means[i % 3];
            }
            four[0] = (float) QuarterMeans.halves(curve, means, count);
            four[1] = (float) QuarterMeans.quarters(curve, means, count);
        }
        for (int i = 0; i < means.length; i++) {
            means[i] = before.means[i % 3] + after.ofQuarters[i] - before.ofQuarters[i];
        }
        four[2] = (float) QuarterMeans.halves(curve, means, MANY);
        four[3] = (float) QuarterMeans.quarters(curve, means, MANY);
        figures.put(pixel, four);
        ofSamples += four[0];
        first += four[2];
        second += four[3];
        areSome = true;
    }

    private double share() {
        return first > 0 ? PathDecay.share(Curve.MIDDLE, LEVEL, second / first) : 0;
    }

    /** Shows all pixels with the figures of those with few samples, so that what was splatted is as large in both as the variance that it leaves. */
    PixelFigures.Visitor over(PixelFigures.Visitor visitor) {
        if (!areSome) {
            return visitor;
        }
        double share = share();
        float[] own = new float[4];
        long[] next = new long[1];
        return (a, b, count, rare) -> {
            long pixel = next[0]++;
            if (areFew(count)) {
                figures.get(pixel, own);
                double splatted = share * own[2];
                visitor.pixel((float) (own[0] + splatted), (float) (own[1] + splatted), count, rare);
            } else {
                visitor.pixel(a, b, count, rare);
            }
        };
    }

    /** Whether most of the error is of splats that make pixels bright one by one, and most of those that will be are not so yet. */
    boolean isGrowing() {
        return second < first && share() * first > ofSamples;
    }

    /** Gives up what is not in memory. */
    void release() {
        figures.release();
    }
}
