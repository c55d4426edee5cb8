package enlightenment.material;

import enlightenment.check.Radiance;
import enlightenment.color.Rgb;
import java.util.List;
import java.util.Objects;
import java.util.Optional;

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
        Amount roughness,
        Optional<Conductor> conductor,
        boolean multipleScattering,
        Rgb radiance,
        double ultraviolet,
        EmissionPattern pattern)
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
            Amount roughness,
            Optional<Conductor> conductor,
            boolean multipleScattering,
            Rgb radiance,
            double ultraviolet) {
        this(color, roughness, conductor, multipleScattering, radiance, ultraviolet, EmissionPattern.EVEN);
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
    public Glossy withRoughness(Amount value) {
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
}
