package enlightenment.world.material;

import enlightenment.color.Color;
import enlightenment.color.DisplayRgb;
import enlightenment.color.Rgb;
import enlightenment.material.Texture;
import enlightenment.texture.ImageTexture;
import java.util.function.Consumer;

/** A texture as rendering reads it: one colour, a checkerboard, or an image. Immutable. */
public final class TextureLookup {
    /** Beyond this number of texels, bounds for each of many triangles are not worth their time. */
    private static final int FEW_TEXELS = 1 << 14;

    private final Texture description;
    private final double r;
    private final double g;
    private final double b;

    /** The second colour of a checkerboard; null for others. */
    private final double[] other;

    private final double checks;
    private final ImageTexture image;
    private final boolean bilinear;

    /**
     * @param image the picture of a texture in a file, else null
     * @param isLinear whether colours are linear light, else display-referred
     */
    public TextureLookup(Texture texture, ImageTexture image, boolean isLinear) {
        description = texture;
        this.image = image;
        double[] first = {0, 0, 0};
        double[] second = null;
        double scale = 0;
        boolean smooth = false;
        if (texture instanceof Texture.Solid solid) {
            first = numbers(solid.color(), isLinear);
        } else if (texture instanceof Texture.Checker checker) {
            first = numbers(checker.colors().get(0), isLinear);
            second = numbers(checker.colors().get(1), isLinear);
            scale = checker.scale();
        } else if (texture instanceof Texture.File file) {
            smooth = file.filter() == Texture.Filter.BILINEAR;
        } else {
            throw new AssertionError("no compiled form of the texture " + texture);
        }
        r = first[0];
        g = first[1];
        b = first[2];
        other = second;
        checks = scale;
        bilinear = smooth;
    }

    private static double[] numbers(Color color, boolean isLinear) {
        if (!isLinear) {
            DisplayRgb c = color.display();
            return new double[] {c.r(), c.g(), c.b()};
        }
        Rgb c = color.linear();
        return new double[] {c.r(), c.g(), c.b()};
    }

    /** Whether it is black everywhere; images are not examined, and count as not black. */
    boolean isBlack() {
        return description instanceof Texture.Solid && r == 0 && g == 0 && b == 0;
    }

    /** Whether it depends on texture coordinates. */
    public boolean isTextured() {
        return image != null || other != null;
    }

    /** Whether it is an image. */
    public boolean hasImage() {
        return image != null;
    }

    /** The image, or null. */
    public ImageTexture image() {
        return image;
    }

    /** Whether texels of the image are interpolated bilinearly. */
    public boolean isBilinear() {
        return bilinear;
    }

    /** Its colour, a checkerboard's second colour, and the number of squares along a unit: 0 for a part that does not exist. */
    public double[] numbers() {
        double[] second = other == null ? new double[3] : other;
        return new double[] {r, g, b, second[0], second[1], second[2], checks};
    }

    /** The size of a texel in texture coordinates, along the side that has more of them; 0 without an image. */
    double texel() {
        return image == null ? 0 : 1.0 / Math.max(image.width(), image.height());
    }

    /** Writes the colour of a texture that does not depend on coordinates. */
    public void color(double[] rgb) {
        rgb[0] = r;
        rgb[1] = g;
        rgb[2] = b;
    }

    /**
     * Writes the colour at texture coordinates.
     *
     * @param wraps whether u is periodic, so that 0 and 1 are the same place
     */
    public void color(double u, double v, boolean wraps, double[] rgb) {
        if (image != null) {
            if (bilinear) {
                image.bilinear(u, v, wraps, rgb);
            } else {
                image.nearest(u, v, rgb);
            }
        } else if (other != null && odd(u) != odd(v)) {
            rgb[0] = other[0];
            rgb[1] = other[1];
            rgb[2] = other[2];
        } else {
            color(rgb);
        }
    }

    /**
     * Passes all colours to a consumer, linear or display-referred as they are: of an image those of the texels, between which all others
     * lie.
     */
    void forEachColor(Consumer<double[]> consumer) {
        if (image != null) {
            image.forEachTexel(consumer);
            return;
        }
        consumer.accept(new double[] {r, g, b});
        if (other != null) {
            consumer.accept(other.clone());
        }
    }

    /**
     * Passes all colours that occur where texture coordinates lie in a box, if it is an image and the box lies in 0..1 and has few texels.
     *
     * @return false if no colours were passed
     */
    boolean forEachColor(double u0, double v0, double u1, double v1, Consumer<double[]> consumer) {
        if (image == null || !(u0 >= 0 && v0 >= 0 && u1 <= 1 && v1 <= 1)) {
            return false;
        }
        double texels = ((u1 - u0) * image.width() + 3) * ((v1 - v0) * image.height() + 3);
        if (!(texels <= FEW_TEXELS)) {
            return false;
        }
        image.forEachTexel(u0, v0, u1, v1, consumer);
        return true;
    }

    /** Roughly the number of texels, or squares of a checkerboard, along the longer side of a box in texture coordinates. */
    double texelsAlong(double width, double height) {
        if (image == null) {
            return checks * Math.max(width, height);
        }
        return Math.max(width * image.width(), height * image.height());
    }

    private boolean odd(double coordinate) {
        // The far edge belongs to the last square; beyond it the squares continue.
        double square = Math.floor(coordinate * checks);
        if (coordinate <= 1) {
            square = Math.min(square, Math.ceil(checks) - 1);
        }
        return ((long) square & 1) != 0;
    }

    /** A text that is equal for textures that look the same, on every machine and wherever their image files are. */
    String look() {
        return description instanceof Texture.File file
                ? "image " + image.fingerprint() + " " + file.filter() + " " + file.encoding()
                : description.toString();
    }
}
