package enlightenment.material;

import enlightenment.check.Check;
import enlightenment.color.Color;
import enlightenment.color.Rgb;
import java.nio.file.Path;
import java.util.List;
import java.util.Objects;

/**
 * Where a surface's colour comes from, such as one colour everywhere or an image file: an immutable description. Texture coordinates run over 0..1,
 * u to the right, v downwards.
 *
 * <p>The constructors throw {@link enlightenment.math.InvalidValueException}, with the key of the scene format, for a value out
 * of range, and {@link NullPointerException} for a missing one.
 *
 */
public sealed interface Texture permits Texture.Solid, Texture.Checker, Texture.File {

    /** The texture of one colour everywhere. */
    static Texture of(Color color) {
        return new Solid(color);
    }

    /**
     * One colour everywhere.
     *
     * @param color the colour
     */
    record Solid(Color color) implements Texture {
        /** Validates the components, as {@link Texture} states. */
        public Solid {
            Objects.requireNonNull(color, "color");
        }
    }

    /**
     * A checkerboard in texture coordinates; it goes on beyond 0..1.
     *
     * @param colors two colours; the first one fills the square at the top left
     * @param scale the number of squares along each texture coordinate, greater than 0
     */
    record Checker(List<Color> colors, double scale) implements Texture {
        /** Validates the components, as {@link Texture} states. */
        public Checker {
            Check.that(colors.size() == 2, "colors", "must be two colours, not " + colors.size());
            Check.positive("scale", scale);
            colors = List.copyOf(colors);
        }
    }

    /**
     * An image file, stretched over the texture coordinates; it repeats beyond 0..1. The file is not read before a render.
     *
     * @param file the image: PNG, JPEG or BMP; a relative path is relative to the working directory
     * @param filter how texels are looked up
     * @param encoding how the file's numbers encode light
     */
    record File(Path file, Filter filter, Encoding encoding) implements Texture {
        /** Validates the components, as {@link Texture} states. */
        public File {
            file = file.normalize();
            Objects.requireNonNull(filter, "filter");
            Objects.requireNonNull(encoding, "encoding");
        }
    }

    /** How texels are looked up. */
    enum Filter {
        /** The texel that contains the point. */
        NEAREST,
        /** Bilinear interpolation between the centres of the four texels around the point. */
        BILINEAR
    }

    /** How an image file's numbers encode light. */
    enum Encoding {
        /** Display-referred, as photographs and painted textures are. */
        SRGB,
        /** Proportional to light. */
        LINEAR
    }

    /**
     * A number in 0..1 that may depend on the place: one number everywhere, or numbers of a texture. An immutable description.
     *
     * <p>The constructors throw {@link enlightenment.math.InvalidValueException} for a value out of range, and {@link NullPointerException}
     * for a missing one.
     */
    sealed interface Amount permits Amount.Constant, Amount.Textured {

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
}
