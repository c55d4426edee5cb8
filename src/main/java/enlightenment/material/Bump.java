package enlightenment.material;

import enlightenment.check.Check;
import java.util.List;
import java.util.Objects;

/**
 * An opaque material that is shaded as if it were higher in places (J. Blinn, "Simulation of wrinkled surfaces", 1978).
 *
 * @param of the opaque material
 * @param map the mean of its linear components, 0..1, is the height; only images have slopes
 * @param height what 1 is in scene units; negative for dents
 */
public record Bump(Material of, Texture map, double height) implements Material {
    /** Validates the components, as {@link Material} states. */
    public Bump {
        Detail.check("of", of);
        Objects.requireNonNull(map, "map");
        Check.that(map instanceof Texture.File, "map", "must be a texture that is a file: no other has slopes");
        Check.finite("height", height);
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
        return "bump";
    }

    @Override
    public boolean isForClassicShading() {
        return false;
    }
}
