package enlightenment.light;

import enlightenment.check.Check;
import enlightenment.check.Radiance;
import enlightenment.color.Rgb;
import java.util.Locale;
import java.util.Objects;

/**
 * The amount of light that a light emits, for physical shading; it is multiplied by the light's linear colour. Units are relative (only
 * ratios are visible); if the scene unit is a metre, they may be read as watts.
 *
 * @param quantity the radiometric quantity of the value
 * @param value the number, for each band
 * @param ultraviolet the same quantity of the near ultraviolet (300 to 400 nm), without the light's colour; only fluorescent surfaces show
 *     it
 */
public record Emission(Quantity quantity, Rgb value, double ultraviolet) {
    /** Radiometric quantities. */
    public enum Quantity {
        /** Radiance, W/(m² sr): the brightness of the surface as seen from its emitting sides. */
        RADIANCE,

        /** Power, W: the total emission of the light. */
        POWER,

        /** Intensity, W/sr: the emission of a light without extent in each direction. */
        INTENSITY,

        /** Irradiance, W/m²: of a distant light, at an unoccluded surface perpendicular to its direction. */
        IRRADIANCE;

        private final String key = name().toLowerCase(Locale.ROOT);

        /** The quantity's key in the scene format. */
        public String key() {
            return key;
        }
    }

    /** Radiance 1. */
    public static final Emission RADIANCE_1 = radiance(Rgb.WHITE);

    /** Intensity 1. */
    public static final Emission INTENSITY_1 = intensity(Rgb.WHITE);

    /** Irradiance 1. */
    public static final Emission IRRADIANCE_1 = irradiance(Rgb.WHITE);

    /**
     * Checks that nothing is missing.
     *
     * @throws enlightenment.math.InvalidValueException (key {@code ultraviolet}) if that is negative or not finite, or a radiance above
     *     {@link Radiance#LARGEST}
     */
    public Emission {
        Objects.requireNonNull(quantity, "quantity");
        Objects.requireNonNull(value, "value");
        Check.notNegative("ultraviolet", ultraviolet);
        // The brightness of power and intensity depends on the scene's size.
        if (quantity == Quantity.RADIANCE) {
            Radiance.check("ultraviolet", ultraviolet);
        }
    }

    /** Emission of visible light alone. */
    public Emission(Quantity quantity, Rgb value) {
        this(quantity, value, 0);
    }

    /** This emission with another amount of ultraviolet, in the same quantity. */
    public Emission withUltraviolet(double amount) {
        return new Emission(quantity, value, amount);
    }

    /** Emission of this radiance, by band. */
    public static Emission radiance(Rgb value) {
        return new Emission(Quantity.RADIANCE, value);
    }

    /** Emission of this power, by band. */
    public static Emission power(Rgb value) {
        return new Emission(Quantity.POWER, value);
    }

    /** Emission of this intensity, by band. */
    public static Emission intensity(Rgb value) {
        return new Emission(Quantity.INTENSITY, value);
    }

    /** Emission of this irradiance, by band. */
    public static Emission irradiance(Rgb value) {
        return new Emission(Quantity.IRRADIANCE, value);
    }
}
