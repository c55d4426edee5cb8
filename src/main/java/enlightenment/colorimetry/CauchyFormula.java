package enlightenment.colorimetry;

/**
 * How the index of refraction of a glass depends on the wavelength: n(λ) = A + B/λ² (A.-L. Cauchy, 1836), with A and B such that the index
 * is n_d in the yellow light of helium and that the difference between blue and red light of hydrogen gives the Abbe number
 * V_d = (n_d − 1)/(n_F − n_C). Wavelengths in vacuum, in nanometres; a place is 1/λ² − 1/λ_d², in 1/µm².
 *
 * <p>All methods may be called by several threads at once.
 */
public final class CauchyFormula {
    /** The line d of helium, at which indices of refraction are given. */
    public static final double YELLOW = 587.6;

    /** The lines F and C of hydrogen. */
    private static final double BLUE = 486.1;

    private static final double RED = 656.3;

    private static final double NANOMETRES = 1000;

    private CauchyFormula() {}

    /** The place of a wavelength: 0 at the yellow line, positive towards blue. */
    public static double place(double wavelength) {
        return inverseSquare(wavelength) - inverseSquare(YELLOW);
    }

    private static double inverseSquare(double wavelength) {
        double micrometres = wavelength / NANOMETRES;
        return 1 / (micrometres * micrometres);
    }

    /**
     * How much the index grows with the place: B, in µm²; 0 where the index is 1.
     *
     * @param index n_d
     * @param abbe the Abbe number V_d, positive
     */
    public static double slope(double index, double abbe) {
        return (index - 1) / (abbe * (inverseSquare(BLUE) - inverseSquare(RED)));
    }

    /** The index of refraction at a place. */
    public static double index(double index, double slope, double place) {
        return Math.fma(slope, place, index);
    }
}
