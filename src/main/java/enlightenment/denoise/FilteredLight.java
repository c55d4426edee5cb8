package enlightenment.denoise;

/** The light that windows make of a picture, weighted means of its pixels. */
final class FilteredLight {
    /** Of each band. */
    final float[][] light = new float[3][];

    /** Half of the difference of what the two halves of the samples become. */
    final float[][] difference = new float[3][];

    /** The variance of the light, were pixels independent. */
    final float[][] variance = new float[3][];

    FilteredLight(Grid grid) {
        for (int c = 0; c < 3; c++) {
            light[c] = new float[grid.size()];
            difference[c] = new float[grid.size()];
            variance[c] = new float[grid.size()];
        }
    }

    /** Adds weighted pixels at an offset to a row of pixels. */
    void add(Guide guide, int first, int offset, int count, float[] weights) {
        for (int c = 0; c < 3; c++) {
            add(guide.light[c], light[c], first, offset, count, weights);
            add(guide.difference[c], difference[c], first, offset, count, weights);
            addSquared(guide.noise[c], variance[c], first, offset, count, weights);
        }
    }

    private static void add(float[] from, float[] to, int first, int offset, int count, float[] weights) {
        int other = first + offset;
        for (int i = 0; i < count; i++) {
            to[first + i] += weights[i] * from[other + i];
        }
    }

    private static void addSquared(float[] from, float[] to, int first, int offset, int count, float[] weights) {
        int other = first + offset;
        for (int i = 0; i < count; i++) {
            to[first + i] += weights[i] * weights[i] * from[other + i];
        }
    }

    /** Divides the sums of a row by their weights. */
    void divide(int first, int count, float[] totals, int from) {
        for (int i = 0; i < count; i++) {
            float total = totals[from + i];
            float share = total > 0 ? 1 / total : 0;
            for (int c = 0; c < 3; c++) {
                light[c][first + i] *= share;
                difference[c][first + i] *= share;
                variance[c][first + i] *= share * share;
            }
        }
    }

    /**
     * Blends light that was filtered in several ways; the variance as if their errors were the same.
     *
     * @param shares of each in each pixel, which add up to 1
     */
    static FilteredLight blend(Grid grid, FilteredLight[] filtered, float[][] shares) {
        FilteredLight blend = new FilteredLight(grid);
        for (int k = 0; k < filtered.length; k++) {
            for (int c = 0; c < 3; c++) {
                for (int i = 0; i < grid.size(); i++) {
                    blend.light[c][i] += shares[k][i] * filtered[k].light[c][i];
                    blend.difference[c][i] += shares[k][i] * filtered[k].difference[c][i];
                    blend.variance[c][i] += shares[k][i] * filtered[k].variance[c][i];
                }
            }
        }
        return blend;
    }
}
