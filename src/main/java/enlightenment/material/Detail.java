package enlightenment.material;

import enlightenment.check.Check;
import enlightenment.color.Color;
import enlightenment.color.Rgb;
import java.util.Objects;

/** What materials may be parts of others. */
final class Detail {
    private Detail() {}

    /** Opaque surfaces that do not glow. */
    static void check(String key, Material part) {
        Objects.requireNonNull(part, key);
        Check.that(
                !(part instanceof Material.Glass)
                        && !(part instanceof Material.Scattering)
                        && !(part instanceof Material.Fluorescent),
                key,
                "must be an opaque material that is not fluorescent, not " + part.type());
        Check.that(
                part.radiance().equals(Rgb.BLACK) && part.ultraviolet() == 0,
                key,
                "must be a material that does not glow");
    }

    /** The amount of a number at a key, which messages name. */
    static Amount amount(String key, double value) {
        Check.range(key, value, 0, 1);
        return Amount.of(value);
    }

    /** The amount of a texture at a key, which messages name. */
    static Amount amount(String key, Texture texture) {
        checkShare(key, Objects.requireNonNull(texture, key));
        return Amount.of(texture);
    }

    /** A number in 0..1, or numbers of a texture. */
    static void checkShare(String key, Texture share) {
        if (share instanceof Texture.Solid solid) {
            check(key, solid.color());
        } else if (share instanceof Texture.Checker checker) {
            checker.colors().forEach(c -> check(key, c));
        }
    }

    private static void check(String key, Color color) {
        Check.range(key, color.linear().max(), 0, 1);
    }
}
