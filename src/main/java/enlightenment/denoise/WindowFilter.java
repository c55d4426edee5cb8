package enlightenment.denoise;

import java.util.Arrays;

/**
 * Nonlocal means in square windows, with three widths at once: weights fall with how much patches of light differ beyond their noise, and
 * with how much surfaces differ.
 *
 * <p>Sources: Rousselle, Manzi and Zwicker, "Robust denoising using feature and color information" (2013), for distances of patches
 * relative to their variance and joint weights; the kernel is (1 − d/4)⁴ in place of exp(−d), so that no transcendental function decides.
 */
final class WindowFilter {
    /** Columns and rows of a window on each side of its pixel. */
    static final int RADIUS = 6;

    /** Within this distance from the middle a window has all pixels. */
    private static final int DENSE = 3;

    /** Pixels on each side of a patch. */
    static final int PATCH = 2;

    /** Pixels from one column or row to the next in windows of light that has been filtered: nearly as many as such windows had before. */
    static final int STEP = 5;

    /** The margin that windows of patches need. */
    static final int MARGIN = RADIUS * STEP + PATCH;

    /** Rows that are filtered together: what they need stays in the cache. */
    static final int ROWS = 16;

    /** How far light that has been filtered may differ. */
    static final float[] WIDTH_AGAIN = {2f};

    /** How far the picture's light may differ, in squared standard deviations of its noise; from narrow to wide. */
    static final float[] WIDTHS = {0.5f, 2f, 16f};

    /** Squared difference of unit normals that weighs as much as one unit of distance. */
    private static final float NORMAL = 0.1f;

    /** Squared sine of the angle between a surface and the way to another point. */
    private static final float PLANE = 0.02f;

    /** Squared difference of albedo. */
    private static final float ALBEDO = 0.01f;

    private final Guide guide;
    private final Grid grid;

    /** Pixels from one column or row of a window to the next. */
    private final int step;

    private final float[] widths;
    private final FilteredLight[] out;

    /** Of the rows of this strip, with those that patches need. */
    private final float[] ratios;

    private final float[] columns;
    private final float[] sums;
    private final float[] surfaces;
    private final float[] weights;
    private final float[][] totals;

    /**
     * @param step pixels from one column or row of a window to the next
     * @param out gets the light for each of the widths
     */
    WindowFilter(Guide guide, int step, float[] widths, FilteredLight[] out) {
        this.guide = guide;
        this.step = step;
        this.widths = widths;
        this.out = out;
        totals = new float[widths.length][];
        grid = guide.grid;
        ratios = new float[grid.stride() * (ROWS + 2 * PATCH)];
        columns = new float[ratios.length];
        sums = new float[grid.stride()];
        surfaces = new float[grid.stride()];
        weights = new float[grid.stride()];
        for (int k = 0; k < totals.length; k++) {
            totals[k] = new float[grid.stride() * ROWS];
        }
    }

    /** The number of strips of a picture. */
    static int strips(Grid grid) {
        return (grid.height() + ROWS - 1) / ROWS;
    }

    /** Filters a strip of rows, by its number from the top. */
    void filter(int strip) {
        int top = strip * ROWS;
        int rows = Math.min(ROWS, grid.height() - top);
        for (float[] total : totals) {
            Arrays.fill(total, 0);
        }
        for (int dy = -RADIUS; dy <= RADIUS; dy++) {
            for (int dx = -RADIUS; dx <= RADIUS; dx++) {
                if (isInWindow(dx, dy)) {
                    add(top, rows, step * (dy * grid.stride() + dx));
                }
            }
        }
        for (int y = 0; y < rows; y++) {
            for (int k = 0; k < widths.length; k++) {
                out[k].divide(grid.index(0, top + y), grid.width(), totals[k], y * grid.stride());
            }
        }
    }

    /**
     * Windows are disks: in the middle all pixels, further off every second, as on a checkerboard. Its colour changes from the upper half
     * to the lower: pixels of one colour alone would show as a pattern.
     */
    static boolean isInWindow(int dx, int dy) {
        int squares = dx * dx + dy * dy;
        int half = dy < 0 || dy == 0 && dx < 0 ? 1 : 0;
        return squares <= DENSE * DENSE || squares <= RADIUS * RADIUS + RADIUS && ((dx + dy + half) & 1) == 0;
    }

