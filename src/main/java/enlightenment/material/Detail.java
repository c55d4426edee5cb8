package enlightenment.material;

import enlightenment.check.Check;
import enlightenment.check.Radiance;
import enlightenment.color.Color;
import enlightenment.color.Rgb;
import java.util.List;
import java.util.Objects;
import java.util.Optional;
import java.util.stream.Stream;

/** What materials may be parts of others. */
final class Detail {
    private static final String RADIANCE_MAP = "radianceMap";

    private Detail() {}

    /** Opaque surfaces that do not glow. */
    static void check(String key, Material part) {
        Objects.requireNonNull(part, key);
        Check.that(
                !(part instanceof Glass)
                        && !(part instanceof Material.Scattering)
                        && !(part instanceof Material.Fluorescent),
                key,
                "must be an opaque material that is not fluorescent, not " + part.type());
        Check.that(part.radiance().isBlack() && part.ultraviolet() == 0, key, "must be a material that does not glow");
    }

    /** The amount of a number at a key, which messages name. */
    static Texture.Amount amount(String key, double value) {
        Check.range(key, value, 0, 1);
        return Texture.Amount.of(value);
    }

    /** The amount of a texture at a key, which messages name. */
    static Texture.Amount amount(String key, Texture texture) {
        checkShare(key, Objects.requireNonNull(texture, key));
        return Texture.Amount.of(texture);
    }

    /** A number in 0..1, or numbers of a texture. */
    static void checkShare(String key, Texture share) {
        if (share instanceof Texture.Solid solid) {
            check(key, solid.color());
        } else if (share instanceof Texture.Checker checker) {
            checker.colors().forEach(c -> check(key, c));
        }
    }

    /** A texture, or one side alone, only of what glows; what its colours make of the radiance is no more than may be emitted. */
    static void checkRadiance(Rgb radiance, double ultraviolet, Material.EmissionPattern pattern) {
        boolean glows = !radiance.isBlack() || ultraviolet > 0;
        Check.that(
                glows || pattern.side() == Material.EmissionPattern.Side.BOTH,
                "radianceSide",
                "must stand with \"radiance\" or \"ultraviolet\", which are emitted to that side");
        pattern.map().ifPresent(texture -> {
            Check.that(
                    glows,
                    RADIANCE_MAP,
                    "must stand with \"radiance\" or \"ultraviolet\", which it is multiplied onto");
            if (texture instanceof Texture.Solid solid) {
                checkRadiance(radiance, ultraviolet, solid.color());
            } else if (texture instanceof Texture.Checker checker) {
                checker.colors().forEach(c -> checkRadiance(radiance, ultraviolet, c));
            }
        });
    }

    private static void checkRadiance(Rgb radiance, double ultraviolet, Color factor) {
        Rgb c = factor.linear();
        double most = Math.max(Math.max(radiance.r() * c.r(), radiance.g() * c.g()), radiance.b() * c.b());
        Check.that(
                Math.max(most, ultraviolet * c.b()) <= Radiance.LARGEST,
                RADIANCE_MAP,
                "times the radiance must be at most 1e100");
    }

    /** All of these. */
    static List<Texture> textures(List<Texture> some, Optional<Texture> other) {
        return Stream.concat(some.stream(), other.stream()).toList();
    }

    private static void check(String key, Color color) {
        Check.range(key, color.linear().max(), 0, 1);
    }
}
