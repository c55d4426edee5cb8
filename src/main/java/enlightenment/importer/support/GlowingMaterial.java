package enlightenment.importer.support;

import enlightenment.color.Rgb;
import enlightenment.material.Coated;
import enlightenment.material.Glossy;
import enlightenment.material.Material;
import enlightenment.material.Principled;
import enlightenment.material.Texture;
import java.util.Optional;

/** Materials of lamps: what a surface is made of, and what it emits besides. */
public final class GlowingMaterial {
    private static final Material BLACK = Material.Matte.of(Texture.of(Rgb.BLACK));

    private GlowingMaterial() {}

    /** A surface that emits and reflects nothing. */
    public static Material black(Rgb radiance, Material.EmissionPattern pattern) {
        return of(BLACK, radiance, pattern).orElseThrow();
    }

    /** Whether a surface reflects nothing, but for what it may emit. */
    public static boolean isBlack(Material m) {
        return m instanceof Material.Matte matte
                && matte.color() instanceof Texture.Solid s
                && s.color().linear().max() == 0;
    }

    /**
     * A surface that emits light besides.
     *
     * @return empty if surfaces of this kind cannot emit: glass, media, and what is made of other materials
     */
    public static Optional<Material> of(Material m, Rgb radiance, Material.EmissionPattern pattern) {
        if (m instanceof Material.Matte d) {
            return Optional.of(new Material.Matte(
                    d.color(), d.receivesShadows(), d.roughness(), radiance, d.ultraviolet(), pattern));
        } else if (m instanceof Material.Mirror d) {
            return Optional.of(new Material.Mirror(d.color(), d.receivesShadows(), radiance, d.ultraviolet(), pattern));
        } else if (m instanceof Glossy g) {
            return Optional.of(new Glossy(
                    g.color(),
                    g.roughness(),
                    g.conductor(),
                    g.multipleScattering(),
                    radiance,
                    g.ultraviolet(),
                    pattern));
        } else if (m instanceof Coated c) {
            return Optional.of(new Coated(
                    c.color(),
                    c.roughness(),
                    c.indexOfRefraction(),
                    c.nonlinear(),
                    radiance,
                    c.ultraviolet(),
                    pattern));
        } else if (m instanceof Principled p) {
            return Optional.of(new Principled(
                    p.color(),
                    p.metallic(),
                    p.roughness(),
                    p.indexOfRefraction(),
                    p.specular(),
                    p.clearcoat(),
                    p.sheen(),
                    radiance,
                    p.ultraviolet(),
                    pattern));
        }
        return Optional.empty();
    }

    /** A material that emits, to other sides. */
    public static Material withSide(Material glowing, Material.EmissionPattern.Side side) {
        return of(glowing, glowing.radiance(), glowing.pattern().withSide(side)).orElseThrow();
    }
}
