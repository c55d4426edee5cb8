package enlightenment.material;

import enlightenment.check.Check;
import enlightenment.check.Radiance;
import enlightenment.color.Rgb;
import java.util.ArrayList;
import java.util.List;
import java.util.Objects;

/**
 * The opaque material of metallic-roughness workflows: a metal, or a matte base under a dielectric coat, or a mixture of both; over it, a
 * clear coat. It holds what glTF 2.0 describes, and the opaque part of Blender's Principled BSDF (B. Burley, "Physically based shading at
 * Disney", 2012). Only physical shading has it.
 *
 * @param color the base colour: reflectance of the matte base, and of the metal where it is looked at and lit straight on (Schlick's Fresnel
 *     term leads from there to white at grazing angles)
 * @param metallic the share of metal: 0 (a dielectric) to 1
 * @param roughness of metal and coat, 0 (smooth) to 1; the parameter alpha of the distribution GGX is its square
 * @param indexOfRefraction of the coat, relative to the surrounding medium: 1 (as without a coat) to {@value Coated#LARGEST_INDEX}
 * @param specular what the coat's reflectance at normal incidence is multiplied by, 0 (as without a coat) to 1; it is rendered as the coat
 *     of the index that has this reflectance
 * @param clearcoat the clear coat over it
 * @param sheen the sheen of the dielectric part
 * @param radiance see {@link Material#radiance}
 * @param ultraviolet see {@link Material#ultraviolet}
 * @param pattern see {@link Material#pattern}
 */
public record Principled(
        Texture color,
        Texture.Amount metallic,
        Texture.Amount roughness,
        double indexOfRefraction,
        double specular,
        Clearcoat clearcoat,
        Sheen sheen,
        Rgb radiance,
        double ultraviolet,
        Material.EmissionPattern pattern)
        implements Material {
    /** The roughness unless another one is given. */
    public static final double USUAL_ROUGHNESS = 0.5;

    /**
     * A clear coat of index {@value Coated#USUAL_INDEX}.
     *
     * @param share the share of the surface that is under it, 0 (no coat) to 1
     * @param roughness of the coat, as {@link Principled#roughness}
     */
    public record Clearcoat(double share, Texture.Amount roughness) {
        /** No clear coat. */
        public static final Clearcoat NONE = new Clearcoat(0, Texture.Amount.of(0));

        /** Validates the components, as {@link Material} states. */
        public Clearcoat {
            Check.range("clearcoat", share, 0, 1);
            Objects.requireNonNull(roughness, "clearcoatRoughness");
        }

        /** This coat with another roughness. */
        public Clearcoat withRoughness(Texture.Amount value) {
            return new Clearcoat(share, value);
        }
    }

    /**
     * Light that fibres on cloth reflect along the surface, as a part of what is not metal.
     *
     * @param share what Burley's lobe of sheen is multiplied by, 0 (no sheen) to 1
     * @param tint how much of the surface's colour the sheen has, 0 (white) to 1; the colour's largest component counts as 1
     */
    public record Sheen(double share, double tint) {
        /** No sheen. */
        public static final Sheen NONE = new Sheen(0, 0);

        /** Validates the components, as {@link Material} states. */
        public Sheen {
            Check.range("sheen", share, 0, 1);
            Check.range("sheenTint", tint, 0, 1);
        }
    }

    /** Validates the components, as {@link Material} states. */
    public Principled {
        Reflectance.check(color);
        Objects.requireNonNull(metallic, "metallic");
        Objects.requireNonNull(roughness, "roughness");
        Check.range("indexOfRefraction", indexOfRefraction, 1, Coated.LARGEST_INDEX);
        Check.range("specular", specular, 0, 1);
        Objects.requireNonNull(clearcoat, "clearcoat");
        Objects.requireNonNull(sheen, "sheen");
        Radiance.check("radiance", radiance.max());
        Radiance.check("ultraviolet", ultraviolet);
        Detail.checkRadiance(radiance, ultraviolet, pattern);
    }

    /** A surface whose points glow alike, if at all. */
    public Principled(
            Texture color,
            Texture.Amount metallic,
            Texture.Amount roughness,
            double indexOfRefraction,
            double specular,
            Clearcoat clearcoat,
            Sheen sheen,
            Rgb radiance,
            double ultraviolet) {
        this(
                color,
                metallic,
                roughness,
                indexOfRefraction,
                specular,
                clearcoat,
                sheen,
                radiance,
                ultraviolet,
                Material.EmissionPattern.EVEN);
    }

    /** A surface of index 1.5 without a clear coat that does not glow. */
    public static Principled of(Texture color, double metallic, double roughness) {
        return new Principled(
                color,
                Detail.amount("metallic", metallic),
                Detail.amount("roughness", roughness),
                Coated.USUAL_INDEX,
                1,
                Clearcoat.NONE,
                Sheen.NONE,
                Rgb.BLACK,
                0);
    }

    /** This surface with another share of metal. */
    public Principled withMetallic(Texture.Amount value) {
        return with(value, roughness, clearcoat, sheen, pattern);
    }

    /** This surface with another roughness. */
    public Principled withRoughness(Texture.Amount value) {
        return with(metallic, value, clearcoat, sheen, pattern);
    }

    /** This surface, whose radiance is multiplied by a texture. */
    public Principled withRadianceMap(Texture value) {
        return with(metallic, roughness, clearcoat, sheen, pattern.withMap(value));
    }

    /** This surface under another clear coat. */
    public Principled withClearcoat(Clearcoat value) {
        return with(metallic, roughness, value, sheen, pattern);
    }

    /** This surface under a clear coat of one roughness everywhere. */
    public Principled withClearcoat(double share, double roughnessOfIt) {
        return withClearcoat(new Clearcoat(share, Detail.amount("clearcoatRoughness", roughnessOfIt)));
    }

    /** This surface with another sheen. */
    public Principled withSheen(double share, double tint) {
        return with(metallic, roughness, clearcoat, new Sheen(share, tint), pattern);
    }

    private Principled with(
            Texture.Amount metal,
            Texture.Amount rough,
            Clearcoat clear,
            Sheen fibres,
            Material.EmissionPattern emission) {
        return new Principled(
                color, metal, rough, indexOfRefraction, specular, clear, fibres, radiance, ultraviolet, emission);
    }

    @Override
    public List<Texture> textures() {
        List<Texture> all = new ArrayList<>(metallic.textures());
        all.addAll(roughness.textures());
        all.addAll(clearcoat.roughness().textures());
        radianceMap().ifPresent(all::add);
        return List.copyOf(all);
    }

    @Override
    public String type() {
        return "principled";
    }

    @Override
    public boolean isForClassicShading() {
        return false;
    }
}
