package enlightenment.method.metropolis;

import java.util.Arrays;

/** Independent paths of a group: where each began, what it is worth, and their brightness summed up. */
final class Starts {
    private int count;
    private double[] colors = new double[0];
    private int[] pixels = new int[0];

    /** Sums of the brightness of the paths up to each. */
    private double[] sums = new double[0];

    private double[] brightness = new double[0];

    /** Forgets all, for so many paths. */
    void begin(int paths) {
        count = 0;
        if (pixels.length < paths) {
            colors = new double[3 * paths];
            pixels = new int[paths];
            sums = new double[paths];
            brightness = new double[paths];
        }
    }

    /** Adds the path that was followed last. */
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

    /** The mean brightness. */
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

    /** The path at which the sums pass a share of the whole: each is found by shares in proportion to its brightness. */
    int at(double share) {
        double sought = share * sums[count - 1];
        int found = Arrays.binarySearch(sums, 0, count, sought);
        int path = found >= 0 ? found + 1 : -found - 1;
        // Ties and rounding must not lead to a path that is worth nothing.
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
