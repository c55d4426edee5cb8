package enlightenment.importer.gltf;

import enlightenment.importer.support.UvMap;
import java.io.IOException;

/**
 * Which texture coordinates of a mesh a texture uses, and what is made of them, where v points downwards.
 *
 * @param set the number of the set, as in TEXCOORD_0
 */
record TextureFrame(int set, UvMap map) {
    private static final int MOST_SETS = 16;

    /** That of a {@code textureInfo}, by KHR_texture_transform: scaled, then turned, then moved. */
    static TextureFrame of(GltfElement info) throws IOException {
        GltfElement t = info.extension("KHR_texture_transform");
        long set = t.whole("texCoord", info.whole("texCoord", 0));
        if (set >= MOST_SETS) {
            throw info.failure("has the texCoord " + set + "; there are at most " + MOST_SETS);
        }
        double[] offset = t.numbers("offset", 0, 0);
        double[] scale = t.numbers("scale", 1, 1);
        double angle = t.number("rotation", 0);
        double cos = StrictMath.cos(angle);
        double sin = StrictMath.sin(angle);
        // Counterclockwise where v points downwards.
        return new TextureFrame(
                (int) set,
                new UvMap(cos * scale[0], sin * scale[1], offset[0], -sin * scale[0], cos * scale[1], offset[1]));
    }
}
