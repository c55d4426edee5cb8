package enlightenment.importer.pbrt;

import enlightenment.color.Rgb;
import java.util.Locale;
import java.util.Optional;

/** The colour spaces of pbrt's RGB values; white goes to white. */
enum ColorSpace {
    SRGB(1, 0, 0, 0, 1, 0, 0, 0, 1),

    /** Display P3, whose white is D65 (SMPTE EG 432-1). */
    DCI_P3(1.2249401, -0.2249404, 0, -0.0420569, 1.0420571, 0, -0.0196376, -0.0786361, 1.0982735),

    /** ITU-R BT.2020. */
    REC2020(1.6604910, -0.5876411, -0.0728499, -0.1245505, 1.1328999, -0.0083494, -0.0181508, -0.1005789, 1.1187297),

    /** SMPTE ST 2065-1, its white adapted to D65 by Bradford's matrix. */
    ACES2065_1(2.5216862, -1.1341310, -0.3875552, -0.2764799, 1.3727191, -0.0962392, -0.0153781, -0.1529754, 1.1683535);

    private final double[] toSrgb;

    ColorSpace(double... toSrgb) {
        this.toSrgb = toSrgb;
    }

    static Optional<ColorSpace> of(String name) {
        for (ColorSpace space : values()) {
            if (space.name().equals(name.toUpperCase(Locale.ROOT).replace('-', '_'))) {
                return Optional.of(space);
            }
        }
        return Optional.empty();
    }

    /** These numbers in linear sRGB; negative components become 0. */
    Rgb rgb(double r, double g, double b) {
        return new Rgb(row(0, r, g, b), row(3, r, g, b), row(6, r, g, b));
    }

    private double row(int first, double r, double g, double b) {
        return Math.max(0, toSrgb[first] * r + toSrgb[first + 1] * g + toSrgb[first + 2] * b);
    }
}
