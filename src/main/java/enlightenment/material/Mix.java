package enlightenment.material;

import enlightenment.color.Rgb;
import java.util.List;
import java.util.Objects;

/**
 * Two opaque materials in one place: at each point light finds the one or the other by chance.
 *
 * @param first what it is where the weight is 0
 * @param second what it is where the weight is 1
 * @param weight the probability of the second
 */
public record Mix(Material first, Material second, Amount weight) implements Material {
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
