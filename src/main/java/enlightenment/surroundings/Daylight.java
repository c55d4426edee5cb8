package enlightenment.surroundings;

import enlightenment.color.Rgb;

/**
 * A clear sky and its sun, by A. Preetham, P. Shirley and B. Smits, "A practical analytic model for daylight" (SIGGRAPH 1999), appendices
 * 1 and 2: the luminance and chromaticity of each direction by R. Perez' formula, with coefficients that are linear in turbidity.
 * Immutable.
 *
 * <p>Radiance 1 is that of a white matte surface in an illuminance of 100,000 lx, which is about full daylight: 31,831 cd/m².
 */
public final class Daylight {
    /** The luminance of radiance 1, in cd/m². */
    public static final double UNIT = 100_000 / Math.PI;

    /** Half of the angle that the sun's disk is seen under, in degrees. */
    public static final double SUN_RADIUS = 0.265;

    private static final double KILO = 1000;

    /** Perez' A to E of luminance and of the chromaticities x and y: slope by turbidity, and value at turbidity 0. */
    private static final double[][] OF_LUMINANCE = {
        {0.1787, -1.4630}, {-0.3554, 0.4275}, {-0.0227, 5.3251}, {0.1206, -2.5771}, {-0.0670, 0.3703}
    };

    private static final double[][] OF_X = {
        {-0.0193, -0.2592}, {-0.0665, 0.0008}, {-0.0004, 0.2125}, {-0.0641, -0.8989}, {-0.0033, 0.0452}
    };

    private static final double[][] OF_Y = {
        {-0.0167, -0.2608}, {-0.0950, 0.0092}, {-0.0079, 0.2102}, {-0.0441, -1.6537}, {-0.0109, 0.0529}
    };

    /** Chromaticities at the zenith: rows by the powers 2, 1, 0 of turbidity, columns by the powers 3 to 0 of the sun's angle from it. */
    private static final double[][] ZENITH_X = {
        {0.00166, -0.00375, 0.00209, 0}, {-0.02903, 0.06377, -0.03202, 0.00394}, {0.11693, -0.21196, 0.06052, 0.25886}
    };

    private static final double[][] ZENITH_Y = {
        {0.00275, -0.00610, 0.00317, 0}, {-0.04214, 0.08970, -0.04153, 0.00516}, {0.15346, -0.26756, 0.06670, 0.26688}
    };

    /** XYZ to linear Rec. 709, of which the white is D65 (IEC 61966-2-1). */
    private static final double[][] TO_RGB = {
        {3.2404542, -1.5371385, -0.4985314}, {-0.9692660, 1.8760108, 0.0415560}, {0.0556434, -0.2040259, 1.0572252}
    };

    private final double turbidity;
    private final double elevation;

    /** The angle between sun and zenith. */
    private final double thetaSun;

    private final double[] luminance;
    private final double[] x;
    private final double[] y;

    /** Luminance and chromaticities at the zenith over what Perez' formula has there. */
    private final double ofLuminance;

    private final double ofX;
    private final double ofY;

    /**
     * The daylight of a sun.
     *
     * @param elevation of the sun above the horizon, in degrees: 0..90
     * @param turbidity how hazy the air is: 2 very clear, 3 clear, 6 hazy, 10 the most
     */
    public Daylight(double elevation, double turbidity) {
        this.turbidity = turbidity;
        this.elevation = elevation;
        thetaSun = StrictMath.toRadians(90 - elevation);
        luminance = coefficients(OF_LUMINANCE);
        x = coefficients(OF_X);
        y = coefficients(OF_Y);
        ofLuminance = zenithLuminance() / atZenith(luminance);
        ofX = polynomial(ZENITH_X) / atZenith(x);
        ofY = polynomial(ZENITH_Y) / atZenith(y);
    }

    private double[] coefficients(double[][] table) {
        double[] c = new double[table.length];
        for (int k = 0; k < c.length; k++) {
            c[k] = table[k][0] * turbidity + table[k][1];
        }
        return c;
    }

    private double atZenith(double[] c) {
        return perez(c, 1, thetaSun, StrictMath.cos(thetaSun));
    }

    private double polynomial(double[][] table) {
        double sum = 0;
        for (double[] row : table) {
            double polynomial = 0;
            for (double c : row) {
                polynomial = polynomial * thetaSun + c;
            }
            sum = sum * turbidity + polynomial;
        }
        return sum;
    }

    /** The luminance of the zenith, in cd/m². */
    public double zenithLuminance() {
        double chi = (4.0 / 9 - turbidity / 120) * (Math.PI - 2 * thetaSun);
        return KILO * ((4.0453 * turbidity - 4.9710) * StrictMath.tan(chi) - 0.2155 * turbidity + 2.4192);
    }

    private static double perez(double[] c, double cosine, double gamma, double cosineGamma) {
        return (1 + c[0] * StrictMath.exp(c[1] / cosine))
                * (1 + c[2] * StrictMath.exp(c[3] * gamma) + c[4] * cosineGamma * cosineGamma);
    }

    /** The luminance of a direction of the sky, in cd/m²: with the same parameters as {@link #sky}. */
    public double luminance(double cosine, double cosineGamma) {
        double gamma = StrictMath.acos(Math.max(-1, Math.min(1, cosineGamma)));
        return ofLuminance * perez(luminance, cosine, gamma, cosineGamma);
    }

    /**
     * The radiance of a direction of the sky, without the sun's disk.
     *
     * @param cosine of the angle between the direction and the zenith, greater than 0
     * @param cosineGamma of the angle between the direction and the sun
     * @param rgb receives the radiance, by band; what is outside of the gamut is clipped to 0
     */
    public void sky(double cosine, double cosineGamma, double[] rgb) {
        double gamma = StrictMath.acos(Math.max(-1, Math.min(1, cosineGamma)));
        double chromaX = ofX * perez(x, cosine, gamma, cosineGamma);
        double chromaY = ofY * perez(y, cosine, gamma, cosineGamma);
        double scaled = ofLuminance * perez(luminance, cosine, gamma, cosineGamma) / chromaY;
        rgb[0] = scaled * chromaX;
        rgb[1] = scaled * chromaY;
        rgb[2] = scaled * (1 - chromaX - chromaY);
        toRgb(rgb);
    }

    /** The radiance of the sun's disk, the same all over it. */
    public Rgb sun() {
        double[] rgb = new double[3];
        SunSpectrum.disk(turbidity, SunSpectrum.airMass(elevation), rgb);
        toRgb(rgb);
        return new Rgb(rgb[0], rgb[1], rgb[2]);
    }

    /** XYZ in cd/m² to radiance. */
    private static void toRgb(double[] c) {
        double cx = c[0] / UNIT;
        double cy = c[1] / UNIT;
        double cz = c[2] / UNIT;
        for (int band = 0; band < 3; band++) {
            double[] m = TO_RGB[band];
            c[band] = Math.max(0, m[0] * cx + m[1] * cy + m[2] * cz);
        }
    }
}
