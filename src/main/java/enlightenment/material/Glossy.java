package enlightenment.material;

import enlightenment.check.Check;
import enlightenment.check.Radiance;
import enlightenment.color.Rgb;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Objects;
import java.util.Optional;
import java.util.stream.Stream;

/**
 * A rough mirror, such as a metal: microscopic facets by the distribution GGX (Walter and others, 2007). Only physical shading
 * has it.
 *
 * @param color its reflectance where it is looked at and lit straight on (Schlick's Fresnel term leads from there to white at
 *     grazing angles); of a conductor, what is multiplied onto the exact Fresnel term
 * @param roughness 0 (a mirror) to 1; the parameter alpha of the distribution is its square
 * @param conductor the optical constants; empty for Schlick's term
 * @param multipleScattering whether light that meets several facets is counted; without it, rough surfaces are too dark
 * @param radiance see {@link Material#radiance}
 * @param ultraviolet see {@link Material#ultraviolet}
 * @param pattern see {@link Material#pattern}
 */
public record Glossy(
        Texture color,
        Texture.Amount roughness,
        Optional<Conductor> conductor,
        boolean multipleScattering,
        Rgb radiance,
        double ultraviolet,
        Material.EmissionPattern pattern)
        implements Material {
    /** Validates the components, as {@link Material} states. */
    public Glossy {
        Reflectance.check(color);
        Objects.requireNonNull(roughness, "roughness");
        Objects.requireNonNull(conductor, "conductor");
        Radiance.check("radiance", radiance.max());
        Radiance.check("ultraviolet", ultraviolet);
        Detail.checkRadiance(radiance, ultraviolet, pattern);
    }

    /** A surface whose points glow alike, if at all. */
    public Glossy(
            Texture color,
            Texture.Amount roughness,
            Optional<Conductor> conductor,
            boolean multipleScattering,
            Rgb radiance,
            double ultraviolet) {
        this(color, roughness, conductor, multipleScattering, radiance, ultraviolet, Material.EmissionPattern.EVEN);
    }

    /** A surface of the same roughness everywhere. */
    public Glossy(
            Texture color,
            double roughness,
            Optional<Conductor> conductor,
            boolean multipleScattering,
            Rgb radiance,
            double ultraviolet) {
        this(color, Detail.amount("roughness", roughness), conductor, multipleScattering, radiance, ultraviolet);
    }

    /** A surface that glows, if at all, in visible light alone. */
    public Glossy(
            Texture color, double roughness, Optional<Conductor> conductor, boolean multipleScattering, Rgb radiance) {
        this(color, roughness, conductor, multipleScattering, radiance, 0);
    }

    /** This surface with another roughness. */
    public Glossy withRoughness(Texture.Amount value) {
        return new Glossy(color, value, conductor, multipleScattering, radiance, ultraviolet, pattern);
    }

    @Override
    public List<Texture> textures() {
        return Detail.textures(roughness.textures(), radianceMap());
    }

    /** A surface with Schlick's Fresnel term and multiple scattering that does not glow. */
    public static Glossy of(Texture color, double roughness) {
        return new Glossy(color, roughness, Optional.empty(), true, Rgb.BLACK);
    }

    /** A metal of these optical constants and this filter colour, with multiple scattering. */
    public static Glossy metal(Texture color, Conductor conductor, double roughness) {
        return new Glossy(color, roughness, Optional.of(conductor), true, Rgb.BLACK);
    }

    @Override
    public String type() {
        return "glossy";
    }

    @Override
    public boolean isForClassicShading() {
        return false;
    }

    /**
     * The complex index of refraction eta + i k of a metal, relative to what surrounds it, in each band.
     *
     * @param eta the real part, greater than 0
     * @param k the imaginary part, which absorbs
     */
    public record Conductor(Rgb eta, Rgb k) {
        /** Validates the components, as {@link Material} states. */
        public Conductor {
            Check.positive("eta", eta.r());
            Check.positive("eta", eta.g());
            Check.positive("eta", eta.b());
            Objects.requireNonNull(k, "k");
        }
    }

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
        private final Glossy.Conductor conductor;

        Metal(String symbol, Rgb eta, Rgb k) {
            this.symbol = symbol;
            conductor = new Glossy.Conductor(eta, k);
        }

        /** Its complex index of refraction by band. */
        public Glossy.Conductor conductor() {
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
        public static Optional<Metal> of(Glossy.Conductor conductor) {
            return Arrays.stream(values())
                    .filter(m -> m.conductor.equals(conductor))
                    .findFirst();
        }
    }
}
