package enlightenment.film;

import enlightenment.color.DisplayCurve;

/** A pass over the pixels of a film of linear light, in the order of rows, which finds what they tell of its error. */
final class LightPass {
    private final DisplayCurve curve;
    private final int left;
    private final int top;
    private final int right;
    private final int bottom;

    /** A pass over a rectangle of the whole picture. */
    LightPass(DisplayCurve curve, int x, int y, int width, int height) {
        this.curve = curve;
        left = x;
        top = y;
        right = x + width;
        bottom = y + height;
    }

    /**
     * Goes through all pixels.
     *
     * @param bandMeans {@link #bandMeans}
     * @param visitor is shown what each pixel tells
     * @return what they tell together
     */
    LinearFigures run(FilmView film, double[] bandMeans, PixelFigures.Visitor visitor) {
        double[] quarters = new double[QuarterMeans.PER_PIXEL];
        double[] local = new double[3];
        LinearFigures figures = new LinearFigures(curve, left, top, right - left, bottom - top, bandMeans);
        for (int row = top; row < bottom; row++) {
            for (int column = left; column < right; column++) {
                int count = film.count(column, row);
                if (count == 0) {
                    visitor.pixel(0, 0, 0, false);
                    continue;
                }
                film.quarterMeans(column, row, quarters);
                light(film, column, row, local);
                figures.add(column, row, local, quarters, count);
                float halves = film.halves(column, row);
                // A single sample's quarters are all the same, but for what was splatted.
                float first = (float) (figures.first() + (count == 1 ? halves : 0));
                float second =
                        switch (count) {
                            case 1 -> first;
                            case 2 -> film.quarters(column, row) + first - halves;
                            default -> (float) figures.second();
                        };
                visitor.pixel(first, second, count, QuarterMeans.isRare(curve, quarters, count));
            }
        }
        return figures;
    }

    /** The light of a pixel: the least of its own and of the mean of its 3 × 3 pixels, of each band. */
    private void light(FilmView film, int column, int row, double[] out) {
        for (int c = 0; c < 3; c++) {
            double sum = 0;
            int n = 0;
            for (int r = Math.max(row - 1, top); r <= Math.min(row + 1, bottom - 1); r++) {
                for (int q = Math.max(column - 1, left); q <= Math.min(column + 1, right - 1); q++) {
                    if (film.count(q, r) > 0) {
                        sum += film.component(q, r, c);
                        n++;
                    }
                }
            }
            out[c] = Math.min(film.component(column, row, c), sum / n);
        }
    }

    /** The mean of each band over the finished pixels. */
    double[] bandMeans(FilmView film) {
        double[] sums = new double[3];
        long pixels = 0;
        for (int row = top; row < bottom; row++) {
            for (int column = left; column < right; column++) {
                if (film.count(column, row) > 0) {
                    pixels++;
                    for (int c = 0; c < 3; c++) {
                        sums[c] += film.component(column, row, c);
                    }
                }
            }
        }
        for (int c = 0; c < 3; c++) {
            sums[c] /= Math.max(pixels, 1);
        }
        return sums;
    }
}
