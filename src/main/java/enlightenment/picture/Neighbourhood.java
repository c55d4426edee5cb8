package enlightenment.picture;

/** Means over the 3×3 pixels around each: what a single pixel can only guess, such as its variance, its neighbours confirm. */
public final class Neighbourhood {
    private Neighbourhood() {}

    /**
     * The mean around one pixel.
     *
     * @param values width·height numbers, row by row; NaN where there is none
     * @param x column in 0..width − 1
     * @param y row in 0..height − 1
     * @return the mean of those that there are; +∞ where there is none
     */
    public static double mean(float[] values, int width, int height, int x, int y) {
        double sum = 0;
        int n = 0;
        for (int row = Math.max(y - 1, 0); row <= Math.min(y + 1, height - 1); row++) {
            for (int column = Math.max(x - 1, 0); column <= Math.min(x + 1, width - 1); column++) {
                float value = values[row * width + column];
                if (!Float.isNaN(value)) {
                    sum += value;
                    n++;
                }
            }
        }
        return n == 0 ? Double.POSITIVE_INFINITY : sum / n;
    }
}
