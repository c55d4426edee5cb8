package enlightenment.surroundings;

import enlightenment.codec.Raster;
import enlightenment.color.Rgb;
import enlightenment.colorimetry.TransferCurve;
import enlightenment.math.InvalidValueException;
import enlightenment.numeric.Scale;
import java.io.IOException;

/**
 * Radiance by direction: rows of texels at equal angles from the zenith, in each row texels at equal angles around the vertical, bilinear
 * between their centres or constant in each. Rows cover all directions or those above the horizon; below that the radiance is one everywhere then.
 * Immutable.
 */
final class DirectionMap {
    /** Of light that is multiplied by less than this, floats would not have all their 24 digits down to 2⁻²⁴ of it. */
    private static final double DIMMEST = Math.scalb((double) Float.MIN_NORMAL, 24);

    final int width;
    final int height;

    /** The angle from the zenith that the rows end at: π or π/2. */
    final double span;

    /** Whether the radiance is constant in each texel. */
    private final boolean isNearest;

    /** Three numbers for each texel, from the zenith down, in {@link #unit}. */
    private final float[] rgb;

    /** A power of two: the radiance that is 1 in the texels. */
    private final double unit;

    /** What comes from below the rows. */
    final Rgb below;

    DirectionMap(int width, int height, boolean isHalf, boolean isNearest, float[] rgb, double unit, Rgb below) {
        this.width = width;
        this.height = height;
        this.span = isHalf ? Math.PI / 2 : Math.PI;
        this.isNearest = isNearest;
        this.rgb = rgb;
        this.unit = unit;
        this.below = below;
    }

    /** The unit for light that is multiplied by this: 1, unless floats had too few digits for it. */
    static double unit(Rgb scale) {
        double most = scale.max();
        return most == 0 || most >= DIMMEST ? 1 : Math.scalb(1.0, Scale.exponent(most));
    }

    /** What there is of light: what a picture or a sky has times a factor. */
    static float radiance(double value, double factor, String of) {
        double product = factor == 0 ? 0 : value * factor;
        if (product > Float.MAX_VALUE) {
            throw new InvalidValueException(
                    "radiance", "times the light of the " + of + " is beyond the range of floats, 3.4e38");
        }
        // Small negative numbers are what conversions between colour spaces leave.
        return (float) Math.max(0, product);
    }

    /**
     * Of a picture whose upper edge is the zenith and whose lower edge is the nadir.
     *
     * @param scale by which its light is multiplied, by band
     * @param texels what its numbers mean
     * @throws IOException if one of its numbers is no radiance, or there is not enough memory
     * @throws InvalidValueException (key {@code radiance}) if what it is multiplied by is too much
     */
    static DirectionMap of(Raster raster, Rgb scale, Surroundings.Texels texels) throws IOException {
        float[] rgb = Raster.allocate(
                raster.width(), raster.height(), 12, () -> new float[3 * raster.width() * raster.height()]);
        float[] from = raster.components();
        double unit = unit(scale);
        double[] factor = {scale.r() / unit, scale.g() / unit, scale.b() / unit};
        boolean decodes = !texels.areLight() && raster.floats() == null;
        double[] decoded = new double[256];
        for (int i = 0; decodes && i < decoded.length; i++) {
            decoded[i] = TransferCurve.decode(i / 255.0);
        }
        for (int i = 0; i < rgb.length; i++) {
            double value = !decodes
                    ? from[i]
                    : raster.packed() != null ? decoded[Math.round(from[i] * 255)] : TransferCurve.decode(from[i]);
            if (factor[i % 3] != 0 && !(value <= Float.MAX_VALUE)) {
                int texel = i / 3;
                throw new IOException("the number " + from[i] + " in column " + texel % raster.width() + ", row "
                        + texel / raster.width() + " is no radiance");
            }
            rgb[i] = radiance(value, factor[i % 3], "picture");
        }
        return new DirectionMap(raster.width(), raster.height(), false, texels.areNearest(), rgb, unit, Rgb.BLACK);
    }

    /**
     * This map with its radiance multiplied by a share.
     *
     * @param share the factor, by band
     * @throws IOException if there is not enough memory
     */
    DirectionMap filtered(Rgb share) throws IOException {
        float[] left = Raster.allocate(width, height, 12, () -> new float[rgb.length]);
        float[] factor = {(float) share.r(), (float) share.g(), (float) share.b()};
        for (int i = 0; i < left.length; i++) {
            left[i] = factor[i % 3] * rgb[i];
        }
        return new DirectionMap(width, height, span < Math.PI, isNearest, left, unit, below.times(share));
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
        if (isNearest) {
            int column = Math.min((int) (turn * width), width - 1);
            int row = Math.min((int) (angle / span * height), height - 1);
            copy(3 * (row * width + column), out);
            return;
        }
        interpolate(turn, angle, out);
    }

    private void copy(int i, double[] out) {
        out[0] = unit * rgb[i];
        out[1] = unit * rgb[i + 1];
        out[2] = unit * rgb[i + 2];
    }

    private void interpolate(double turn, double angle, double[] out) {
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
            out[c] = unit * mix(above, under, fy);
        }
    }

    private static double mix(double a, double b, double t) {
        return a + t * (b - a);
    }

    /** A texel's numbers added up: what directions are chosen by. */
    private double brightness(int x, int y) {
        int i = 3 * (y * width + x);
        return unit * ((double) rgb[i] + rgb[i + 1] + rgb[i + 2]);
    }

    /**
     * The mean brightness of what {@link #radiance} makes of a texel: its own, or with an eighth of each neighbour's by row, and by column.
     */
    double meanBrightness(int x, int y) {
        if (isNearest) {
            return brightness(x, y);
        }
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
