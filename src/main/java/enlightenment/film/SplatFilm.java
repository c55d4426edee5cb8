package enlightenment.film;

import enlightenment.color.Color;
import enlightenment.color.DisplayCurve;
import enlightenment.image.Image;
import java.util.BitSet;
import java.util.stream.IntStream;

/**
 * A picture in the making by paths that may reach any pixel: sums of integers, so that units of work may come in any order, from any
 * threads, and go again, and the bytes are the same.
 *
 * <p>Units are of four groups, by their number; each group is a picture of its own. How far these differ tells the error.
 */
public final class SplatFilm {
    static final int GROUPS = 4;

    /** What the upper half of a sum counts. */
    private static final double HIGH = 1L << Integer.SIZE;

    public final int x;
    public final int y;
    public final int width;
    public final int height;
    private final long picturePixels;
    private final SplatScale scale;
    private final DisplayCurve curve;

    /** Of each group, for each pixel: units of red, green and blue. */
    private final long[][] sums;

    private final long[] paths = new long[GROUPS];

    /** The units that are in. */
    private final BitSet units = new BitSet();

    /**
     * A black film for a rectangle of the whole picture.
     *
     * @param picturePixels number of pixels of the whole picture
     * @param curve what pixels are, and how they become what a screen takes
     */
    public SplatFilm(int x, int y, int width, int height, long picturePixels, SplatScale scale, DisplayCurve curve) {
        this.x = x;
        this.y = y;
        this.width = width;
        this.height = height;
        this.picturePixels = picturePixels;
        this.scale = scale;
        this.curve = curve;
        sums = new long[GROUPS][Math.multiplyExact(3, Math.multiplyExact(width, height))];
    }

    /** What the pixels mean. */
    public Color.Encoding encoding() {
        return curve.encoding();
    }

    /**
     * Adds a unit of work.
     *
     * @param unit its number, from 0
     * @return whether it was missing; otherwise nothing has changed
     * @throws ArithmeticException if a pixel's sum becomes too large, with the pixel; then nothing has changed
     */
    public synchronized boolean add(int unit, SplatSums batch) {
        if (units.get(unit)) {
            return false;
        }
        long[] to = sums[unit % GROUPS];
        int overflow = firstOverflow(batch.pixels, batch.sums, to);
        if (overflow >= 0) {
            throw SplatScale.tooBright(x + overflow % width, y + overflow / width);
        }
        add(batch.pixels, batch.sums, to);
        paths[unit % GROUPS] += batch.paths;
        units.set(unit);
        return true;
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

    /**
     * Takes a unit of work out.
     *
     * @param batch what was added for it
     * @return whether it was in; otherwise nothing has changed
     * @throws IllegalArgumentException if this has more paths than were added; then nothing has changed
     */
    public synchronized boolean remove(int unit, SplatSums batch) {
        if (!units.get(unit)) {
            return false;
        }
        long[] from = sums[unit % GROUPS];
        if (paths[unit % GROUPS] < batch.paths) {
            throw new IllegalArgumentException("unit " + unit + " never added as much");
        }
        for (int i = 0; i < batch.pixels.length; i++) {
            for (int c = 0; c < 3; c++) {
                from[3 * batch.pixels[i] + c] -= batch.sums[3 * i + c];
            }
        }
        paths[unit % GROUPS] -= batch.paths;
        units.clear(unit);
        return true;
    }

    /** The number of units that are in. */
    public synchronized int units() {
        return units.cardinality();
    }

    /** The number of paths of all units that are in. */
    public synchronized long paths() {
        long sum = 0;
        for (long n : paths) {
            sum += n;
        }
        return sum;
    }

    /** Component 0, 1 or 2 of the pixel in column and row of the whole picture, in full precision; 0 without paths. */
    public synchronized double component(int column, int row, int c) {
        return value(3 * ((row - y) * width + column - x) + c, paths());
    }

    /** The same by the paths of one of the four groups alone; 0 if it has none. */
    synchronized double component(int column, int row, int c, int group) {
        long n = paths[group];
        return n == 0 ? 0 : inPicture(sums[group][3 * ((row - y) * width + column - x) + c], n);
    }

    /**
     * Adds this to means of pixels, and of each group to those of a quarter; a group without paths adds what all do.
     *
     * @param counts 0 for pixels that are left as they are
     */
    synchronized void addTo(double[] rgb, float[] quarterMeans, int[] counts) {
        long n = paths();
        for (int pixel = 0; pixel < counts.length && n > 0; pixel++) {
            if (counts[pixel] > 0) {
                addTo(rgb, quarterMeans, pixel, n);
            }
        }
    }

    private void addTo(double[] rgb, float[] quarterMeans, int pixel, long n) {
        for (int c = 0; c < 3; c++) {
            int k = 3 * pixel + c;
            double all = value(k, n);
            rgb[k] += all;
            int to = QuarterMeans.PER_PIXEL * pixel + c;
            for (int g = 0; g < GROUPS; g++) {
                double own = paths[g] > 0 ? inPicture(sums[g][k], paths[g]) : all;
                quarterMeans[to + 3 * g] += (float) own;
            }
        }
    }

    private double value(int k, long n) {
        long high = 0;
        long low = 0;
        for (long[] group : sums) {
            high += group[k] >> 32;
            low += group[k] & 0xffffffffL;
        }
        return n == 0 ? 0 : inPicture(high * HIGH + low, n);
    }

    /** The value of a pixel by the units of some paths. */
    private double inPicture(double units, long n) {
        // Most pixels of most pictures were not reached.
        return units == 0 ? 0 : scale.value(units * picturePixels / n);
    }

    /** The pictures of the four groups, as {@link Film#quarterMeans}; a group without paths has what all groups tell. */
    public synchronized float[] quarterMeans() {
        int pixels = width * height;
        float[] means = new float[Math.multiplyExact(QuarterMeans.PER_PIXEL, pixels)];
        long n = paths();
        for (int pixel = 0; pixel < pixels && n > 0; pixel++) {
            for (int i = 0; i < QuarterMeans.PER_PIXEL; i++) {
                int group = i / 3;
                int k = 3 * pixel + i % 3;
                double mean = paths[group] > 0 ? inPicture(sums[group][k], paths[group]) : value(k, n);
                means[QuarterMeans.PER_PIXEL * pixel + i] = (float) mean;
            }
        }
        return means;
    }

    /** The picture as it stands. */
    public synchronized Image toImage() {
        float[] pixels = new float[3 * width * height];
        long n = paths();
        for (int k = 0; k < pixels.length; k++) {
            pixels[k] = FloatLight.of(value(k, n), curve);
        }
        return new Image(width, height, pixels, curve);
    }

    /**
     * How far the four groups say that the pixels are from the truth, in units of the film; the interval allows for pixels that err
     * together. With less than two groups all may be chance: then each pixel's variance is its square.
     */
    public synchronized ErrorEstimate error() {
        int[] groups = IntStream.range(0, GROUPS).filter(g -> paths[g] > 0).toArray();
        long n = paths();
        double[] variances = new double[width * height];
        if (groups.length < 2) {
            for (int k = 0; k < 3 * variances.length; k++) {
                double v = value(k, n);
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
                    numbers[g] = paths[groups[g]];
                    means[g] = inPicture(sums[groups[g]][3 * i + c], numbers[g]);
                }
                sum += spread.add(means, numbers);
            }
            spread.addPixel(sum);
            variances[i] = sum / 3 / n;
        }
        return ErrorEstimate.of(variances, spread.inverse());
    }
}
