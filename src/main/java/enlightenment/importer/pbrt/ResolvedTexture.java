package enlightenment.importer.pbrt;

import enlightenment.color.Rgb;
import enlightenment.importer.support.UvMap;
import enlightenment.material.Texture;

/**
 * A texture of the scene.
 *
 * @param texture the texture
 * @param factor what it is to be multiplied by; 1 for a solid colour
 * @param uv the map from the surface's texture coordinates to those of the texture
 */
record ResolvedTexture(Texture texture, Rgb factor, UvMap uv) {
    static ResolvedTexture of(Rgb color) {
        return new ResolvedTexture(Texture.of(color), Rgb.WHITE, UvMap.IDENTITY);
    }

    boolean isSolid() {
        return texture instanceof Texture.Solid;
    }

    /** Of a solid one: its colour. */
    Rgb color() {
        return ((Texture.Solid) texture).color().linear();
    }

    ResolvedTexture times(Rgb by) {
        return isSolid() ? of(color().times(by)) : new ResolvedTexture(texture, factor.times(by), uv);
    }
}
