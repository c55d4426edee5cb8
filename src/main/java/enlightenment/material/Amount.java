package enlightenment.material;

import enlightenment.check.Check;
import enlightenment.color.Rgb;
import java.util.List;
import java.util.Objects;

/**
 * A number in 0..1 that may depend on the place: one number everywhere, or numbers of a texture. An immutable description.
 *
 * <p>The constructors throw {@link enlightenment.math.InvalidValueException} for a value out of range, and {@link NullPointerException}
 * for a missing one.
 */
public sealed interface Amount permits Amount.Constant, Amount.Textured {

    /** One number everywhere. */
    static Amount of(double value) {
        return new Constant(value);
    }

    /** The mean of a texture's linear components; of a texture of one linear grey, that number everywhere. */
    static Amount of(Texture texture) {
        return texture instanceof Texture.Solid s
                        && s.color() instanceof Rgb c
                        && Double.compare(c.r(), c.g()) == 0
                        && Double.compare(c.g(), c.b()) == 0
                ? new Constant(c.r())
                : new Textured(texture, Channel.MEAN, 1);
    }

    /** Whether it is the number 0 everywhere, and no texture says so. */
    default boolean isZero() {
        return this instanceof Constant c && c.value() == 0;
    }

    /** Its textures: none, or one. */
    List<Texture> textures();

    /** Which of a texture's linear components is meant. */
    enum Channel {
        /** The mean of the three. */
        MEAN,
        /** The first. */
        RED,
        /** The second. */
        GREEN,
        /** The third. */
        BLUE
    }

    /**
     * One number everywhere.
     *
     * @param value 0..1
     */
    record Constant(double value) implements Amount {
        /** Validates the value, as {@link Amount} states. */
        public Constant {
            Check.range("value", value, 0, 1);
        }

        @Override
        public List<Texture> textures() {
            return List.of();
        }
    }

    /**
     * A component of a texture's linear colour, times a factor.
     *
     * @param texture where the numbers come from: a file whose numbers are meant as they are has the encoding {@code LINEAR}
     * @param channel which component
     * @param factor 0..1
     */
    record Textured(Texture texture, Channel channel, double factor) implements Amount {
        /** Validates the components, as {@link Amount} states. */
        public Textured {
            Objects.requireNonNull(texture, "texture");
            Objects.requireNonNull(channel, "channel");
            Check.range("factor", factor, 0, 1);
            Detail.checkShare("texture", texture);
        }

        @Override
        public List<Texture> textures() {
            return List.of(texture);
        }
    }
}
