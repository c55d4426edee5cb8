package enlightenment.world.material;

import java.util.Arrays;

/**
 * The roughness levels of a surface with textured roughness: each has tables of its own, so there are few, and every point has one of the
 * two next to its own roughness, at random with the right mean. The two of a checkerboard are exact; for images they are among
 * {@value #STEPS} + 1 that are even in 0..1. Immutable.
 *
 * @param low the first roughness
 * @param step from each to the next; 0 if there is one
 * @param count the number of levels, at least 1
 */
public record RoughnessLevels(double low, double step, int count) {
    /** The steps between 0 and 1: from a roughness of a third on, α differs by less than a tenth between neighbours. */
    private static final int STEPS = 63;

    /** The levels that cover the numbers of a texture. */
    public static RoughnessLevels of(AmountLookup amount) {
        double[] range = {Double.POSITIVE_INFINITY, Double.NEGATIVE_INFINITY};
        amount.map().forEachColor(rgb -> {
            double value = amount.of(rgb);
            range[0] = Math.min(range[0], value);
            range[1] = Math.max(range[1], value);
        });
        double least = clamped(range[0]);
        double most = clamped(range[1]);
        if (least == most || !amount.map().hasImage()) {
            return new RoughnessLevels(least, most - least, least == most ? 1 : 2);
        }
        int first = (int) Math.floor(least * STEPS);
        int last = (int) Math.ceil(most * STEPS);
        return new RoughnessLevels((double) first / STEPS, 1.0 / STEPS, last - first + 1);
    }

    private static double clamped(double value) {
        return Math.min(Math.max(value, 0), 1);
    }

    /** All levels in order. */
    public double[] all() {
        double[] all = new double[count];
        Arrays.setAll(all, k -> clamped(low + k * step));
        return all;
    }

    /**
     * The index of a point's level.
     *
     * @param roughness of the texture there
     * @param number uniform in 0..1
     */
    int at(double roughness, double number) {
        if (count == 1) {
            return 0;
        }
        double x = Math.min(Math.max((roughness - low) / step, 0), count - 1);
        int k = Math.min((int) x, count - 2);
        return number < x - k ? k + 1 : k;
    }
}
