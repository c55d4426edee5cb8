package enlightenment.colorimetry;

/**
 * How the wavelengths of visible light make up the bands red, green and blue of linear light, where white light has the spectrum of
 * daylight D65 (CIE 15:2018, table 1, every 10 nm, linear between): the colour-matching functions of 1931 as sums of halves of Gaussians
 * (C. Wyman, P.-P. Sloan and P. Shirley, "Simple analytic approximations to the CIE XYZ color matching functions", 2013) through the
 * matrix of sRGB. Each band adds up to 1, so white stays white; parts of some are negative, since no screen shows pure spectral colours.
 *
 * <p>Wavelengths can be drawn in proportion to the sum of the magnitudes of the three. All is constant within each nanometre, so that sums
 * are exact. Immutable.
 */
public final class BandSensitivities {
    /** The shortest wavelength, in nanometres. */
    public static final double SHORTEST = 380;

    /** The longest. */
    public static final double LONGEST = 780;

    private static final int STEPS = (int) (LONGEST - SHORTEST);
    private static final int BANDS = 3;

    /** Nanometres between the numbers of {@link #D65}. */
    private static final int APART = 10;

    private static final double[] D65 = {
        49.9755, 54.6482, 82.7549, 91.4860, 93.4318, 86.6823, 104.865, 117.008, 117.812, 114.861,
        115.923, 108.811, 109.354, 107.802, 104.790, 107.689, 104.405, 104.046, 100.000, 96.3342,
        95.7880, 88.6856, 90.0062, 89.5991, 87.6987, 83.2886, 83.6992, 80.0268, 80.2146, 82.2778,
        78.2842, 69.7213, 71.6091, 74.3490, 61.6040, 69.8856, 75.0870, 63.5927, 46.4182, 66.8054,
        63.3828
    };

    /** Height, place, width to the left and to the right of the Gaussians of x, y and z. */
    private static final double[][] LOBES = {
        {1.056, 599.8, 37.9, 31.0, 0.362, 442.0, 16.0, 26.7, -0.065, 501.1, 20.4, 26.2},
        {0.821, 568.8, 46.9, 40.5, 0.286, 530.9, 16.3, 31.1},
        {1.217, 437.0, 11.8, 36.0, 0.681, 459.0, 26.0, 13.8}
    };

    /** From XYZ to linear sRGB (IEC 61966-2-1). */
    private static final double[][] TO_RGB = {
        {3.2406255, -1.5372080, -0.4986286},
        {-0.9689307, 1.8757561, 0.0415175},
        {0.0557101, -0.2040211, 1.0569959}
    };

    /** For white light of the spectrum of daylight. After what it is made of. */
    public static final BandSensitivities DAYLIGHT = new BandSensitivities();

    /** By nanometre, then band: the sensitivity over the density of drawing it. */
    private final double[] weights = new double[BANDS * STEPS];

    /** By nanometre, then band: the sensitivity per nanometre. */
    private final double[] sensitivities = new double[BANDS * STEPS];

    /** The probability of all wavelengths before each nanometre. */
    private final double[] below = new double[STEPS + 1];

    private BandSensitivities() {
        double[] sums = new double[BANDS];
        for (int k = 0; k < STEPS; k++) {
            double wavelength = SHORTEST + k + 0.5;
            for (int c = 0; c < BANDS; c++) {
                sensitivities[BANDS * k + c] = matching(wavelength, c) * daylight(wavelength);
                sums[c] += sensitivities[BANDS * k + c];
            }
        }
        for (int i = 0; i < sensitivities.length; i++) {
            sensitivities[i] /= sums[i % BANDS];
        }
        for (int k = 0; k < STEPS; k++) {
            below[k + 1] = below[k] + magnitude(k);
        }
        double total = below[STEPS];
        for (int k = 0; k <= STEPS; k++) {
            below[k] /= total;
        }
        for (int i = 0; i < weights.length; i++) {
            weights[i] = sensitivities[i] * total / magnitude(i / BANDS);
        }
    }

    private double magnitude(int k) {
        double sum = 0;
        for (int c = 0; c < BANDS; c++) {
            sum += Math.abs(sensitivities[BANDS * k + c]);
        }
        return sum;
    }

    private static double daylight(double wavelength) {
        double x = (wavelength - SHORTEST) / APART;
        int k = Math.min((int) x, D65.length - 2);
        return Math.fma(x - k, D65[k + 1] - D65[k], D65[k]);
    }

    private static double matching(double[] lobes, double wavelength) {
        double sum = 0;
        for (int k = 0; k < lobes.length; k += 4) {
            double d = wavelength - lobes[k + 1];
            double x = d / (d < 0 ? lobes[k + 2] : lobes[k + 3]);
            sum += lobes[k] * StrictMath.exp(-0.5 * x * x);
        }
        return sum;
    }

    /**
     * The colour-matching function of band 0, 1 or 2 at a wavelength in nanometres: what light of one wavelength and of radiance 1 per nanometre adds to
     * linear sRGB, without regard to any white. Negative where no screen shows a pure spectral colour.
     */
    public static double matching(double wavelength, int band) {
        double sum = 0;
        for (int j = 0; j < BANDS; j++) {
            sum += TO_RGB[band][j] * matching(LOBES[j], wavelength);
        }
        return sum;
    }

    /** The component of band 0, 1 or 2 of a colour of the CIE 1931 system, in linear sRGB: below 0 or above 1 outside of its gamut. */
    public static double ofXyz(double x, double y, double z, int band) {
        return TO_RGB[band][0] * x + TO_RGB[band][1] * y + TO_RGB[band][2] * z;
    }

    /** The sensitivity of band 0, 1 or 2 at a wavelength in the visible range, per nanometre. */
    public double sensitivity(double wavelength, int band) {
        return sensitivities[BANDS * step(wavelength) + band];
    }

    /**
     * Draws a wavelength.
     *
     * @param number uniform in [0, 1)
     * @return nanometres
     */
    public double draw(double number) {
        int low = 0;
        int high = STEPS;
        while (high - low > 1) {
            int middle = (low + high) >>> 1;
            if (below[middle] <= number) {
                low = middle;
            } else {
                high = middle;
            }
        }
        return SHORTEST + low + Math.min((number - below[low]) / (below[low + 1] - below[low]), Math.nextDown(1.0));
    }

    /** The sensitivity of a band over the density with which a wavelength is drawn: 1 in the mean. */
    public double weight(double wavelength, int band) {
        return weights[BANDS * step(wavelength) + band];
    }

    private static int step(double wavelength) {
        return Math.min(Math.max((int) (wavelength - SHORTEST), 0), STEPS - 1);
    }
}
