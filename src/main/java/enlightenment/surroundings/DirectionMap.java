package enlightenment.surroundings;

import enlightenment.codec.Raster;
import enlightenment.color.Rgb;
import enlightenment.color.TransferCurve;
import java.io.IOException;

/**
 * Radiance by direction: rows of texels at equal angles from the zenith, in each row texels at equal angles around the vertical, bilinear
 * between their centres. Rows cover all directions or those above the horizon; below that the radiance is one everywhere then.
 * Immutable.
 */
final class DirectionMap {
    final int width;
    final int height;

    /** The angle from the zenith that the rows end at: π or π/2. */
    final double span;

    /** Three numbers for each texel, from the zenith down. */
    final float[] rgb;

    /** What comes from below the rows. */
    final Rgb below;

    DirectionMap(int width, int height, boolean isHalf, float[] rgb, Rgb below) {
        this.width = width;
        this.height = height;
        this.span = isHalf ? Math.PI / 2 : Math.PI;
        this.rgb = rgb;
        this.below = below;
    }

    /**
     * Of a picture whose upper edge is the zenith and whose lower edge is the nadir.
     *
     * @param scale by which its light is multiplied, by band
     * @param isLight whether whole numbers are proportional to light; floats always are
     * @throws IOException if one of its numbers is no radiance, or there is not enough memory
     */
    static DirectionMap of(Raster raster, Rgb scale, boolean isLight) throws IOException {
        float[] rgb = Raster.allocate(
                raster.width(), raster.height(), 12, () -> new float[3 * raster.width() * raster.height()]);
        float[] from = raster.components();
        double[] factor = {scale.r(), scale.g(), scale.b()};
        boolean decodes = !isLight && raster.floats() == null;
        double[] decoded = new double[256];
        for (int i = 0; decodes && i < decoded.length; i++) {
            decoded[i] = TransferCurve.decode(i / 255.0);
        }
        for (int i = 0; i < rgb.length; i++) {
            double value = !decodes
                    ? from[i]
                    : raster.packed() != null ? decoded[Math.round(from[i] * 255)] : TransferCurve.decode(from[i]);
            double radiance = factor[i % 3] == 0 ? 0 : value * factor[i % 3];
            if (!(radiance <= Float.MAX_VALUE)) {
                int texel = i / 3;
                throw new IOException("the number " + from[i] + " in column " + texel % raster.width() + ", row "
                        + texel / raster.width() + " is no radiance");
            }
            // Small negative numbers are what conversions between colour spaces leave.
            rgb[i] = (float) Math.max(0, radiance);
        }
        return new DirectionMap(raster.width(), raster.height(), false, rgb, Rgb.BLACK);
    }

    /**
     * The same with less light.
     *
     * @param share what is left, by band
     * @throws IOException if there is not enough memory
     */
    DirectionMap filtered(Rgb share) throws IOException {
        float[] left = Raster.allocate(width, height, 12, () -> new float[rgb.length]);
        float[] factor = {(float) share.r(), (float) share.g(), (float) share.b()};
        for (int i = 0; i < left.length; i++) {
            left[i] = factor[i % 3] * rgb[i];
        }
        return new DirectionMap(width, height, span < Math.PI, left, below.times(share));
    }

    /**
     * Looks up the radiance of a direction.
     *
     * @param turn around the vertical, in whole turns, 0..1: 0 and 1 are the left and the right edge
     * @param angle from the zenith, in radians
     * @param isBelow whether the direction leads below the horizon
     */
    void radiance(double turn, double angle, boolean isBelow, double[] out) {
        if (isBelow && span < Math.PI) {
            out[0] = below.r();
            out[1] = below.g();
            out[2] = below.b();
            return;
        }
        double x = turn * width - 0.5;
        double y = angle / span * height - 0.5;
        double left = Math.floor(x);
        double top = Math.floor(y);
        double fx = x - left;
        double fy = y - top;
        int x0 = (int) left;
        int x1 = x0 + 1;
        x0 = x0 < 0 ? width - 1 : Math.min(x0, width - 1);
        x1 = x1 >= width ? 0 : x1;
        int row0 = Math.min(Math.max((int) top, 0), height - 1) * width;
        int row1 = Math.min(Math.max((int) top + 1, 0), height - 1) * width;
        for (int c = 0; c < 3; c++) {
            double above = mix(rgb[3 * (row0 + x0) + c], rgb[3 * (row0 + x1) + c], fx);
            double under = mix(rgb[3 * (row1 + x0) + c], rgb[3 * (row1 + x1) + c], fx);
            out[c] = mix(above, under, fy);
        }
    }

    private static double mix(double a, double b, double t) {
        return a + t * (b - a);
    }

    /** A texel's numbers added up: what directions are chosen by. */
    private double brightness(int x, int y) {
        int i = 3 * (y * width + x);
        return (double) rgb[i] + rgb[i + 1] + rgb[i + 2];
    }

    /** The mean brightness of what {@link #radiance} makes of a texel: an eighth of each neighbour's by row, and by column. */
    double meanBrightness(int x, int y) {
        double sum = 0;
        for (int dy = -1; dy <= 1; dy++) {
            int row = Math.min(Math.max(y + dy, 0), height - 1);
            double around = brightness(x == 0 ? width - 1 : x - 1, row)
                    + 6 * brightness(x, row)
                    + brightness(x + 1 == width ? 0 : x + 1, row);
            sum += (dy == 0 ? 6 : 1) * around;
        }
        return sum / 64;
    }

    /** The cosine of the angle from the zenith at which a row begins. */
    double cosine(int row) {
        double part = (double) row / height;
        if (part == 1) {
            return span == Math.PI ? -1 : 0;
        }
        return StrictMath.cos(part * span);
    }
}
