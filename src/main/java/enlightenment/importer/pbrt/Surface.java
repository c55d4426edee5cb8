package enlightenment.importer.pbrt;

import enlightenment.importer.support.UvMap;
import enlightenment.material.Material;
import enlightenment.material.Texture;

/**
 * What a material becomes.
 *
 * @param material the material; null for an interface, which light passes
 * @param uv the map from the surface's texture coordinates to those of its textures
 * @param isThinGlass whether it is glass without an inside, for surfaces that enclose none
 */
record Surface(Material material, UvMap uv, boolean isThinGlass) {
    static final Surface INTERFACE = new Surface(null, UvMap.IDENTITY, false);

    static Surface of(Material material) {
        return new Surface(material, UvMap.IDENTITY, false);
    }

    boolean isInterface() {
        return material == null;
    }

    /** Whether texture coordinates matter. */
    boolean isTextured() {
        return material != null && isTextured(material);
    }

    static boolean isTextured(Material m) {
        return !(m.color() instanceof Texture.Solid)
                || m.textures().stream().anyMatch(t -> !(t instanceof Texture.Solid))
                || m.parts().stream().anyMatch(Surface::isTextured);
    }

    Surface with(Material other) {
        return new Surface(other, uv, isThinGlass);
    }
}
