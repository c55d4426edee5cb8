package enlightenment.material;

import enlightenment.check.Check;
import enlightenment.color.Rgb;
import java.util.List;
import java.util.Objects;

/**
 * A material that is made of others: a mixture of two, or one with holes or relief. An immutable description; what it is made of is opaque, is not
 * fluorescent and does not glow.
 */
public sealed interface Composite extends Material
        permits Composite.Mix, Composite.Mask, Composite.NormalMap, Composite.Bump {

    /**
     * Two opaque materials in one place: at each point light finds the one or the other by chance.
     *
     * @param first what it is where the weight is 0
     * @param second what it is where the weight is 1
     * @param weight the probability of the second
     */
    record Mix(Material first, Material second, Texture.Amount weight) implements Composite {
        /** Validates the components, as {@link Material} states. */
        public Mix {
            Detail.check("materials/0", first);
            Detail.check("materials/1", second);
            Objects.requireNonNull(weight, "weight");
        }

        /** A mix by the mean of a texture's linear components. */
        public Mix(Material first, Material second, Texture weight) {
            this(first, second, Detail.amount("weight", weight));
        }

        @Override
        public Texture color() {
            return first.color();
        }

        @Override
        public List<Texture> textures() {
            return weight.textures();
        }

        @Override
        public List<Material> parts() {
            return List.of(first, second);
        }

        @Override
        public Rgb radiance() {
            return Rgb.BLACK;
        }

        @Override
        public String type() {
            return "mix";
        }

        @Override
        public boolean isForClassicShading() {
            return false;
        }
    }

    /**
     * An opaque material with holes, such as leaves on a rectangle: where there is one, light passes as if nothing were there.
     *
     * @param of the opaque material
     * @param map the probability that something is there: 0 is a hole
     */
    record Mask(Material of, Texture.Amount map) implements Composite {
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

    /**
     * An opaque material whose normals a texture turns, as if it had fine relief (J. Cohen, M. Olano and D. Manocha, 1998).
     *
     * @param of the opaque material
     * @param map its linear components, from 0..1 to −1..1, are the normal's along u, along v upwards, and out of the surface: half, half, one is flat
     */
    record NormalMap(Material of, Texture map) implements Composite {
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

    /**
     * An opaque material that is shaded as if it were higher in places (J. Blinn, "Simulation of wrinkled surfaces", 1978).
     *
     * @param of the opaque material
     * @param map the mean of its linear components, 0..1, is the height; only images have slopes
     * @param height what 1 is in scene units; negative for dents
     */
    record Bump(Material of, Texture map, double height) implements Composite {
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
}
