package enlightenment.compiled;

import enlightenment.bsdf.Bsdf;
import enlightenment.bsdf.ClassicDielectric;
import enlightenment.bsdf.Lambert;
import enlightenment.bsdf.SpecularReflection;
import enlightenment.color.DisplayRgb;
import enlightenment.material.Material;
import enlightenment.material.Texture;
import enlightenment.texture.ImageTexture;

/** A material as shading reads it: plain fields, textures loaded. */
public final class SurfaceMaterial {
    /** How the surface scatters light. */
    public final Bsdf bsdf;

    /** Whether all that it scatters goes in single directions: {@link Bsdf#isDelta}. */
    public final boolean isDelta;

    /** Whether light passes through it; then a solid of it is a medium. */
    public final boolean isGlass;

    /** The index of refraction; 1 unless it is glass. */
    public final double indexOfRefraction;

    /** The share of what is seen that comes through, 0..1; 0 unless it is glass. */
    public final double transparency;

    /** Which of several overlapping solids fills the overlap: the one of highest priority; 0 unless it is glass. */
    public final int priority;

    /** Whether shadows show on the surface. */
    public final boolean receivesShadows;

    private final Material description;
    private final double r;
    private final double g;
    private final double b;
    private final DisplayRgb other;
    private final double checks;
    private final ImageTexture image;
    private final boolean bilinear;

    SurfaceMaterial(Material material, ImageTexture image) {
        this.image = image;
        description = material;
        receivesShadows = material.receivesShadows();
        if (material instanceof Material.Glass glass) {
            bsdf = ClassicDielectric.INSTANCE;
            indexOfRefraction = glass.indexOfRefraction();
            transparency = glass.transparency();
            priority = glass.priority();
        } else {
            bsdf = opaque(material);
            indexOfRefraction = 1;
            transparency = 0;
            priority = 0;
        }
        isDelta = bsdf.isDelta();
        isGlass = bsdf.transmits();
        Texture texture = material.color();
        DisplayRgb first = DisplayRgb.BLACK;
        DisplayRgb second = null;
        double scale = 0;
        boolean smooth = false;
        if (texture instanceof Texture.Solid solid) {
            first = solid.color().display();
        } else if (texture instanceof Texture.Checker checker) {
            first = checker.colors().get(0).display();
            second = checker.colors().get(1).display();
            scale = checker.scale();
        } else if (texture instanceof Texture.File file) {
            smooth = file.filter() == Texture.Filter.BILINEAR;
        } else {
            throw new AssertionError("no compiled form of the texture " + texture);
        }
        r = first.r();
        g = first.g();
        b = first.b();
        other = second;
        checks = scale;
        bilinear = smooth;
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
            rgb[0] = other.r();
            rgb[1] = other.g();
            rgb[2] = other.b();
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
    String appearance() {
        Texture texture = description.color();
        String color = texture instanceof Texture.File file
                ? "image " + image.fingerprint() + " " + file.filter() + " " + file.encoding()
                : texture.toString();
        return description.type() + " " + color + " " + receivesShadows + " " + indexOfRefraction + " " + transparency
                + " " + priority;
    }
}
