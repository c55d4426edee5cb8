package enlightenment.surroundings;

/**
 * The light of the sun's disk after its way through the atmosphere, by A. Preetham, P. Shirley and B. Smits, "A practical analytic model
 * for daylight" (1999), appendix 1, after M. Iqbal, "An introduction to solar radiation" (1983): extraterrestrial radiance times the
 * transmittances of air, aerosol, ozone, mixed gases and water vapour.
 */
final class SunSpectrum {
    private static final int FIRST = 380;
    private static final int STEP = 10;

    /** The radiance of the disk outside the atmosphere, from 380 to 750 nm: in W/(m² nm sr). */
    private static final double[] SUN = {
        16559.0, 16233.7, 21127.5, 25888.2, 25829.1, 24232.3, 26760.5, 29658.3, 30545.4, 30057.5,
        30663.7, 28830.4, 28712.1, 27825.0, 27100.6, 27233.6, 26361.3, 25503.8, 25060.2, 25311.6,
        25355.9, 25134.2, 24631.5, 24173.2, 23685.3, 23212.1, 22827.7, 22339.8, 21970.2, 21526.7,
        21097.9, 20728.3, 20240.4, 19870.8, 19427.2, 19072.4, 18628.9, 18259.2
    };

    /** Absorption by ozone, in 1/cm. */
    private static final double[] OZONE = {
        0, 0, 0, 0, 0, 0, 0, 0.003, 0.006, 0.009, 0.014, 0.021, 0.030, 0.040, 0.048, 0.063, 0.075, 0.085, 0.103, 0.120,
        0.120, 0.115, 0.125, 0.120, 0.105, 0.090, 0.079, 0.067, 0.057, 0.048, 0.036, 0.028, 0.023, 0.018, 0.014, 0.011,
        0.010, 0.009
    };

    /** Absorption by water vapour, in 1/cm, from 690 nm on; mixed gases absorb beyond the last wavelength only. */
    private static final double[] WATER = {0.016, 0.024, 0.0125, 1.0, 0.87, 0.061, 0.001};

    private static final int FIRST_WATER = (690 - FIRST) / STEP;

    /** The colour matching functions of the CIE 1931 standard observer at these wavelengths. */
    private static final double[] X = {
        0.001368, 0.004243, 0.01431, 0.04351, 0.13438, 0.2839, 0.34828, 0.3362, 0.2908, 0.19536, 0.09564, 0.03201,
        0.0049, 0.0093, 0.06327, 0.1655, 0.2904, 0.43345, 0.5945, 0.7621, 0.9163, 1.0263, 1.0622, 1.0026, 0.85445,
        0.6424, 0.4479, 0.2835, 0.1649, 0.0874, 0.04677, 0.0227, 0.011359, 0.00579, 0.002899, 0.00144, 0.00069, 0.000332
    };

    private static final double[] Y = {
        0.000039, 0.00012, 0.000396, 0.00121, 0.004, 0.0116, 0.023, 0.038, 0.06, 0.09098, 0.13902, 0.20802, 0.323,
        0.503, 0.71, 0.862, 0.954, 0.99495, 0.995, 0.952, 0.87, 0.757, 0.631, 0.503, 0.381, 0.265, 0.175, 0.107, 0.061,
        0.032, 0.017, 0.00821, 0.004102, 0.002091, 0.001047, 0.00052, 0.000249, 0.00012
    };

    private static final double[] Z = {
        0.00645, 0.02005, 0.06785, 0.2074, 0.6456, 1.3856, 1.74706, 1.77211, 1.6692, 1.28764, 0.81295, 0.46518, 0.272,
        0.1582, 0.07825, 0.04216, 0.0203, 0.00875, 0.0039, 0.0021, 0.00165, 0.0011, 0.0008, 0.00034, 0.00019, 0.00005,
        0.00002, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0
    };

    /** Luminous efficacy, in lm/W. */
    private static final double EFFICACY = 683;

    private static final double OZONE_CM = 0.35;
    private static final double WATER_CM = 2;
    private static final double ALPHA = 1.3;

    private SunSpectrum() {}

    /** How much air the light of a sun at this height comes through, in units of the way straight down (F. Kasten, 1966). */
    static double airMass(double elevationDegrees) {
        double sine = StrictMath.sin(StrictMath.toRadians(elevationDegrees));
        return 1 / (sine + 0.15 * StrictMath.pow(elevationDegrees + 3.885, -1.253));
    }

    /** The share that comes through, at one of the wavelengths. */
    private static double transmittance(int k, double turbidity, double m) {
        double micrometres = (FIRST + STEP * k) / 1000.0;
        double rayleigh = 0.008735 * StrictMath.pow(micrometres, -4.08) * m;
        double beta = 0.04608 * turbidity - 0.04586;
        double aerosol = beta * StrictMath.pow(micrometres, -ALPHA) * m;
        double ozone = OZONE[k] * OZONE_CM * m;
        double kw = k < FIRST_WATER ? 0 : WATER[k - FIRST_WATER] * WATER_CM * m;
        double water = 0.2385 * kw / StrictMath.pow(1 + 20.07 * kw, 0.45);
        return StrictMath.exp(-(rayleigh + aerosol + ozone + water));
    }

    /**
     * The disk's colour.
     *
     * @param m air mass; 0 outside the atmosphere
     * @param xyz receives X, Y and Z (CIE 1931), Y being luminance in cd/m²
     */
    static void disk(double turbidity, double m, double[] xyz) {
        double x = 0;
        double y = 0;
        double z = 0;
        for (int k = 0; k < SUN.length; k++) {
            double power = EFFICACY * STEP * SUN[k] * transmittance(k, turbidity, m);
            x += power * X[k];
            y += power * Y[k];
            z += power * Z[k];
        }
        xyz[0] = x;
        xyz[1] = y;
        xyz[2] = z;
    }
}
