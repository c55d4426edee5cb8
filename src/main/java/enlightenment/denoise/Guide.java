package enlightenment.denoise;

/**
 * A picture as planes with a margin: light without the texture of surfaces, how far it may be off, and what surfaces are.
 *
 * <p>Light is divided by albedo plus {@link #DARKEST}, so that textures are not smoothed with the light on them, and by the mean of the
 * picture, so that squares stay within the range of floats.
 */
final class Guide {
    /** Added to albedo: dark surfaces reflect most of their light at their coats, whose colour is not the albedo. */
    private static final float DARKEST = 0.1f;

    /** Pixels that are brighter by this factor than the mean are left as they are: their squares would overflow. */
    private static final double BRIGHTEST = 1e12;

    /** How much more variance than a pixel and its calmer neighbours have others may bring. */
    private static final float TOLERANCE = 8;

    /** Relative deviation that counts as rounding. */
    private static final float ROUNDING = 1f / (1 << 20);

    /** No pixel counts for more than this excess. */
    private static final double MOST_EXCESS = 100;

    final Grid grid;

    /** Light of each band, and half of the difference of the two halves of the samples. */
    final float[][] light = new float[3][];

    final float[][] difference = new float[3][];

    /** Variance of the light of each band, of each pixel by itself; smoothed; and that with what rounding makes. */
    final float[][] noise = new float[3][];

    final float[][] variance = new float[3][];

    final float[][] deviation = new float[3][];
    final float[][] albedo = new float[3][];
    final float[][] normal = new float[3][];
    final float[][] position = new float[3][];

    /** The most variance, of all bands together, that a pixel lets others bring; and what another brings, as its reciprocal. */
    final float[] tolerated;

    final float[] precision;

    /** 1 where a pixel may be used, 0 outside of the picture and where light is no number. */
    final float[] mask;

    private final double mean;

    Guide(NoisyPicture picture, int margin) {
        grid = new Grid(picture.width(), picture.height(), margin);
        mask = new float[grid.size()];
        tolerated = new float[grid.size()];
        precision = new float[grid.size()];
        mean = mean(picture.light());
        for (int c = 0; c < 3; c++) {
            light[c] = new float[grid.size()];
            difference[c] = new float[grid.size()];
            variance[c] = new float[grid.size()];
            albedo[c] = plane(picture.albedo(), c);
            normal[c] = plane(picture.normal(), c);
            position[c] = plane(picture.position(), c);
        }
        for (int y = 0; y < picture.height(); y++) {
            for (int x = 0; x < picture.width(); x++) {
                read(picture, y * picture.width() + x, grid.index(x, y));
            }
        }
        new Fireflies(this).limit();
        finish(1);
    }

    /** Surfaces of another guide, with light that was filtered. */
    Guide(Guide of, FilteredLight filtered) {
        grid = of.grid;
        mask = of.mask;
        mean = of.mean;
        tolerated = new float[grid.size()];
        precision = new float[grid.size()];
        float excess = (float) of.excess(filtered);
        for (int c = 0; c < 3; c++) {
            light[c] = filtered.light[c];
            difference[c] = filtered.difference[c];
            variance[c] = filtered.variance[c];
            albedo[c] = of.albedo[c];
            normal[c] = of.normal[c];
            position[c] = of.position[c];
            for (int i = 0; i < grid.size(); i++) {
                variance[c][i] *= excess;
            }
        }
        finish(0);
    }

    /**
     * By how much the squared differences of halves exceed the variance of independent pixels: methods that share paths make pixels err
     * together.
     */
    private double excess(FilteredLight filtered) {
        double sum = 0;
        long count = 0;
        for (int i = 0; i < grid.size(); i++) {
            double squares = 0;
            double variances = 0;
            for (int c = 0; c < 3; c++) {
                squares += (double) filtered.difference[c][i] * filtered.difference[c][i];
                variances += filtered.variance[c][i];
            }
            if (mask[i] > 0 && variances > 0) {
                sum += Math.min(squares / variances, MOST_EXCESS);
                count++;
            }
        }
        return count > 0 ? sum / count : 1;
    }

    /** Prepares what compares pixels, with variances that are smoothed over squares of this radius. */
    private void finish(int radius) {
        limitNoise();
        for (int c = 0; c < 3; c++) {
            grid.extend(light[c]);
            grid.extend(difference[c]);
            noise[c] = radius == 0 ? variance[c] : variance[c].clone();
            grid.extend(noise[c]);
            grid.blur(variance[c], radius);
            deviation[c] = new float[grid.size()];
            for (int i = 0; i < deviation[c].length; i++) {
                deviation[c][i] = variance[c][i] + ROUNDING * light[c][i] * (ROUNDING * light[c][i]) + Float.MIN_NORMAL;
            }
        }
    }

    /** Before the variance is smoothed: beside a lamp, a pixel without noise has nothing of the noise of the lamp's border. */
    private void limitNoise() {
        for (int i = 0; i < tolerated.length; i++) {
            tolerated[i] = variance[0][i] + variance[1][i] + variance[2][i];
            precision[i] = 1 / (tolerated[i] + Float.MIN_NORMAL);
        }
        grid.extend(precision);
        grid.calm(tolerated);
        for (int i = 0; i < tolerated.length; i++) {
            tolerated[i] = TOLERANCE * (tolerated[i] + Float.MIN_NORMAL);
        }
    }

    private static double mean(float[] light) {
        double sum = 0;
        long count = 0;
        for (float value : light) {
            if (Float.isFinite(value)) {
                sum += Math.abs(value);
                count++;
            }
        }
        return sum > 0 ? sum / count : 1;
    }

    private float[] plane(float[] numbers, int c) {
        float[] plane = new float[grid.size()];
        for (int y = 0; y < grid.height(); y++) {
            for (int x = 0; x < grid.width(); x++) {
                float value = numbers[3 * (y * grid.width() + x) + c];
                plane[grid.index(x, y)] = Float.isFinite(value) ? value : 0;
            }
        }
        grid.extend(plane);
        return plane;
    }

    private void read(NoisyPicture picture, int pixel, int i) {
        float[] quarters = picture.quarters();
        boolean usable = true;
        for (int k = 0; k < 3; k++) {
            usable &= Math.abs(picture.light()[3 * pixel + k]) < BRIGHTEST * mean;
        }
        for (int k = 0; k < 12; k++) {
            usable &= Math.abs(quarters[12 * pixel + k]) < BRIGHTEST * mean;
        }
        if (!usable) {
            return;
        }
        mask[i] = 1;
        for (int c = 0; c < 3; c++) {
            double scale = 1 / scale(c, i);
            double m = picture.light()[3 * pixel + c];
            double squares = 0;
            int k = 12 * pixel + c;
            double center = (quarters[k] + (double) quarters[k + 3] + quarters[k + 6] + quarters[k + 9]) / 4;
            for (int q = 0; q < 4; q++) {
                double off = quarters[k + 3 * q] - center;
                squares += off * off;
            }
            double half = ((double) quarters[k] + quarters[k + 3] - quarters[k + 6] - quarters[k + 9]) / 4;
            light[c][i] = (float) (m * scale);
            difference[c][i] = (float) (half * scale);
            variance[c][i] = (float) (squares / 12 * scale * scale);
        }
    }

    /** What the light of a plane is multiplied by to be that of the picture. */
    double scale(int c, int i) {
        return mean * (Math.max(albedo[c][i], 0) + DARKEST);
    }
}
