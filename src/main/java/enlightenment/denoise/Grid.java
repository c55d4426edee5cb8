package enlightenment.denoise;

/**
 * Places of a picture's pixels in arrays with a margin on all sides, so that windows never leave the array.
 *
 * @param width of the picture in pixels
 * @param height of the picture in pixels
 * @param margin pixels on each side
 */
record Grid(int width, int height, int margin) {
    /** The distance of two rows in an array. */
    int stride() {
        return width + 2 * margin;
    }

    /** The length of an array. */
    int size() {
        return Math.multiplyExact(stride(), height + 2 * margin);
    }

    /** The place of a pixel, which may lie in the margin. */
    int index(int x, int y) {
        return (y + margin) * stride() + x + margin;
    }

    /** Fills the margin with the nearest pixels of the picture. */
    void extend(float[] plane) {
        for (int y = 0; y < height; y++) {
            int first = index(0, y);
            for (int x = 1; x <= margin; x++) {
                plane[first - x] = plane[first];
                plane[first + width - 1 + x] = plane[first + width - 1];
            }
        }
        for (int y = 1; y <= margin; y++) {
            System.arraycopy(plane, index(-margin, 0), plane, index(-margin, -y), stride());
            System.arraycopy(plane, index(-margin, height - 1), plane, index(-margin, height - 1 + y), stride());
        }
    }

    /**
     * The mean over squares of (2 · radius + 1)² pixels, by columns after rows; the margin is extended before and after.
     *
     * @param radius at most the margin
     */
    void blur(float[] plane, int radius) {
        extend(plane);
        float[] rows = new float[plane.length];
        float share = 1f / (2 * radius + 1);
        for (int y = -radius; y < height + radius; y++) {
            int first = index(0, y);
            for (int d = -radius; d <= radius; d++) {
                for (int i = first; i < first + width; i++) {
                    rows[i] += plane[i + d] * share;
                }
            }
        }
        for (int y = 0; y < height; y++) {
            int first = index(0, y);
            for (int i = first; i < first + width; i++) {
                plane[i] = 0;
            }
            for (int d = -radius * stride(); d <= radius * stride(); d += stride()) {
                for (int i = first; i < first + width; i++) {
                    plane[i] += rows[i + d] * share;
                }
            }
        }
        extend(plane);
    }

    /**
     * Half of each pixel and half of the mean over its square of 3 × 3 pixels without the two largest of them: what single pixels stand
     * out by is not spread. The margin is extended before and after.
     */
    void calm(float[] plane) {
        extend(plane);
        float[] from = plane.clone();
        for (int y = 0; y < height; y++) {
            for (int x = 0; x < width; x++) {
                int own = index(x, y);
                plane[own] = 0.5f * (from[own] + meanOfLower(from, own));
            }
        }
        extend(plane);
    }

    private float meanOfLower(float[] from, int own) {
        float sum = 0;
        float first = 0;
        float second = 0;
        for (int d = -stride(); d <= stride(); d += stride()) {
            for (int i = own + d - 1; i <= own + d + 1; i++) {
                float value = from[i];
                sum += value;
                second = Math.max(second, Math.min(first, value));
                first = Math.max(first, value);
            }
        }
        return Math.max(sum - first - second, 0) / 7;
    }
}
