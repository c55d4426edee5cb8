package enlightenment.material;

import enlightenment.check.Check;
import java.util.List;
import java.util.Objects;

/**
 * An opaque material whose normals a texture turns, as if it had fine relief (J. Cohen, M. Olano and D. Manocha, 1998).
 *
 * @param of the opaque material
 * @param map its linear components, from 0..1 to −1..1, are the normal's along u, along v upwards, and out of the surface: half, half, one is flat
 */
public record NormalMap(Material of, Texture map) implements Material {
    /** Validates the components, as {@link Material} states. */
    public NormalMap {
        Detail.check("of", of);
        Objects.requireNonNull(map, "map");
        Check.that(
                !(map instanceof Texture.File file) || file.encoding() == Texture.Encoding.LINEAR,
                "map",
                "must be a texture with \"encoding\": \"linear\": its numbers are directions, not colours");
    }

    @Override
    public Texture color() {
        return of.color();
    }

    @Override
    public List<Texture> textures() {
        return List.of(map);
    }

    @Override
    public List<Material> parts() {
        return List.of(of);
    }

    @Override
    public String type() {
        return "normalMap";
    }

    @Override
    public boolean isForClassicShading() {
        return false;
    }
}
