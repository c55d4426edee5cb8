package enlightenment.world.material;

import enlightenment.bsdf.Bsdf;
import enlightenment.bsdf.ClassicDielectric;
import enlightenment.bsdf.Lambert;
import enlightenment.bsdf.Reradiation;
import enlightenment.bsdf.SmoothShading;
import enlightenment.bsdf.SpecularReflection;
import enlightenment.color.Color;
import enlightenment.color.DisplayRgb;
import enlightenment.color.Rgb;
import enlightenment.material.Material;
import enlightenment.material.Texture;
import enlightenment.primitive.Ray;
import enlightenment.texture.ImageTexture;

/** A material as shading reads it: plain fields, textures loaded. */
public final class SurfaceMaterial {
    /** How the surface scatters light. */
    public final Bsdf bsdf;

    /** {@link #bsdf} where surfaces are shaded by normals of vertices; null for glass, which refracts by the normals of its triangles. */
    public final Bsdf smooth;

    /** Whether all that it scatters goes in single directions: {@link Bsdf#isDelta}. */
    public final boolean isDelta;

    /** Whether light passes through it; then a solid of it is a medium. */
    public final boolean isGlass;

    /** The index of refraction; 1 unless it is glass. */
    public final double indexOfRefraction;

    /**
     * How much the index grows with the place of the wavelength ({@link enlightenment.color.CauchyFormula#slope}); 0 in classic shading.
     */
    public final double dispersion;

    /** The share of what is seen that comes through, 0..1; 0 unless it is glass. */
    public final double transparency;

    /** Which of several overlapping solids fills the overlap: the one of highest priority; 0 unless it is glass. */
    public final int priority;

    /** Whether shadows show on the surface. */
    public final boolean receivesShadows;

    /** Whether it reflects nothing, so that paths end there. */
    public final boolean isBlack;

    /** Whether it emits light. */
    public final boolean glows;

    /** Whether it emits from the side that its normal points away from as well. */
    public final boolean glowsInside;

    /** The radiance that it emits: linear, by band. */
    public final double glowR;

    public final double glowG;
    public final double glowB;

    /** The same of ultraviolet. */
    public final double glowUltraviolet;

    /** What a dye makes of light that is not reflected; null unless there is one that light in the scene makes shine. */
    public final Reradiation reradiation;

    /** Whether a solid of it takes light away on a straight way. */
    public final boolean absorbs;

    /** How much of it per unit of length of the frame, by band: what it absorbs, and what it scatters. */
    private final double absorptionR;

    private final double absorptionG;
    private final double absorptionB;

    /** What fills a solid of it, if that scatters light; else null. */
    public final HomogeneousMedium medium;

    private final Material description;

    /** What physical shading adds to the look of the material, as text. */
    private final String look;

    private final double r;
    private final double g;
    private final double b;
    private final double[] other;
    private final double checks;
    private final ImageTexture image;
    private final boolean bilinear;

    /** A material of classic shading, whose colours are display-referred. */
    public SurfaceMaterial(Material material, ImageTexture image) {
        this(material, image, null);
    }

    /** A material of physical shading, whose colours are linear, as those of the image must be. */
    public SurfaceMaterial(Material material, ImageTexture image, PhysicalSurface physical) {
        this.image = image;
        description = material;
        receivesShadows = material.receivesShadows();
        if (material instanceof Material.Glass glass) {
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
        Texture texture = material.color();
        double[] first = {0, 0, 0};
        double[] second = null;
        double scale = 0;
        boolean smooth = false;
        if (texture instanceof Texture.Solid solid) {
            first = numbers(solid.color(), physical);
        } else if (texture instanceof Texture.Checker checker) {
            first = numbers(checker.colors().get(0), physical);
            second = numbers(checker.colors().get(1), physical);
            scale = checker.scale();
        } else if (texture instanceof Texture.File file) {
            smooth = file.filter() == Texture.Filter.BILINEAR;
        } else {
            throw new AssertionError("no compiled form of the texture " + texture);
        }
        r = first[0];
        g = first[1];
        b = first[2];
        other = second;
        checks = scale;
        bilinear = smooth;
        PhysicalSurface p = physical == null ? PhysicalSurface.NONE : physical;
        reradiation = p.reradiation();
        isBlack = texture instanceof Texture.Solid
                && r == 0
                && g == 0
                && b == 0
                && reradiation == null
                && !bsdf.reflectsIfBlack();
        look = physical == null ? "" : p.look() + " ";
        medium = p.medium();
        glowR = p.glow().r();
        glowG = p.glow().g();
        glowB = p.glow().b();
        glowUltraviolet = p.ultraviolet();
        glows = glowsVisibly() || glowUltraviolet > 0;
        glowsInside = p.glowsInside();
        absorptionR = p.absorption().r();
        absorptionG = p.absorption().g();
        absorptionB = p.absorption().b();
        absorbs = absorptionR > 0 || absorptionG > 0 || absorptionB > 0;
    }

    private static double[] numbers(Color color, PhysicalSurface physical) {
        if (physical == null) {
            DisplayRgb c = color.display();
            return new double[] {c.r(), c.g(), c.b()};
        }
        Rgb c = color.linear();
        return new double[] {c.r(), c.g(), c.b()};
    }

    /** Whether it emits visible light. */
    public boolean glowsVisibly() {
        return glowR > 0 || glowG > 0 || glowB > 0;
    }

    /** The radiance that it emits. */
    public Rgb glow() {
        return new Rgb(glowR, glowG, glowB);
    }

    /** Whether it emits to a side ({@link enlightenment.primitive.Hit#side}). */
    public boolean glowsTo(int side) {
        return glowsInside || side == Ray.OUTSIDE;
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
        return image != null || other != null;
    }

    /** Whether the colour comes from an image. */
    public boolean hasImage() {
        return image != null;
    }

    /** Writes the colour of an untextured surface. */
    public void color(double[] rgb) {
        rgb[0] = r;
        rgb[1] = g;
        rgb[2] = b;
    }

    /**
     * Multiplies light by what is left of it after a straight way through a solid of this material: Beer's law.
     *
     * @param length of the way, in units of the frame
     * @param rgb light by band
     */
    public void absorb(double length, double[] rgb) {
        rgb[0] *= StrictMath.exp(-absorptionR * length);
        rgb[1] *= StrictMath.exp(-absorptionG * length);
        rgb[2] *= StrictMath.exp(-absorptionB * length);
    }

    /**
     * Writes the colour at texture coordinates.
     *
     * @param wraps whether u is periodic, so that 0 and 1 are the same place
     */
    public void color(double u, double v, boolean wraps, double[] rgb) {
        if (image != null) {
            if (bilinear) {
                image.bilinear(u, v, wraps, rgb);
            } else {
                image.nearest(u, v, rgb);
            }
        } else if (other != null && odd(u) != odd(v)) {
            rgb[0] = other[0];
            rgb[1] = other[1];
            rgb[2] = other[2];
        } else {
            color(rgb);
        }
    }

    private boolean odd(double coordinate) {
        // The far edge belongs to the last square.
        double square = Math.min(Math.floor(coordinate * checks), Math.ceil(checks) - 1);
        return ((long) square & 1) != 0;
    }

    /** A text that is equal for materials that look the same, on every machine and wherever their image files are. */
    public String appearance() {
        Texture texture = description.color();
        String color = texture instanceof Texture.File file
                ? "image " + image.fingerprint() + " " + file.filter() + " " + file.encoding()
                : texture.toString();
        return look + description.type() + " " + color + " " + receivesShadows + " " + indexOfRefraction + " "
                + transparency + " " + priority;
    }
}
