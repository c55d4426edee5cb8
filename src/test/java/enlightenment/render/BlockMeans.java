package enlightenment.render;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;

/** Means over blocks of 8 × 8 pixels and over all, of pictures that differ by their seeds, and their comparison. */
final class BlockMeans {
    private static final int SIDE = 8;

    /** In each pixel of the pictures that are compared with: 4 × 4 rays of 4 points. */
    private static final int LIGHT_POINTS = 64;

    private final int width;
    private final int height;

    BlockMeans(int width, int height) {
        this.width = width;
        this.height = height;
    }

    /** For each block and, last, for the whole: one number per picture. */
    List<double[]> of(List<double[]> pictures) {
        List<double[]> all = new ArrayList<>();
        for (int y = 0; y < height; y += SIDE) {
            for (int x = 0; x < width; x += SIDE) {
                all.add(means(pictures, x, y, Math.min(x + SIDE, width), Math.min(y + SIDE, height)));
            }
        }
        all.add(means(pictures, 0, 0, width, height));
        return all;
    }

    /** For a part: one number per picture. */
    double[] means(List<double[]> pictures, int left, int top, int right, int bottom) {
        return pictures.stream()
                .mapToDouble(rgb -> {
                    double sum = 0;
                    for (int y = top; y < bottom; y++) {
                        for (int k = 3 * (y * width + left); k < 3 * (y * width + right); k++) {
                            sum += rgb[k];
                        }
                    }
                    return sum / (3 * (right - left) * (bottom - top));
                })
                .toArray();
    }

    /**
     * What Welch's test says about all blocks and the whole together.
     *
     * @param least the least probability of any comparison
     * @param level Šidák's level for it
     * @param most the greatest number of standard errors between two means
     * @param wholeError the standard error of the difference of the whole means
     */
    record Verdict(double least, double level, double most, double wholeError) {
        boolean isDifferent() {
            return least < level;
        }
    }

    /** Compares at 1 % for all together. */
    Verdict compare(List<double[]> a, List<double[]> b) {
        List<double[]> as = of(a);
        List<double[]> bs = of(b);
        double least = 1;
        double most = 0;
        double error = 0;
        for (int k = 0; k < as.size(); k++) {
            error = Welch.of(as.get(k), bs.get(k)).standardError();
            if (isUnseen(as.get(k), bs.get(k)) || isUnseen(bs.get(k), as.get(k))) {
                continue;
            }
            Welch test = Welch.of(as.get(k), bs.get(k));
            least = Math.min(least, test.probability());
            most = Math.max(most, Math.abs(test.deviations()));
        }
        return new Verdict(least, Welch.sidak(0.01, as.size()), most, error);
    }

    /**
     * Whether what makes the means differ may be so rare that none of the equal ones had a chance to see it: Welch's test then
     * takes them for certain. By the rule of three, N trials without an event bound its probability by 3/N with 95 %.
     */
    private static boolean isUnseen(double[] equal, double[] others) {
        double first = equal[0];
        double mean = Arrays.stream(others).average().orElseThrow();
        double trials = (double) SIDE * SIDE * LIGHT_POINTS * equal.length;
        return Arrays.stream(equal).allMatch(v -> Math.abs(v - first) <= 1e-12 * Math.abs(first))
                && Arrays.stream(others).anyMatch(v -> Math.abs(v - first) > 1e-12 * Math.abs(first))
                && Math.abs(mean - first) <= 3 / trials;
    }
}
