package enlightenment.material;

import enlightenment.check.Check;
import enlightenment.color.Color;
import java.nio.file.Path;
import java.util.List;
import java.util.Objects;

/**
 * Where a surface's colour comes from: an immutable description. Texture coordinates run over 0..1, u to the right, v downwards.
 *
 * <p>The constructors throw {@link enlightenment.math.InvalidValueException}, with the key of the scene format, for a value out
 * of range, and {@link NullPointerException} for a missing one.
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
}
