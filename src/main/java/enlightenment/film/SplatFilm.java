package enlightenment.film;

import enlightenment.color.DisplayCurve;
import enlightenment.image.Image;
import java.util.stream.IntStream;

/** Splats whose sums are in memory. */
public final class SplatFilm extends Splats {
    /** By group and pixel, units of red, green and blue. */
    private final long[][] sums;

    /**
     * A black film for a rectangle of the whole picture.
     *
     * @param picturePixels number of pixels of the whole picture
     * @param curve what pixels are, and how they become what a screen takes
     */
    public SplatFilm(int x, int y, int width, int height, long picturePixels, SplatScale scale, DisplayCurve curve) {
        super(x, y, width, height, picturePixels, scale, curve);
        sums = new long[GROUPS][Math.multiplyExact(3, Math.multiplyExact(width, height))];
    }

    @Override
    void put(int group, SplatSums batch) {
        long[] to = sums[group];
        int overflow = firstOverflow(batch.pixels, batch.sums, to);
        if (overflow >= 0) {
            throw SplatScale.tooBright(x + overflow % width, y + overflow / width);
        }
        add(batch.pixels, batch.sums, to);
    }

    /** The first pixel whose sum would become too large; negative for none. */
    private static int firstOverflow(int[] pixels, long[] sums, long[] to) {
        for (int i = 0; i < pixels.length; i++) {
            int k = 3 * pixels[i];
            int from = 3 * i;
            for (int c = 0; c < 3; c++) {
                if (SplatSums.overflows(to[k + c], sums[from + c])) {
                    return pixels[i];
                }
            }
        }
        return -1;
    }

    private static void add(int[] pixels, long[] sums, long[] to) {
        for (int i = 0; i < pixels.length; i++) {
            int k = 3 * pixels[i];
            int from = 3 * i;
            to[k] += sums[from];
            to[k + 1] += sums[from + 1];
            to[k + 2] += sums[from + 2];
        }
    }

    @Override
    void take(int group, SplatSums batch) {
        long[] from = sums[group];
        for (int i = 0; i < batch.pixels.length; i++) {
            for (int c = 0; c < 3; c++) {
                from[3 * batch.pixels[i] + c] -= batch.sums[3 * i + c];
            }
        }
    }

    @Override
    SplatView view() {
        return (column, row, c, group) -> sums[group][3 * ((row - y) * width + column - x) + c];
    }

    /** Component 0, 1 or 2 of the pixel in column and row of the whole picture, in full precision; 0 without paths. */
    public synchronized double component(int column, int row, int c) {
        return light().all(column, row, c);
    }

    /** Adds the picture as it stands, as it is rounded to floats, to components of pixels, row by row. */
    public synchronized void addTo(float[] rgb) {
        SplatLight light = light();
        for (int k = 0; k < rgb.length; k++) {
            rgb[k] += FloatLight.of(light.all(x + k / 3 % width, y + k / 3 / width, k % 3), curve);
        }
    }

    /** The pictures of the four groups, as {@link Film#quarterMeans}; a group without paths has what all groups tell. */
    public synchronized float[] quarterMeans() {
        int pixels = width * height;
        float[] means = new float[Math.multiplyExact(QuarterMeans.PER_PIXEL, pixels)];
        SplatLight light = light();
        for (int pixel = 0; pixel < pixels && light.paths() > 0; pixel++) {
            int column = x + pixel % width;
            int row = y + pixel / width;
            for (int i = 0; i < QuarterMeans.PER_PIXEL; i++) {
                int group = i / 3;
                double mean =
                        light.paths(group) > 0 ? light.of(group, column, row, i % 3) : light.all(column, row, i % 3);
                means[QuarterMeans.PER_PIXEL * pixel + i] = (float) mean;
            }
        }
        return means;
    }

    /** The picture as it stands. */
    public synchronized Image toImage() {
        float[] pixels = new float[3 * width * height];
        addTo(pixels);
        return new Image(width, height, pixels, curve);
    }

    /**
     * The error of the pixels as estimated from the four groups, in units of the film. Its interval allows for correlated pixels. With less
     * than two groups each pixel's variance is its square.
     */
    public synchronized ErrorEstimate error() {
        SplatLight light = light();
        int[] groups =
                IntStream.range(0, GROUPS).filter(g -> light.paths(g) > 0).toArray();
        double[] variances = new double[width * height];
        if (groups.length < 2) {
            for (int k = 0; k < 3 * variances.length; k++) {
                double v = light.all(x + k / 3 % width, y + k / 3 / width, k % 3);
                variances[k / 3] += v * v / 3;
            }
            return ErrorEstimate.of(variances, 1);
        }
        GroupSpread spread = new GroupSpread(groups.length);
        double[] means = new double[groups.length];
        long[] numbers = new long[groups.length];
        for (int i = 0; i < variances.length; i++) {
            double sum = 0;
            for (int c = 0; c < 3; c++) {
                for (int g = 0; g < groups.length; g++) {
                    numbers[g] = light.paths(groups[g]);
                    means[g] = light.of(groups[g], x + i % width, y + i / width, c);
                }
                sum += spread.add(means, numbers);
            }
            spread.addPixel(sum);
            variances[i] = sum / 3 / light.paths();
        }
        return ErrorEstimate.of(variances, spread.inverse());
    }
}
