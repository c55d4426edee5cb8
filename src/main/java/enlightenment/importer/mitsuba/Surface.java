package enlightenment.importer.mitsuba;

import enlightenment.importer.support.UvMap;
import enlightenment.material.Glass;
import enlightenment.material.Material;
import enlightenment.material.Texture;
import java.util.Optional;

/**
 * What a bsdf becomes.
 *
 * @param material the material; empty if light passes as if nothing were there
 * @param map what its textures do to texture coordinates
 * @param isThin whether it stands for a thin pane
 */
record Surface(Optional<Material> material, UvMap map, boolean isThin) {
    /** Whether it has textures, so that texture coordinates count. */
    boolean isTextured() {
        return material.map(Surface::isTextured).orElse(false);
    }

    private static boolean isTextured(Material m) {
        return !(m.color() instanceof Texture.Solid)
                || m.textures().stream().anyMatch(t -> !(t instanceof Texture.Solid))
                || m.parts().stream().anyMatch(Surface::isTextured);
    }

    /** Whether its material fills a solid. */
    boolean fillsSolid() {
        return material.filter(m -> m instanceof Glass || m instanceof Material.Scattering)
                .isPresent();
    }
}
