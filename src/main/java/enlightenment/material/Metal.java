package enlightenment.material;

import enlightenment.color.Rgb;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.stream.Stream;

/**
 * Metals by name, with their complex index of refraction η + ik in air. η and k of a band are the means of the measured ones over its
 * {@linkplain enlightenment.colorimetry.BandSensitivities#DAYLIGHT sensitivity}; docs/notes/bsdfs.md names the sources.
 */
public enum Metal {
    SILVER("Ag", new Rgb(0.056, 0.055, 0.043), new Rgb(4.354, 3.535, 2.567)),
    ALUMINIUM("Al", new Rgb(1.473, 0.986, 0.598), new Rgb(7.637, 6.556, 5.346)),
    GOLD("Au", new Rgb(0.063, 0.497, 1.459), new Rgb(3.601, 2.330, 1.818)),
    CHROMIUM("Cr", new Rgb(3.249, 3.109, 2.279), new Rgb(3.287, 3.338, 3.124)),
    COPPER("Cu", new Rgb(0.179, 1.041, 1.290), new Rgb(3.270, 2.605, 2.366)),
    /** 70 % copper, 30 % zinc. */
    BRASS("CuZn", new Rgb(0.421, 0.518, 1.123), new Rgb(3.656, 2.687, 1.770)),
    IRON("Fe", new Rgb(2.923, 2.918, 2.545), new Rgb(3.074, 2.938, 2.750)),
    NICKEL("Ni", new Rgb(2.021, 1.902, 1.724), new Rgb(4.165, 3.569, 2.885)),
    PLATINUM("Pt", new Rgb(2.336, 2.075, 1.828), new Rgb(4.211, 3.668, 3.088)),
    TITANIUM("Ti", new Rgb(2.734, 2.509, 2.236), new Rgb(3.823, 3.400, 3.010)),
    TUNGSTEN("W", new Rgb(3.685, 3.444, 3.354), new Rgb(2.935, 2.734, 2.509));

    private final String symbol;
    private final Conductor conductor;

    Metal(String symbol, Rgb eta, Rgb k) {
        this.symbol = symbol;
        conductor = new Conductor(eta, k);
    }

    /** Its complex index of refraction by band. */
    public Conductor conductor() {
        return conductor;
    }

    /** Its chemical symbol, such as {@code "Au"}; {@code "CuZn"} for brass, as pbrt and Mitsuba call it. */
    public String symbol() {
        return symbol;
    }

    /** Its name in small letters, such as {@code "gold"}. */
    public String word() {
        return name().toLowerCase(Locale.ROOT);
    }

    /** The names, then the symbols of all metals: what {@link #of(String)} accepts. */
    public static List<String> words() {
        return Stream.concat(
                        Arrays.stream(values()).map(Metal::word),
                        Arrays.stream(values()).map(Metal::symbol))
                .toList();
    }

    /** The metal of a name or a symbol; empty if there is none. */
    public static Optional<Metal> of(String word) {
        return Arrays.stream(values())
                .filter(m -> m.word().equals(word) || m.symbol.equals(word))
                .findFirst();
    }

    /** The metal that has exactly this index of refraction; empty if there is none. */
    public static Optional<Metal> of(Conductor conductor) {
        return Arrays.stream(values())
                .filter(m -> m.conductor.equals(conductor))
                .findFirst();
    }
}
