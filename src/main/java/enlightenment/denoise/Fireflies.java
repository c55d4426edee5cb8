package enlightenment.denoise;

/**
 * Limits pixels that few bright samples made much brighter than all that is around them. Such a pixel would be spread over its window.
 *
 * <p>The limit is the mean of the neighbours and some of their standard deviations. What a pixel's own samples agree about stays: it is
 * not lowered by more than some standard deviations of its own mean.
 */
final class Fireflies {
    private static final int RADIUS = 2;

    /** Standard deviations of neighbours above their mean. */
    private static final double AROUND = 3;

    /** Standard deviations of the pixel's own mean. */
    private static final double OWN = 1;

    private final Guide guide;
    private final Grid grid;

    Fireflies(Guide guide) {
        this.guide = guide;
        grid = guide.grid;
    }

    void limit() {
        float[] factor = new float[grid.size()];
        for (int y = 0; y < grid.height(); y++) {
            for (int x = 0; x < grid.width(); x++) {
                factor[grid.index(x, y)] = (float) factor(x, y);
            }
        }
        for (int i = 0; i < factor.length; i++) {
            if (factor[i] > 0 && factor[i] < 1) {
                for (int c = 0; c < 3; c++) {
                    guide.light[c][i] *= factor[i];
                    guide.difference[c][i] *= factor[i];
                    guide.variance[c][i] *= factor[i] * factor[i];
                }
            }
        }
    }

    private double sum(int i) {
        return (double) guide.light[0][i] + guide.light[1][i] + guide.light[2][i];
    }

    /** What a pixel is to be multiplied by: 1 where it is no firefly. */
    private double factor(int x, int y) {
        int own = grid.index(x, y);
        double value = sum(own);
        double sum = 0;
        double squares = 0;
        int count = 0;
        for (int r = Math.max(y - RADIUS, 0); r <= Math.min(y + RADIUS, grid.height() - 1); r++) {
            for (int q = Math.max(x - RADIUS, 0); q <= Math.min(x + RADIUS, grid.width() - 1); q++) {
                int i = grid.index(q, r);
                if (i != own && guide.mask[i] > 0) {
                    double v = sum(i);
                    sum += v;
                    squares += v * v;
                    count++;
                }
            }
        }
        if (count == 0 || !(value > 0)) {
            return 1;
        }
        double mean = sum / count;
        double limit = mean + AROUND * Math.sqrt(Math.max(squares / count - mean * mean, 0));
        double deviation = 0;
        for (int c = 0; c < 3; c++) {
            deviation += Math.sqrt(guide.variance[c][own]);
        }
        limit = Math.max(limit, value - OWN * deviation);
        return limit < value ? limit / value : 1;
    }
}