    /** Adds the pixels at an offset of all pixels of a strip. */
    private void add(int top, int rows, int offset) {
        for (int y = -PATCH; y < rows + PATCH; y++) {
            compare(grid.index(-PATCH, top + y), offset, (y + PATCH) * grid.stride());
            sumColumns((y + PATCH) * grid.stride());
        }
        for (int y = 0; y < rows; y++) {
            int first = grid.index(0, top + y);
            sumRows(y);
            compareSurfaces(first, offset);
            for (int k = 0; k < widths.length; k++) {
                weigh(1 / widths[k], first, offset, totals[k], y * grid.stride());
                out[k].add(guide, first, offset, grid.width(), weights);
            }
        }
    }

    /** Squared differences of light beyond what noise makes, relative to the noise; mean of the bands. */
    private void compare(int first, int offset, int to) {
        int count = grid.width() + 2 * PATCH;
        float[] result = ratios;
        Arrays.fill(result, to, to + count, 0);
        float share = 1f / (3 * (2 * PATCH + 1) * (2 * PATCH + 1));
        for (int c = 0; c < 3; c++) {
            float[] light = guide.light[c];
            float[] variance = guide.variance[c];
            float[] deviation = guide.deviation[c];
            int other = first + offset;
            for (int i = 0; i < count; i++) {
                float d = light[first + i] - light[other + i];
                float v = variance[first + i];
                float w = variance[other + i];
                result[to + i] +=
                        share * (d * d - (v + Math.min(v, w))) / (deviation[first + i] + deviation[other + i]);
            }
        }
    }

    /** Sums the ratios of a row within the columns of patches. */
    private void sumColumns(int from) {
        int width = grid.width();
        float[] result = columns;
        Arrays.fill(result, from, from + width, 0);
        for (int q = 0; q <= 2 * PATCH; q++) {
            for (int i = from; i < from + width; i++) {
                result[i] += ratios[i + q];
            }
        }
    }

    /** Sums what rows have within the rows of patches. */
    private void sumRows(int y) {
        int width = grid.width();
        float[] result = sums;
        Arrays.fill(result, 0, width, 0);
        for (int r = y; r <= y + 2 * PATCH; r++) {
            int from = r * grid.stride();
            for (int i = 0; i < width; i++) {
                result[i] += columns[from + i];
            }
        }
    }

    /** How far surfaces differ: by their normals, by how far one lies off the other's plane, by their albedo. */
    private void compareSurfaces(int first, int offset) {
        int other = first + offset;
        float[] result = surfaces;
        int width = grid.width();
        Arrays.fill(result, 0, width, 0);
        addDifference(guide.normal, first, other, 1 / NORMAL, result);
        addDifference(guide.albedo, first, other, 1 / ALBEDO, result);
        float[] nx = guide.normal[0];
        float[] ny = guide.normal[1];
        float[] nz = guide.normal[2];
        float[] px = guide.position[0];
        float[] py = guide.position[1];
        float[] pz = guide.position[2];
        for (int i = 0; i < width; i++) {
            float x = px[other + i] - px[first + i];
            float y = py[other + i] - py[first + i];
            float z = pz[other + i] - pz[first + i];
            float along = nx[first + i] * x + ny[first + i] * y + nz[first + i] * z;
            float squares = x * x + y * y + z * z;
            result[i] += along * along / (squares + Float.MIN_NORMAL) * (1 / PLANE);
        }
    }

    private void addDifference(float[][] planes, int first, int other, float scale, float[] result) {
        float[] a = planes[0];
        float[] b = planes[1];
        float[] c = planes[2];
        for (int i = 0; i < grid.width(); i++) {
            float x = a[other + i] - a[first + i];
            float y = b[other + i] - b[first + i];
            float z = c[other + i] - c[first + i];
            result[i] += scale * (x * x + y * y + z * z);
        }
    }

    /** Makes weights of distances, and adds them up. */
    private void weigh(float scale, int first, int offset, float[] total, int to) {
        float[] w = weights;
        float[] s = sums;
        float[] f = surfaces;
        float[] mask = guide.mask;
        float[] tolerated = guide.tolerated;
        float[] precision = guide.precision;
        int other = first + offset;
        for (int i = 0; i < grid.width(); i++) {
            float d = Math.max(s[i] * scale, 0) + f[i];
            float x = Math.max(1 - 0.25f * d, 0);
            float calm = Math.min(tolerated[first + i] * precision[other + i], 1);
            float value = mask[other + i] * calm * (x * x) * (x * x);
            w[i] = value;
            total[to + i] += value;
        }
    }
}
