package enlightenment.light;

import enlightenment.check.Check;
import enlightenment.check.Radiance;
import enlightenment.color.Rgb;
import java.util.Locale;
import java.util.Objects;

/**
 * How much light a light gives, for physical shading: what arrives is this times the light's linear colour. Units are relative
 * (only ratios are visible); whoever takes the scene unit for a metre may take these for watts.
 *
 * @param quantity what the number measures
 * @param value the number, for each band
 * @param ultraviolet the same quantity of the band of the near ultraviolet (300 to 400 nm), without the light's colour; only fluorescent
 *     surfaces show it
 */
public record Emission(Quantity quantity, Rgb value, double ultraviolet) {
    /** What the number measures. */
    public enum Quantity {
        /** Radiance, W/(m² sr): how bright the surface looks from everywhere it shines to. */
        RADIANCE,

        /** Power, W: all that leaves the light. */
        POWER,

        /** Intensity, W/sr: what a light without extent sends into each direction. */
        INTENSITY,

        /** Irradiance, W/m²: what a distant light sends to a surface perpendicular to its direction that nothing hides it from. */
        IRRADIANCE;

        /** Its key in the scene format. */
        public String key() {
            return name().toLowerCase(Locale.ROOT);
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
        // How bright power and intensity are is a matter of the scene's size.
        if (quantity == Quantity.RADIANCE) {
            Radiance.check("ultraviolet", ultraviolet);
        }
    }

    /** Visible light alone. */
    public Emission(Quantity quantity, Rgb value) {
        this(quantity, value, 0);
    }

    /** The same with as much ultraviolet light. */
    public Emission withUltraviolet(double amount) {
        return new Emission(quantity, value, amount);
    }

    /** This radiance. */
    public static Emission radiance(Rgb value) {
        return new Emission(Quantity.RADIANCE, value);
    }

    /** This power. */
    public static Emission power(Rgb value) {
        return new Emission(Quantity.POWER, value);
    }

    /** This intensity. */
    public static Emission intensity(Rgb value) {
        return new Emission(Quantity.INTENSITY, value);
    }

    /** This irradiance. */
    public static Emission irradiance(Rgb value) {
        return new Emission(Quantity.IRRADIANCE, value);
    }
}
