package enlightenment.world.material;

import enlightenment.bsdf.Bsdf;
import enlightenment.bsdf.ClassicDielectric;
import enlightenment.bsdf.Lambert;
import enlightenment.bsdf.Reradiation;
import enlightenment.bsdf.SmoothShading;
import enlightenment.bsdf.SpecularReflection;
import enlightenment.color.Rgb;
import enlightenment.material.Glass;
import enlightenment.material.Material;
import enlightenment.numeric.Exponential;
import enlightenment.primitive.Ray;
import enlightenment.texture.ImageTexture;
import java.util.Arrays;
import java.util.Collection;
import java.util.function.Predicate;

/** A material as shading reads it: plain fields, textures loaded. */
public final class SurfaceMaterial {
    /** The scattering function of the surface. */
    public final Bsdf bsdf;

    /** {@link #bsdf} where surfaces are shaded by normals of vertices; null for glass, which has its own ({@link enlightenment.bsdf.SmoothRefraction}). */
    public final Bsdf smooth;

    /** Whether the scattering function has delta lobes only: {@link Bsdf#isDelta}. */
    public final boolean isDelta;

    /** Whether it transmits light; then a solid of it is a medium. */
    public final boolean isGlass;

    /** The index of refraction; 1 unless it is glass. */
    public final double indexOfRefraction;

    /** The slope of the index of refraction by wavelength ({@link enlightenment.colorimetry.CauchyFormula#slope}); 0 in classic shading. */
    public final double dispersion;

    /** The transparency, 0..1: the share of light that comes through; 0 unless it is glass. */
    public final double transparency;

    /** The priority of a solid of glass: where several overlap, that of the highest fills the overlap; 0 unless it is glass. */
    public final int priority;

    /** Whether classic shadows show on the surface. */
    public final boolean receivesShadows;

    /** Whether it reflects nothing, so that paths end there. */
    public final boolean isBlack;

    /** Whether it emits light. */
    public final boolean glows;

    /** The sides that emit. */
    public final Material.EmissionPattern.Side sides;

    /** The emitted radiance, before the factor of {@link #radianceMap}: linear, by band. */
    public final double glowR;

    public final double glowG;
    public final double glowB;

    /** The emitted radiance of ultraviolet, before the factor of {@link #radianceMap}. */
    public final double glowUltraviolet;

    /** The texture by which emitted radiance is multiplied; null if it is constant. */
    public final RadianceMap radianceMap;

    /** The reradiation of a dye; null unless there is a dye that light of the scene excites. */
    public final Reradiation reradiation;

    /** Whether a solid of it attenuates light. */
    public final boolean absorbs;

    /** The extinction coefficient of a solid of it, by band, per unit of length of the frame: absorption and scattering. */
    private final double absorptionR;

    private final double absorptionG;
    private final double absorptionB;

    /** The scattering medium that fills a solid of it; null if it does not scatter. */
    public final HomogeneousMedium medium;

    private final Material description;

    /** The properties in physical shading; null for classic shading. */
    private final PhysicalSurface physical;

    private final TextureLookup texture;

    /** The detail that decides what the surface is made of at a point; null for most materials. */
    public final SurfaceDetail detail;

    /** The material of partly transparent glass where it is opaque; null if that is nowhere, and in classic shading. */
    public final SurfaceMaterial opaque;

    /** Makes a material of classic shading, whose colours are display-referred. */
    public SurfaceMaterial(Material material, ImageTexture image) {
        this(material, image, null);
    }

    /** Makes a material of physical shading, whose colours are linear, as those of the image must be. */
    public SurfaceMaterial(Material material, ImageTexture image, PhysicalSurface physical) {
        this(material, image, physical, null, null, null);
    }

    /**
     * Makes a material of physical shading that may have detail.
     *
     * @param detail decides what the surface is made of at a point; null for none
     * @param radianceMap the texture by which emitted radiance is multiplied; null if it is constant
     * @param opaque see {@link #opaque}
     */
    public SurfaceMaterial(
            Material material,
            ImageTexture image,
            PhysicalSurface physical,
            SurfaceDetail detail,
            RadianceMap radianceMap,
            SurfaceMaterial opaque) {
        this.detail = detail;
        this.opaque = opaque;
        this.radianceMap = radianceMap;
        description = material;
        receivesShadows = material.receivesShadows();
        if (material instanceof Glass glass) {
            bsdf = physical == null ? ClassicDielectric.INSTANCE : physical.bsdf();
            indexOfRefraction = glass.indexOfRefraction();
            transparency = glass.transparency();
            priority = glass.priority();
        } else if (material instanceof Material.Scattering scattering && physical != null) {
            bsdf = physical.bsdf();
            indexOfRefraction = scattering.indexOfRefraction();
            transparency = 1;
            priority = scattering.priority();
        } else {
            bsdf = physical == null ? opaque(material) : physical.bsdf();
            indexOfRefraction = 1;
            transparency = 0;
            priority = 0;
        }
        dispersion = physical == null ? 0 : physical.dispersion();
        isDelta = bsdf.isDelta();
        isGlass = bsdf.transmits();
        smooth = isGlass ? null : new SmoothShading(bsdf);
        texture = new TextureLookup(material.color(), image, physical != null);
        PhysicalSurface p = physical == null ? PhysicalSurface.NONE : physical;
        reradiation = p.reradiation();
        isBlack = detail == null && texture.isBlack() && reradiation == null && !bsdf.reflectsIfBlack();
        this.physical = physical;
        medium = p.medium();
        glowR = p.glow().r();
        glowG = p.glow().g();
        glowB = p.glow().b();
        glowUltraviolet = p.ultraviolet();
        glows = glowsVisibly() || glowUltraviolet > 0;
        sides = p.sides();
        absorptionR = p.absorption().r();
        absorptionG = p.absorption().g();
        absorptionB = p.absorption().b();
        absorbs = absorptionR > 0 || absorptionG > 0 || absorptionB > 0;
    }

