package enlightenment.material;

import java.util.List;
import java.util.Objects;

/**
 * An opaque material with holes, such as leaves on a rectangle: where there is one, light passes as if nothing were there.
 *
 * @param of the opaque material
 * @param map the probability that something is there: 0 is a hole
 */
public record Mask(Material of, Amount map) implements Material {
    /** Validates the components, as {@link Material} states. */
    public Mask {
        Detail.check("of", of);
        Objects.requireNonNull(map, "map");
    }

    /** A mask by the mean of a texture's linear components. */
    public Mask(Material of, Texture map) {
        this(of, Detail.amount("map", map));
    }

    @Override
    public Texture color() {
        return of.color();
    }

    @Override
    public List<Texture> textures() {
        return map.textures();
    }

    @Override
    public List<Material> parts() {
        return List.of(of);
    }

    @Override
    public String type() {
        return "mask";
    }

    @Override
    public boolean isForClassicShading() {
        return false;
    }
}
