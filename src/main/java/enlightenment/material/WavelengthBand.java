package enlightenment.material;

import enlightenment.check.Check;

/**
 * A band of wavelengths of light in air, in nanometres.
 *
 * @param low its shortest wavelength, at least {@link #SHORTEST}
 * @param high its longest wavelength, greater than {@code low} and at most {@link #LONGEST}
 */
public record WavelengthBand(double low, double high) {
    /** The shortest wavelength that is modelled: that of near ultraviolet light, in nanometres. */
    public static final double SHORTEST = 300;

    /** The longest wavelength that is modelled: that of the deepest red which is seen, in nanometres. */
    public static final double LONGEST = 780;

    /**
     * Checks the range.
     *
     * @throws enlightenment.math.InvalidValueException if the band is empty or not within the modelled wavelengths
     */
    public WavelengthBand {
        Check.that(
                low >= SHORTEST && low < high && high <= LONGEST,
                "band",
                "must be two growing wavelengths [from, to] in 300..780 nm, not [" + low + ", " + high + "]");
    }
}
