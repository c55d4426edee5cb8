package enlightenment.importer.pbrt;

import enlightenment.color.Color;
import enlightenment.color.Rgb;
import enlightenment.colorimetry.TransferCurve;
import enlightenment.image.Image;
import enlightenment.importer.support.Affine;
import enlightenment.importer.support.SpectrumRgb;
import enlightenment.math.Vec3;

/**
 * pbrt-v4's pictures of all directions: squares that an octahedron is unfolded to, in which equal areas are equal solid angles (P. Clarberg, "Fast
 * equal-area mapping of the (hemi)sphere using SIMD", 2008). +z is in the middle, the first row is at y = 0.
 */
final class EqualAreaMap {
    /** Samples along each side of a pixel. */
    private static final int SAMPLES = 3;

    private final Image square;
    private final boolean isEncoded;

    /** @param isEncoded whether its numbers are display-referred */
    EqualAreaMap(Image square, boolean isEncoded) {
        this.square = square;
        this.isEncoded = isEncoded;
    }

    /** The place of a direction in the square, 0..1 each. */
    static double[] place(Vec3 direction) {
        Vec3 d = direction.normalized();
        double x = Math.abs(d.x());
        double y = Math.abs(d.y());
        double r = StrictMath.sqrt(Math.max(0, 1 - Math.abs(d.z())));
        double larger = Math.max(x, y);
        double phi = larger == 0 ? 0 : StrictMath.atan(Math.min(x, y) / larger) * 2 / StrictMath.PI;
        if (x < y) {
            phi = 1 - phi;
        }
        double v = phi * r;
        double u = r - v;
        if (d.z() < 0) {
            double swapped = 1 - u;
            u = 1 - v;
            v = swapped;
        }
        return new double[] {(Math.copySign(u, d.x()) + 1) / 2, (Math.copySign(v, d.y()) + 1) / 2};
    }

    /** The direction of a place in the square: the inverse of {@link #place}. */
    static Vec3 direction(double px, double py) {
        double u = 2 * px - 1;
        double v = 2 * py - 1;
        double inside = 1 - (Math.abs(u) + Math.abs(v));
        double r = 1 - Math.abs(inside);
        double phi = (r == 0 ? 1 : (Math.abs(v) - Math.abs(u)) / r + 1) * StrictMath.PI / 4;
        double across = r * StrictMath.sqrt(Math.max(0, 2 - r * r));
        return new Vec3(
                Math.copySign(StrictMath.cos(phi) * across, u),
                Math.copySign(StrictMath.sin(phi) * across, v),
                Math.copySign(1 - r * r, inside));
    }

    private double component(int x, int y, int band) {
        double v = square.component(x, y, band);
        double light = isEncoded ? TransferCurve.decode(v) : v;
        return light > 0 && light < Double.POSITIVE_INFINITY ? light : 0;
    }

    /** The illuminance of a surface that faces +z: π under a white sky. */
    double illuminance() {
        double sum = 0;
        for (int y = 0; y < square.height(); y++) {
            for (int x = 0; x < square.width(); x++) {
                double z = direction((x + 0.5) / square.width(), (y + 0.5) / square.height())
                        .z();
                sum += Math.max(0, z)
                        * SpectrumRgb.luminance(new Rgb(component(x, y, 0), component(x, y, 1), component(x, y, 2)));
            }
        }
        return 4 * StrictMath.PI * sum / ((double) square.width() * square.height());
    }

    /**
     * The picture by longitude and latitude that scenes have for surroundings: +y is at the upper edge, +z in the middle column, +x to its right.
     *
     * @param toWorld from the map's directions to those of the scene
     */
    Image byLongitude(Affine toWorld) {
        Affine toMap = toWorld.inverse();
        int height = square.height();
        int width = 2 * height;
        float[] rgb = new float[3 * width * height];
        for (int y = 0; y < height; y++) {
            for (int x = 0; x < width; x++) {
                for (int s = 0; s < SAMPLES * SAMPLES; s++) {
                    double u = (x + (s % SAMPLES + 0.5) / SAMPLES) / width;
                    double v = (y + (s / SAMPLES + 0.5) / SAMPLES) / height;
                    double[] at = place(toMap.vector(seen(u, v)));
                    int column = Math.min((int) (at[0] * square.width()), square.width() - 1);
                    int row = Math.min((int) (at[1] * height), height - 1);
                    for (int c = 0; c < 3; c++) {
                        rgb[3 * (y * width + x) + c] += (float) (component(column, row, c) / (SAMPLES * SAMPLES));
                    }
                }
            }
        }
        return new Image(width, height, rgb, Color.Encoding.LINEAR);
    }

    private static Vec3 seen(double u, double v) {
        double azimuth = (2 * u - 1) * StrictMath.PI;
        double polar = v * StrictMath.PI;
        double across = StrictMath.sin(polar);
        return new Vec3(StrictMath.sin(azimuth) * across, StrictMath.cos(polar), StrictMath.cos(azimuth) * across);
    }
}
