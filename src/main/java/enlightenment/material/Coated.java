package enlightenment.material;

import enlightenment.check.Check;
import enlightenment.check.Radiance;
import enlightenment.color.Rgb;
import java.util.List;
import java.util.Objects;

/**
 * A matte surface under a dielectric coat, such as plastic, varnished wood or glazed clay: the coat reflects by Fresnel's equations, and what
 * enters it is reflected by the base. Only physical shading has it.
 *
 * @param color the reflectance of the base
 * @param roughness of the coat, 0 (smooth) to 1; the parameter alpha of the distribution GGX is its square
 * @param indexOfRefraction of the coat, relative to the surrounding medium: 1 (as without a coat) to {@value #LARGEST_INDEX}
 * @param nonlinear whether light that goes to and fro between coat and base is coloured by the base each time, which saturates its colour
 * @param radiance see {@link Material#radiance}
 * @param ultraviolet see {@link Material#ultraviolet}
 * @param pattern see {@link Material#pattern}
 */
public record Coated(
        Texture color,
        Texture.Amount roughness,
        double indexOfRefraction,
        boolean nonlinear,
        Rgb radiance,
        double ultraviolet,
        Material.EmissionPattern pattern)
        implements Material {
    /** The index of refraction unless another one is given: that of most plastics and varnishes. */
    public static final double USUAL_INDEX = 1.5;

    /** The largest index of refraction: no transparent matter has more. */
    public static final double LARGEST_INDEX = 10;

    /** Validates the components, as {@link Material} states. */
    public Coated {
        Reflectance.check(color);
        Objects.requireNonNull(roughness, "roughness");
        Check.range("indexOfRefraction", indexOfRefraction, 1, LARGEST_INDEX);
        Radiance.check("radiance", radiance.max());
        Radiance.check("ultraviolet", ultraviolet);
        Detail.checkRadiance(radiance, ultraviolet, pattern);
    }

    /** A surface whose points glow alike, if at all. */
    public Coated(
            Texture color,
            Texture.Amount roughness,
            double indexOfRefraction,
            boolean nonlinear,
            Rgb radiance,
            double ultraviolet) {
        this(color, roughness, indexOfRefraction, nonlinear, radiance, ultraviolet, Material.EmissionPattern.EVEN);
    }

    /** A surface whose coat has the same roughness everywhere. */
    public Coated(
            Texture color,
            double roughness,
            double indexOfRefraction,
            boolean nonlinear,
            Rgb radiance,
            double ultraviolet) {
        this(color, Detail.amount("roughness", roughness), indexOfRefraction, nonlinear, radiance, ultraviolet);
    }

    /** This surface, whose coat has another roughness. */
    public Coated withRoughness(Texture.Amount value) {
        return new Coated(color, value, indexOfRefraction, nonlinear, radiance, ultraviolet, pattern);
    }

    @Override
    public List<Texture> textures() {
        return Detail.textures(roughness.textures(), radianceMap());
    }

    /** A surface of this colour with a coat of index 1.5 that does not glow. */
    public static Coated of(Texture color, double roughness) {
        return new Coated(color, roughness, USUAL_INDEX, false, Rgb.BLACK, 0);
    }

    @Override
    public String type() {
        return "coated";
    }

    @Override
    public boolean isForClassicShading() {
        return false;
    }
}
