package enlightenment.method.metropolis;

import java.util.Arrays;

/** The independent paths of a group: their pixels and colours, and the cumulative sums of their brightness. */
final class Starts {
    private int count;
    private double[] colors = new double[0];
    private int[] pixels = new int[0];

    /** Cumulative sums of the brightness of paths. */
    private double[] sums = new double[0];

    private double[] brightness = new double[0];

    /** Clears the group, and makes room for this number of paths. */
    void begin(int paths) {
        count = 0;
        if (pixels.length < paths) {
            colors = new double[3 * paths];
            pixels = new int[paths];
            sums = new double[paths];
            brightness = new double[paths];
        }
    }

    /** Adds the last path. */
    void add(double bright, Paths last) {
        pixels[count] = last.pixel;
        brightness[count] = bright;
        System.arraycopy(last.color, 0, colors, 3 * count, 3);
        sums[count] = (count == 0 ? 0 : sums[count - 1]) + bright;
        count++;
    }

    int count() {
        return count;
    }

    /** The mean brightness of the paths. */
    double mean() {
        return count == 0 ? 0 : sums[count - 1] / count;
    }

    double brightness(int path) {
        return brightness[path];
    }

    int pixel(int path) {
        return pixels[path];
    }

    double color(int path, int c) {
        return colors[3 * path + c];
    }

    void color(int path, double[] out) {
        System.arraycopy(colors, 3 * path, out, 0, 3);
    }

    /**
     * The path at which the cumulative brightness exceeds this share of the whole: uniform shares select paths in proportion to brightness.
     */
    int at(double share) {
        double sought = share * sums[count - 1];
        int found = Arrays.binarySearch(sums, 0, count, sought);
        int path = found >= 0 ? found + 1 : -found - 1;
        // Ties and rounding must not select a path of brightness 0.
        while (path < count && !(brightness[path] > 0)) {
            path++;
        }
        path = Math.min(path, count - 1);
        while (path > 0 && !(brightness[path] > 0)) {
            path--;
        }
        return path;
    }
}
