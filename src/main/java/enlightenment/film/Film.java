package enlightenment.film;

import enlightenment.color.DisplayCurve;
import enlightenment.image.Image;

/** A film whose pixels are in memory. */
public final class Film extends TileFilm {
    private final double[] rgb;

    /** Per pixel; see {@link FilmTile#halves} and {@link FilmTile#quarters}. Of linear light only where there are one or two samples. */
    private final float[] halves;

    private final float[] quarters;
    private final int[] counts;

    /** Per pixel of linear light: means of the quarters of its samples; null for display-referred pixels. */
    private final float[] quarterMeans;

    /** Light splatted over pixels with one to three samples of linear light, whose spread shows too little; null for none. */
    private final FewSamplesSplats fewSplats;

    /** A film for a rectangle of the whole picture, display-referred. */
    public Film(int x, int y, int width, int height) {
        this(x, y, width, height, DisplayCurve.NONE);
    }

    /**
     * A film for a rectangle of the whole picture.
     *
     * @param curve what pixels are, and how they become what a screen takes
     */
    public Film(int x, int y, int width, int height, DisplayCurve curve) {
        this(x, y, width, height, curve, null);
    }

    private Film(int x, int y, int width, int height, DisplayCurve curve, FewSamplesSplats fewSplats) {
        super(x, y, width, height, curve);
        this.fewSplats = fewSplats;
        int pixels = width * height;
        rgb = new double[Math.toIntExact(3L * width * height)];
        halves = new float[pixels];
        quarters = new float[pixels];
        counts = new int[pixels];
        quarterMeans = isLinear() ? new float[Math.multiplyExact(QuarterMeans.PER_PIXEL, pixels)] : null;
    }

    private void keep(int pixel, double[] means) {
        for (int i = 0; i < QuarterMeans.PER_PIXEL; i++) {
            quarterMeans[QuarterMeans.PER_PIXEL * pixel + i] = (float) means[i];
        }
    }

    @Override
    public void put(int left, int top, int columns, int rows, Source source) {
        FilmPixel pixel = new FilmPixel();
        for (int row = top; row < top + rows; row++) {
            for (int column = left; column < left + columns; column++) {
                source.read(column, row, pixel);
                put(column, row, pixel.means, 0, pixel.halves, pixel.quarters, pixel.samples);
                if (isLinear()) {
                    keep(pixel(column, row), pixel.ofQuarters);
                }
            }
        }
    }

    /**
     * Puts a finished pixel, given by its place in the whole picture; 0 samples make it unfinished.
     *
     * @param means the means of red, green and blue
     * @param from where in {@code means} they are
     */
    public void put(int column, int row, double[] means, int from, float half, float quarter, int samples) {
        int pixel = pixel(column, row);
        System.arraycopy(means, from, rgb, 3 * pixel, 3);
        halves[pixel] = half;
        quarters[pixel] = quarter;
        counts[pixel] = samples;
    }

    private int pixel(int column, int row) {
        return (row - y) * width + column - x;
    }

    /** Component 0, 1 or 2 of the pixel in column and row of the whole picture, in full precision. */
    public double component(int column, int row, int c) {
        return rgb[3 * pixel(column, row) + c];
    }

    @Override
    public float[] quarterMeans() {
        if (quarterMeans == null) {
            throw new IllegalStateException("display-referred pixels have no quarters");
        }
        return quarterMeans.clone();
    }

    @Override
    public int count(int column, int row) {
        return counts[pixel(column, row)];
    }

    @Override
    public ErrorEstimate error() {
        if (isLinear()) {
            return lightError();
        }
        ErrorEstimate.Contrast contrast = new ErrorEstimate.Contrast();
        for (int k = 0; k < rgb.length; k++) {
            if (counts[k / 3] > 0) {
                contrast.add(rgb[k]);
            }
        }
        return ErrorEstimate.of(
                PixelFigures.of(halves, quarters, counts, null), ErrorEstimate.kind(areDifferences()), contrast.get());
    }

    private ErrorEstimate lightError() {
        float[] first = new float[counts.length];
        float[] second = new float[counts.length];
        boolean[] rare = new boolean[counts.length];
        LightPass pass = new LightPass(curve, x, y, width, height);
        int[] next = new int[1];
        PixelFigures.Visitor visitor = (a, b, count, isRare) -> {
            int i = next[0]++;
            first[i] = a;
            second[i] = b;
            rare[i] = isRare;
        };
        LinearFigures figures =
                pass.run(view(), pass.bandMeans(view()), fewSplats == null ? visitor : fewSplats.over(visitor));
        boolean isGrowing = fewSplats != null && fewSplats.isGrowing();
        return ErrorEstimate.ofLight(PixelFigures.of(first, second, counts, rare))
                .with(figures.error(isGrowing));
    }

    @Override
    FilmView view() {
        return new FilmView() {
            @Override
            public int count(int column, int row) {
                return counts[pixel(column, row)];
            }

            @Override
            public double component(int column, int row, int c) {
                return rgb[3 * pixel(column, row) + c];
            }

            @Override
            public float halves(int column, int row) {
                return halves[pixel(column, row)];
            }

            @Override
            public float quarters(int column, int row) {
                return quarters[pixel(column, row)];
            }

            @Override
            public void quarterMeans(int column, int row, double[] out) {
                int from = QuarterMeans.PER_PIXEL * pixel(column, row);
                for (int i = 0; i < QuarterMeans.PER_PIXEL; i++) {
                    out[i] = quarterMeans[from + i];
                }
            }
        };
    }

    @Override
    public Film plus(Splats splats) {
        return (Film) super.plus(splats);
    }

    @Override
    FewSamplesSplats fewSamples() {
        return FewSamplesSplats.inMemory(curve, counts.length);
    }

    @Override
    Film empty(FewSamplesSplats few) {
        return new Film(x, y, width, height, curve, few);
    }

    @Override
    long samples() {
        long sum = 0;
        for (int count : counts) {
            sum += count;
        }
        return sum;
    }

    @Override
    public Image toImage() {
        float[] pixels = new float[rgb.length];
        for (int i = 0; i < rgb.length; i++) {
            pixels[i] = FloatLight.of(rgb[i], curve);
        }
        return new Image(width, height, pixels, curve);
    }
}
