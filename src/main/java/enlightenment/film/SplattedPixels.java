package enlightenment.film;

import enlightenment.color.Color;
import enlightenment.color.DisplayCurve;

/**
 * The pixels of a film with what paths have splatted over them: exact means, and quarters each with a group of the paths' units, so
 * that errors are those of the sum. Pixels that are not finished stay so. Asked for row by row.
 */
final class SplattedPixels implements TileFilm.Source {
    /** Step for the slope of the curve, as a share of a pixel's light. */
    private static final double STEP = 1.0 / 64;

    private final FilmView tiles;
    private final SplatLight splats;
    private final DisplayCurve curve;
    private final boolean isLinear;

    /** Receives pixels with few samples of linear light. */
    private final FewSamplesSplats few;

    private final FilmPixel before = new FilmPixel();

    private final double[] groups = new double[3 * Splats.GROUPS];
    private final int[] sizes = {1, 1, 1, 1};

    /** The pixels that were read. */
    private long pixels;

    SplattedPixels(FilmView tiles, SplatLight splats, DisplayCurve curve, FewSamplesSplats few) {
        this.tiles = tiles;
        this.splats = splats;
        this.curve = curve;
        this.few = few;
        isLinear = curve.encoding() == Color.Encoding.LINEAR;
    }

    @Override
    public void read(int column, int row, FilmPixel pixel) {
        readTile(column, row, pixel);
        if (!isLinear) {
            addShown(column, row, pixel);
        } else if (pixel.samples > 0) {
            before.set(pixel);
            addLight(column, row, pixel);
            if (FewSamplesSplats.areFew(pixel.samples)) {
                few.add(pixels, before, pixel);
            }
        }
        pixels++;
    }

    private void readTile(int column, int row, FilmPixel pixel) {
        pixel.samples = tiles.count(column, row);
        for (int c = 0; c < 3; c++) {
            pixel.means[c] = tiles.component(column, row, c);
        }
        pixel.halves = tiles.halves(column, row);
        pixel.quarters = tiles.quarters(column, row);
        if (isLinear) {
            tiles.quarterMeans(column, row, pixel.ofQuarters);
        }
    }

    private void addLight(int column, int row, FilmPixel pixel) {
        for (int c = 0; c < 3 && splats.paths() > 0; c++) {
            double all = splats.all(column, row, c);
            pixel.means[c] += all;
            for (int g = 0; g < Splats.GROUPS; g++) {
                // A group without paths adds what all do.
                double own = splats.paths(g) > 0 ? splats.of(g, column, row, c) : all;
                pixel.ofQuarters[3 * g + c] = (float) pixel.ofQuarters[3 * g + c] + (float) own;
            }
        }
        double scale = pixel.samples <= 2 ? steepness(before.means, pixel.means) : 1;
        pixel.halves = (float) (scale * pixel.halves);
        pixel.quarters = (float) (scale * pixel.quarters);
    }

    /** By how much squared differences of what is shown shrink where there is more light; what neighbours told knew only the less. */
    private double steepness(double[] less, double[] more) {
        double a = 0;
        double b = 0;
        for (int c = 0; c < 3; c++) {
            double step = STEP * (less[c] + more[c]);
            double first = curve.nearly(less[c] + step) - curve.nearly(less[c]);
            double second = curve.nearly(more[c] + step) - curve.nearly(more[c]);
            a += first * first;
            b += second * second;
        }
        return a > 0 ? Math.min(b / a, 1) : 1;
    }

    /** Adds to a display-referred pixel: paths and samples are independent, so their squared errors add. */
    private void addShown(int column, int row, FilmPixel pixel) {
        if (pixel.samples == 0) {
            pixel.clear();
            return;
        }
        for (int c = 0; c < 3; c++) {
            pixel.means[c] += splats.all(column, row, c);
            for (int g = 0; g < Splats.GROUPS; g++) {
                groups[3 * g + c] = splats.of(g, column, row, c);
            }
        }
        double first = SampleSpread.halves(groups, sizes);
        // Of one or two samples the second figure is a variance, too.
        double second = pixel.samples > 2 ? SampleSpread.quarters(groups, sizes) : first;
        pixel.halves = (float) (pixel.halves + first);
        pixel.quarters = (float) (pixel.quarters + second);
    }
}
