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
