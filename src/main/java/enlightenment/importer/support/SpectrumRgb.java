package enlightenment.importer.support;

import enlightenment.color.Rgb;
import enlightenment.colorimetry.BandSensitivities;
import java.util.Arrays;
import java.util.function.DoubleUnaryOperator;

/**
 * Spectra, functions of the wavelength in nanometres, as linear sRGB by the CIE 1931 2° observer: the colour-matching functions are the sums of
 * halves of Gaussians of C. Wyman, P.-P. Sloan and P. Shirley ("Simple analytic approximations to the CIE XYZ color matching functions", 2013),
 * {@link BandSensitivities#matching}. Colours outside of the gamut of sRGB lose their negative components.
 */
public final class SpectrumRgb {
    /** Planck's second radiation constant, in nanometres times kelvin (CODATA 2018). */
    private static final double SECOND_CONSTANT = 1.438776877e7;

    /** The luminance of the bands: the second row of the matrix from linear sRGB to XYZ (IEC 61966-2-1). */
    private static final double[] LUMINANCE = {0.2126, 0.7152, 0.0722};

    private SpectrumRgb() {}

    /**
     * The spectrum that is linear between samples and 0 outside of them; the arrays are copied.
     *
     * @param wavelengths in nanometres, growing
     * @param values one for each
     * @throws IllegalArgumentException if the arrays differ in length, are empty, hold what is no finite number, or the wavelengths do not grow
     */
    public static DoubleUnaryOperator linear(double[] wavelengths, double[] values) {
        double[] x = wavelengths.clone();
        double[] y = values.clone();
        boolean isValid = x.length == y.length && x.length > 0;
        for (int i = 0; isValid && i < x.length; i++) {
            isValid = Double.isFinite(x[i]) && Double.isFinite(y[i]) && (i == 0 || x[i] > x[i - 1]);
        }
        if (!isValid) {
            throw new IllegalArgumentException(
                    "a spectrum must be pairs of finite numbers, wavelength and value, by growing wavelength");
        }
        return wavelength -> {
            int k = Arrays.binarySearch(x, wavelength);
            if (k >= 0) {
                return y[k];
            }
            int above = -k - 1;
            if (above == 0 || above == x.length) {
                return 0;
            }
            double t = (wavelength - x[above - 1]) / (x[above] - x[above - 1]);
            return y[above - 1] + t * (y[above] - y[above - 1]);
        };
    }

    /**
     * What a factor of each wavelength, such as a reflectance, does to white light (daylight D65): 1 everywhere is white. Also the mean over the
     * bands of a quantity such as an index of refraction.
     */
    public static Rgb underDaylight(DoubleUnaryOperator spectrum) {
        double[] sums = new double[3];
        for (double w = BandSensitivities.SHORTEST + 0.5; w < BandSensitivities.LONGEST; w++) {
            double v = spectrum.applyAsDouble(w);
            for (int c = 0; c < sums.length; c++) {
                sums[c] += v * BandSensitivities.DAYLIGHT.sensitivity(w, c);
            }
        }
        return positive(sums);
    }

    /**
     * The colour of light of a spectrum, at luminance 1.
     *
     * @return black for a spectrum without visible light
     */
    public static Rgb ofLight(DoubleUnaryOperator spectrum) {
        double[] sums = new double[3];
        for (double w = BandSensitivities.SHORTEST + 0.5; w < BandSensitivities.LONGEST; w++) {
            double v = spectrum.applyAsDouble(w);
            for (int c = 0; c < sums.length; c++) {
                sums[c] += v * BandSensitivities.matching(w, c);
            }
        }
        return atLuminanceOne(sums);
    }

    /**
     * The colour of a black body, at luminance 1 (Planck's law).
     *
     * @param kelvin its temperature, greater than 0
     */
    public static Rgb blackbody(double kelvin) {
        if (!(kelvin > 0) || kelvin == Double.POSITIVE_INFINITY) {
            throw new IllegalArgumentException("a temperature must be finite and greater than 0 kelvin, not " + kelvin);
        }
        // Relative to 560 nm, so that cold bodies do not underflow.
        double middle = SECOND_CONSTANT / (560 * kelvin);
        return ofLight(w -> {
            double x = SECOND_CONSTANT / (w * kelvin);
            double fifth = StrictMath.pow(560 / w, 5);
            return fifth * StrictMath.exp(middle - x) * StrictMath.expm1(-middle) / StrictMath.expm1(-x);
        });
    }

    /**
     * The colour of these chromaticity coordinates of the CIE 1931 system, at luminance 1.
     *
     * @param y greater than 0
     */
    public static Rgb ofChromaticity(double x, double y) {
        double[] bands = new double[3];
        for (int c = 0; c < bands.length; c++) {
            bands[c] = BandSensitivities.ofXyz(x / y, 1, (1 - x - y) / y, c);
        }
        return atLuminanceOne(bands);
    }

    /** The luminance Y of linear sRGB; 1 for white. */
    public static double luminance(Rgb c) {
        return LUMINANCE[0] * c.r() + LUMINANCE[1] * c.g() + LUMINANCE[2] * c.b();
    }

    private static Rgb atLuminanceOne(double[] bands) {
        Rgb inside = positive(bands);
        double luminance = luminance(inside);
        return luminance > 0 && luminance < Double.POSITIVE_INFINITY
                ? new Rgb(inside.r() / luminance, inside.g() / luminance, inside.b() / luminance)
                : Rgb.BLACK;
    }

    private static Rgb positive(double[] bands) {
        return new Rgb(positive(bands[0]), positive(bands[1]), positive(bands[2]));
    }

    private static double positive(double v) {
        return v > 0 ? v : 0;
    }
}