    /** Whether it emits visible light. */
    public boolean glowsVisibly() {
        return glowR > 0 || glowG > 0 || glowB > 0;
    }

    /** The emitted radiance, before the factor of {@link #radianceMap}. */
    public Rgb glow() {
        return new Rgb(glowR, glowG, glowB);
    }

    /** Whether it, or a material that its detail may resolve to, satisfies a condition. */
    public boolean any(Predicate<SurfaceMaterial> such) {
        return detail == null
                ? such.test(this) || opaque != null && opaque.any(such)
                : Arrays.stream(detail.parts()).anyMatch(part -> part.any(such));
    }

    /** Whether any detail of it satisfies a condition. */
    private boolean anyDetail(Predicate<SurfaceDetail> such) {
        if (detail == null) {
            return opaque != null && opaque.anyDetail(such);
        }
        return such.test(detail) || Arrays.stream(detail.parts()).anyMatch(part -> part.anyDetail(such));
    }

    /** Adds the materials that it may resolve to: itself, or the parts of its detail. */
    void addTo(Collection<SurfaceMaterial> all) {
        if (detail == null) {
            all.add(this);
            if (opaque != null) {
                opaque.addTo(all);
            }
        } else {
            for (SurfaceMaterial part : detail.parts()) {
                part.addTo(all);
            }
        }
    }

    /** Whether it has an alpha mask. */
    boolean hasMask() {
        return anyDetail(SurfaceDetail::isMask);
    }

    /** Whether its colour or detail, or that of a material that it may resolve to, reads an image. */
    boolean readsImages() {
        return any(SurfaceMaterial::hasImage) || anyDetail(SurfaceDetail::hasImage);
    }

    /** Whether it changes shading normals by a texture. */
    public boolean turnsNormals() {
        return anyDetail(SurfaceDetail::turnsNormal);
    }

    /** Whether it emits to a side ({@link enlightenment.primitive.Hit#side}). */
    public boolean glowsTo(int side) {
        return switch (sides) {
            case BOTH -> true;
            case FRONT -> side == Ray.OUTSIDE;
            case BACK -> side == Ray.INSIDE;
        };
    }

    private static Bsdf opaque(Material material) {
        if (material instanceof Material.Matte) {
            return Lambert.INSTANCE;
        }
        if (material instanceof Material.Mirror) {
            return SpecularReflection.INSTANCE;
        }
        throw new AssertionError("no compiled form of the material " + material.type());
    }

    /** Whether the colour depends on texture coordinates. */
    public boolean isTextured() {
        return texture.isTextured();
    }

    /** The texture of the colour. */
    public TextureLookup texture() {
        return texture;
    }

    /** Whether the colour comes from an image. */
    public boolean hasImage() {
        return texture.hasImage();
    }

    /** Writes the colour of an untextured surface. */
    public void color(double[] rgb) {
        texture.color(rgb);
    }

    /**
     * Multiplies light by the transmittance of a solid of this material, by the law of Beer and Lambert.
     *
     * @param length of the segment, in the frame
     * @param rgb light by band
     */
    public void absorb(double length, double[] rgb) {
        rgb[0] *= Exponential.exp(-absorptionR * length);
        rgb[1] *= Exponential.exp(-absorptionG * length);
        rgb[2] *= Exponential.exp(-absorptionB * length);
    }

    /** The coefficients of absorption by band, per length in the frame. */
    public double[] absorption() {
        return new double[] {absorptionR, absorptionG, absorptionB};
    }

    /**
     * Writes the colour at texture coordinates.
     *
     * @param wraps whether u is periodic, so that 0 and 1 are the same place
     */
    public void color(double u, double v, boolean wraps, double[] rgb) {
        texture.color(u, v, wraps, rgb);
    }

    private String physicalLook() {
        return physical == null ? "" : physical.look() + " " + (radianceMap == null ? "" : radianceMap.look() + " ");
    }

    /** A text that is equal for materials that look the same, on every machine and wherever their image files are. */
    public String appearance() {
        if (detail != null) {
            return (radianceMap == null ? "" : radianceMap.look() + " ") + description.type() + " " + detail.look();
        }
        return physicalLook() + description.type() + " " + texture.look() + " " + receivesShadows + " "
                + indexOfRefraction + " " + transparency + " " + priority
                + (opaque == null ? "" : " or " + opaque.appearance());
    }
}
