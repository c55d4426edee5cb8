package enlightenment.bsdf;

import enlightenment.numeric.Scale;

/**
 * The Donaldson matrix of a fluorescent surface, band by band: it reflects a share unchanged, its colour, and re-emits a part of what its
 * dye absorbs of the rest at longer wavelengths (R. Donaldson, "Spectrophotometry of fluorescent pigments", 1954; M. Hullin and others,
 * "Acquisition and analysis of bispectral bidirectional reflectance and reradiation distribution functions", 2010), reduced to four bands
 * in which light is taken as constant per nanometre: red, green, blue and ultraviolet, in this order. Both parts leave the surface as from
 * a Lambertian one.
 *
 * <p>A colour has three components; ultraviolet takes that of blue. The dye's part is known when a scene is compiled, so that the colour
 * may come from a texture. Immutable.
 */
public final class Reradiation {
    /** The number of bands. */
    public static final int BANDS = 4;

    /** The index of the band of ultraviolet: the last. */
    public static final int ULTRAVIOLET = 3;

    /** Wavelengths in nanometres: band k lies between the (k + 1)th and the kth. */
    private static final double[] EDGES = {780, 580, 490, 400, 300};

    /** The approximate step of the integral of absorption, in nanometres. */
    private static final double STEP = 1;

    /** A bound of the rounding of a sum of shares. */
    private static final double ROUNDING = Scale.gamma(1024);

    /**
     * The dye's part of the matrix, by emitted band, then by incident band: the share of light not reflected unchanged that is re-emitted.
     */
    private final double[] dye = new double[BANDS * BANDS];

    private final boolean[] gives = new boolean[BANDS];

    /**
     * Makes a dye. Of the light absorbed at a wavelength, the yield, a number of photons per photon, is distributed uniformly in photons
     * over the emission wavelengths that are not shorter (G. Stokes, 1852). Wavelengths are in nanometres, 300 to 780; the rest is ignored.
     *
     * @param yield 0..1
     * @throws ArithmeticException if a share is no number, or more light leaves than arrives: never with such numbers
     */
    public Reradiation(
            double absorptionLow, double absorptionHigh, double emissionLow, double emissionHigh, double yield) {
        for (int from = 0; from < BANDS; from++) {
            double low = Math.max(absorptionLow, EDGES[from + 1]);
            // Above the last emission wavelength there is none that is not shorter.
            double high = Math.min(Math.min(absorptionHigh, emissionHigh), EDGES[from]);
            double sum = 0;
            for (int to = 0; to < BANDS && high > low; to++) {
                double start = Math.max(emissionLow, EDGES[to + 1]);
                double end = Math.min(emissionHigh, EDGES[to]);
                double share = yield * integral(low, high, start, end, emissionLow, emissionHigh);
                dye[BANDS * to + from] = share / (EDGES[from] - EDGES[from + 1]);
                gives[from] |= share > 0;
                sum += dye[BANDS * to + from];
                check(!(share > 0 && to > from), "light moves to shorter wavelengths");
            }
            check(sum <= 1 + ROUNDING, "more light leaves than came");
        }
    }

    private static void check(boolean holds, String otherwise) {
        if (!holds) {
            throw new ArithmeticException("a fluorescent dye: " + otherwise);
        }
    }

    /** Of light absorbed between low and high, one unit per nanometre, the energy emitted between start and end. */
    private static double integral(
            double low, double high, double start, double end, double emissionLow, double emissionHigh) {
        int steps = (int) Math.ceil((high - low) / STEP);
        double step = (high - low) / steps;
        double sum = 0;
        for (int k = 0; k < steps; k++) {
            double at = low + step * (k + 0.5);
            double all = emissionHigh - Math.max(emissionLow, at);
            double from = Math.max(start, at);
            if (end > from) {
                // A photon absorbed at wavelength λ and emitted at λ′ has λ/λ′ of the energy: the integral over λ′.
                sum += at * StrictMath.log1p((end - from) / from) / all;
            }
        }
        return step * sum;
    }

    /** The share of one band's light, of the part not reflected unchanged, that is re-emitted in another band. */
    public double share(int to, int from) {
        return dye[BANDS * to + from];
    }

    /** Whether light of a band is re-emitted in any band. */
    public boolean gives(int from) {
        return gives[from];
    }

    /** Whether no band of the scene's light, with or without ultraviolet, is re-emitted. */
    public boolean isIdle(boolean hasUltraviolet) {
        return !(gives[0] || gives[1] || gives[2] || hasUltraviolet && gives[ULTRAVIOLET]);
    }

    /** An element of the matrix for a surface of this colour: emitted light in one band per incident light in another. */
    public double element(int to, int from, double[] color) {
        double c = color[Math.min(from, ULTRAVIOLET - 1)];
        return (to == from ? c : 0) + (1 - c) * dye[BANDS * to + from];
    }

    /** The largest column sum, 0..1, of the matrix for a surface of this colour: the share of one band's power that leaves in all bands. */
    public double most(double[] color, boolean hasUltraviolet) {
        double most = 0;
        for (int from = 0; from < (hasUltraviolet ? BANDS : ULTRAVIOLET); from++) {
            double sum = 0;
            for (int to = 0; to <= from; to++) {
                sum += element(to, from, color);
            }
            most = Math.max(most, sum);
        }
        return most;
    }

    /**
     * Multiplies a vector by the matrix: incident light becomes reflected and re-emitted light.
     *
     * @param color of the surface, of three bands
     * @param light of four bands
     */
    public void scatter(double[] color, double[] light) {
        // A band adds to longer wavelengths only, which are done already.
        for (int from = 0; from < BANDS; from++) {
            double c = color[Math.min(from, ULTRAVIOLET - 1)];
            double absorbed = (1 - c) * light[from];
            light[from] *= c;
            for (int to = 0; to <= from; to++) {
                light[to] = Math.fma(dye[BANDS * to + from], absorbed, light[to]);
            }
        }
    }

    /**
     * Multiplies row vectors by the matrix from the right, in place: the adjoint of {@link #scatter}, for paths from the eye.
     *
     * @param color of the surface, of three bands
     * @param rows rows of {@link #BANDS} weights, one after another: of the light that leaves; receives those of the light that arrives
     */
    public void adjoin(double[] color, double[] rows) {
        for (int row = 0; row < rows.length; row += BANDS) {
            // The weight of a band depends on those of longer wavelengths, which are still unchanged.
            for (int from = BANDS - 1; from >= 0; from--) {
                double c = color[Math.min(from, ULTRAVIOLET - 1)];
                double sum = 0;
                for (int to = 0; to <= from; to++) {
                    sum = Math.fma(dye[BANDS * to + from], rows[row + to], sum);
                }
                rows[row + from] = Math.fma(1 - c, sum, c * rows[row + from]);
            }
        }
    }
}
