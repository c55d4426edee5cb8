package enlightenment.denoise;

/** The light that windows of one width make of a picture: its mean, and half of the difference of what the halves of the samples make. */
final class FilteredLight {
    final float[][] light = new float[3][];
    final float[][] difference = new float[3][];

    FilteredLight(Grid grid) {
        for (int c = 0; c < 3; c++) {
            light[c] = new float[grid.size()];
            difference[c] = new float[grid.size()];
        }
    }

    /** Adds weighted pixels at an offset to a row of pixels. */
    void add(Guide guide, int first, int offset, int count, float[] weights) {
        for (int c = 0; c < 3; c++) {
            add(guide.light[c], light[c], first, offset, count, weights);
            add(guide.difference[c], difference[c], first, offset, count, weights);
        }
    }

    private static void add(float[] from, float[] to, int first, int offset, int count, float[] weights) {
        int other = first + offset;
        for (int i = 0; i < count; i++) {
            to[first + i] += weights[i] * from[other + i];
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
            }
        }
    }
}
