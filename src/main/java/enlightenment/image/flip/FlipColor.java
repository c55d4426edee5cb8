package enlightenment.image.flip;

import enlightenment.codec.PngWriter;
import enlightenment.colorimetry.TransferCurve;
import enlightenment.image.Image;

/**
 * The colour spaces of ꟻLIP (section 4.1 of its paper): sRGB, the linear opponent space YCxCz that the eye's filters work
 * in, and CIELAB with Hunt's effect, in which differences are measured.
 */
final class FlipColor {
    /** Linear sRGB to CIE XYZ for the illuminant D65, with the rounding of the reference implementation. */
    private static final double[] TO_XYZ = {
        10135552 / 24577794.0, 8788810 / 24577794.0, 4435075 / 24577794.0,
        2613072 / 12288897.0, 8788810 / 12288897.0, 887015 / 12288897.0,
        1425312 / 73733382.0, 8788810 / 73733382.0, 70074185 / 73733382.0
    };

    private static final double[] FROM_XYZ = inverse(TO_XYZ);

    private static final double WHITE_X = TO_XYZ[0] + TO_XYZ[1] + TO_XYZ[2];
    private static final double WHITE_Y = TO_XYZ[3] + TO_XYZ[4] + TO_XYZ[5];
    private static final double WHITE_Z = TO_XYZ[6] + TO_XYZ[7] + TO_XYZ[8];

    /** Where CIELAB's cube root gives way to a line: (6/29)³. */
    private static final double LINE_BELOW = 216.0 / 24389.0;

    /** The steps of an 8-bit picture in linear light, and as they are stored: most pictures have no other values. */
    private static final double[] LINEAR = new double[256];

    private static final float[] STORED = new float[256];

    static {
        for (int i = 0; i < 256; i++) {
            STORED[i] = (float) (i / 255.0);
            LINEAR[i] = TransferCurve.decode(STORED[i]);
        }
    }

    private FlipColor() {}

    /** Writes relative luminance, Cx and Cz of a row of the image. What cannot be displayed is clipped first. */
    static void toOpponent(Image image, int row, double[] luminance, double[] cx, double[] cz) {
        for (int x = 0; x < image.width(); x++) {
            double r = decode(image.displayed(x, row, 0));
            double g = decode(image.displayed(x, row, 1));
            double b = decode(image.displayed(x, row, 2));
            double relativeX = dot(TO_XYZ, 0, r, g, b) / WHITE_X;
            double relativeY = dot(TO_XYZ, 3, r, g, b) / WHITE_Y;
            double relativeZ = dot(TO_XYZ, 6, r, g, b) / WHITE_Z;
            luminance[x] = relativeY;
            cx[x] = 500 * (relativeX - relativeY);
            cz[x] = 200 * (relativeY - relativeZ);
        }
    }

    /**
     * Replaces a row of relative luminance, Cx and Cz by L*, a* and b*, the latter two scaled by a hundredth of L*: the lighter a
     * colour, the more of it is seen (Hunt's effect).
     */
    static void toHuntLab(double[] luminance, double[] cx, double[] cz) {
        double[] lab = new double[3];
        for (int x = 0; x < luminance.length; x++) {
            double relativeX = luminance[x] + cx[x] / 500;
            double relativeZ = luminance[x] - cz[x] / 200;
            double fromX = relativeX * WHITE_X;
            double fromY = luminance[x] * WHITE_Y;
            double fromZ = relativeZ * WHITE_Z;
            double r = clip(dot(FROM_XYZ, 0, fromX, fromY, fromZ));
            double g = clip(dot(FROM_XYZ, 3, fromX, fromY, fromZ));
            double b = clip(dot(FROM_XYZ, 6, fromX, fromY, fromZ));
            huntLab(r, g, b, lab);
            luminance[x] = lab[0];
            cx[x] = lab[1];
            cz[x] = lab[2];
        }
    }

    /** CIELAB with Hunt's effect of linear red, green and blue in 0..1. */
    static void huntLab(double r, double g, double b, double[] lab) {
        double fx = root(dot(TO_XYZ, 0, r, g, b) / WHITE_X);
        double fy = root(dot(TO_XYZ, 3, r, g, b) / WHITE_Y);
        double fz = root(dot(TO_XYZ, 6, r, g, b) / WHITE_Z);
        lab[0] = 116 * fy - 16;
        double hunt = 0.01 * lab[0];
        lab[1] = hunt * 500 * (fx - fy);
        lab[2] = hunt * 200 * (fy - fz);
    }

    private static double decode(float stored) {
        int step = PngWriter.quantize(stored, 255);
        return STORED[step] == stored ? LINEAR[step] : TransferCurve.decode(clip(stored));
    }

    /** HyAB: the lightness as in a city of square blocks, the chroma as the crow flies (Abasi, Tehran, Fairchild 2020). */
    static double distance(double lightness, double a, double b) {
        return Math.abs(lightness) + Math.sqrt(a * a + b * b);
    }

    private static double root(double t) {
        return t > LINE_BELOW ? StrictMath.cbrt(t) : t * (841.0 / 108.0) + 4.0 / 29.0;
    }

    private static double clip(double value) {
        return value < 0 ? 0 : value > 1 ? 1 : value;
    }

    private static double dot(double[] m, int row, double x, double y, double z) {
        return m[row] * x + m[row + 1] * y + m[row + 2] * z;
    }

    /** By Cramer's rule. */
    private static double[] inverse(double[] m) {
        double[] cofactors = new double[9];
        for (int i = 0; i < 3; i++) {
            for (int j = 0; j < 3; j++) {
                int i1 = 3 * ((i + 1) % 3);
                int i2 = 3 * ((i + 2) % 3);
                int j1 = (j + 1) % 3;
                int j2 = (j + 2) % 3;
                cofactors[3 * j + i] = m[i1 + j1] * m[i2 + j2] - m[i1 + j2] * m[i2 + j1];
            }
        }
        double determinant = m[0] * cofactors[0] + m[1] * cofactors[3] + m[2] * cofactors[6];
        for (int i = 0; i < 9; i++) {
            cofactors[i] /= determinant;
        }
        return cofactors;
    }
}
