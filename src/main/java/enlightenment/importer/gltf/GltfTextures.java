package enlightenment.importer.gltf;

import enlightenment.color.Color;
import enlightenment.color.Rgb;
import enlightenment.colorimetry.TransferCurve;
import enlightenment.image.Image;
import enlightenment.image.ImageFiles;
import enlightenment.importer.support.ImportNotes;
import enlightenment.material.Texture;
import java.io.IOException;
import java.nio.file.FileSystemException;
import java.nio.file.Path;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.OptionalInt;

/**
 * What the textures of glTF materials become. A texture that cannot be had is left out with a note. Factors that our textures do not have are
 * multiplied into a copy of the image.
 */
final class GltfTextures {
    private static final int NEAREST = 9728;
    private static final int REPEAT = 10497;

    private final GltfElement document;
    private final ImageStore images;
    private final ImportNotes notes;

    GltfTextures(GltfElement document, ImageStore images, ImportNotes notes) {
        this.document = document;
        this.images = images;
        this.notes = notes;
    }

    private interface Choice<T> {
        T of(int image, Texture.Filter filter) throws IOException;
    }

    private <T> Optional<T> chosen(GltfElement info, Choice<T> choice) throws IOException {
        if (!info.isPresent()) {
            return Optional.empty();
        }
        int index = info.index("index", document.size("textures"))
                .orElseThrow(() -> info.failure("lacks the \"index\" of a texture"));
        GltfElement texture = document.item("textures", index);
        OptionalInt image = texture.index("source", document.size("images"));
        if (image.isEmpty()) {
            String kinds = String.join(", ", texture.extensions());
            notes.add(
                    texture.place(),
                    "the texture is left out: it has no PNG or JPEG image"
                            + (kinds.isEmpty() ? "" : ", but those of " + kinds));
            return Optional.empty();
        }
        try {
            return Optional.of(choice.of(image.getAsInt(), filter(texture)));
        } catch (FileSystemException e) {
            throw e; // an extracted file that cannot be written
        } catch (IOException e) {
            notes.add("", "a texture is left out: " + e.getMessage());
            return Optional.empty();
        }
    }

    private Texture.Filter filter(GltfElement texture) throws IOException {
        return sampler(texture).whole("magFilter", 0) == NEAREST ? Texture.Filter.NEAREST : Texture.Filter.BILINEAR;
    }

    private GltfElement sampler(GltfElement texture) throws IOException {
        OptionalInt index = texture.index("sampler", document.size("samplers"));
        return index.isPresent() ? document.item("samplers", index.getAsInt()) : GltfElement.absent("sampler");
    }

    /** Whether a texture repeats beyond 0..1, as ours do. */
    boolean repeats(GltfElement info) throws IOException {
        OptionalInt index = info.index("index", document.size("textures"));
        if (index.isEmpty()) {
            return true;
        }
        GltfElement sampler = sampler(document.item("textures", index.getAsInt()));
        return sampler.whole("wrapS", REPEAT) == REPEAT && sampler.whole("wrapT", REPEAT) == REPEAT;
    }

    /** A texture of colour, in sRGB, times a linear factor. */
    Optional<Texture> color(GltfElement info, Rgb factor) throws IOException {
        return chosen(info, (image, filter) -> {
            Path file = factor.equals(Rgb.WHITE)
                    ? images.file(image)
                    : images.made(image, "times " + factor, source -> tinted(ImageFiles.read(source), factor));
            return new Texture.File(file, filter, Texture.Encoding.SRGB);
        });
    }

    private static Image tinted(Image image, Rgb factor) {
        float[] c = image.toArray();
        double[] factors = {factor.r(), factor.g(), factor.b()};
        for (int i = 0; i < c.length; i++) {
            c[i] = (float) TransferCurve.encode(TransferCurve.decode(c[i]) * factors[i % 3]);
        }
        return new Image(image.width(), image.height(), c);
    }

    /** The colour of a texture in sRGB that has one colour only; empty for others. */
    Optional<Rgb> uniform(GltfElement info) throws IOException {
        return chosen(info, (image, filter) -> ImageFiles.read(images.file(image)))
                .flatMap(GltfTextures::uniform);
    }

    private static Optional<Rgb> uniform(Image image) {
        float[] c = image.toArray();
        for (int i = 3; i < c.length; i++) {
            if (c[i] != c[i - 3]) {
                return Optional.empty();
            }
        }
        return Optional.of(new Rgb(TransferCurve.decode(c[0]), TransferCurve.decode(c[1]), TransferCurve.decode(c[2])));
    }

    /** A channel of a texture of linear numbers, times a factor in 0..1. */
    Optional<Texture.Amount> channel(GltfElement info, Texture.Amount.Channel channel, double factor)
            throws IOException {
        return chosen(
                info,
                (image, filter) -> new Texture.Amount.Textured(
                        new Texture.File(images.file(image), filter, Texture.Encoding.LINEAR), channel, factor));
    }

    /**
     * The opacity of a texture; empty where it has none.
     *
     * @param factor 0..1, which it is multiplied by
     * @param cutoff what is less opaque than that is a hole, all else opaque; empty for opacities as they are
     */
    Optional<Texture.Amount> opacity(GltfElement info, double factor, OptionalDouble cutoff) throws IOException {
        return chosen(info, (image, filter) -> {
                    Optional<Image> alpha = ImageFiles.readAlpha(images.file(image));
                    if (alpha.isEmpty()) {
                        return Optional.<Texture.Amount>empty();
                    }
                    String what = cutoff.isEmpty() ? "alpha" : "alpha " + factor + " cut at " + cutoff.getAsDouble();
                    Path file = images.made(image, what, source -> cut(alpha.get(), factor, cutoff));
                    Texture texture = new Texture.File(file, filter, Texture.Encoding.LINEAR);
                    return Optional.<Texture.Amount>of(new Texture.Amount.Textured(
                            texture, Texture.Amount.Channel.RED, cutoff.isEmpty() ? factor : 1));
                })
                .flatMap(found -> found);
    }

    private static Image cut(Image alpha, double factor, OptionalDouble cutoff) {
        float[] c = alpha.toArray();
        for (int i = 0; i < c.length && cutoff.isPresent(); i++) {
            c[i] = c[i] * factor >= cutoff.getAsDouble() ? 1 : 0;
        }
        return new Image(alpha.width(), alpha.height(), c);
    }

    /** A normal map, whose components along the surface are multiplied by a factor. */
    Optional<Texture> normals(GltfElement info, double factor) throws IOException {
        return chosen(info, (image, filter) -> {
            Path file = factor == 1
                    ? images.file(image)
                    : images.made(image, "normals times " + factor, source -> scaled(ImageFiles.read(source), factor));
            return new Texture.File(file, filter, Texture.Encoding.LINEAR);
        });
    }

    private static Image scaled(Image normals, double factor) {
        float[] c = normals.toArray();
        for (int i = 0; i < c.length; i += 3) {
            double x = (2 * c[i] - 1) * factor;
            double y = (2 * c[i + 1] - 1) * factor;
            double z = 2 * c[i + 2] - 1;
            double length = Math.max(StrictMath.sqrt(x * x + y * y + z * z), Double.MIN_NORMAL);
            c[i] = (float) ((x / length + 1) / 2);
            c[i + 1] = (float) ((y / length + 1) / 2);
            c[i + 2] = (float) ((z / length + 1) / 2);
        }
        return new Image(normals.width(), normals.height(), c, Color.Encoding.DISPLAY);
    }
}
