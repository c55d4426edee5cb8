package enlightenment.image;

import enlightenment.file.WholeFile;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;

/**
 * Pictures on disk. A file that is written appears as a whole or not at all, and its bytes depend on nothing but the
 * picture and the options: not on the machine, the JDK or the time. A file's kind is told by its first bytes when it is
 * read, by its extension when it is written.
 *
 * <p>All methods that read or write a file fail with an {@link IOException} whose message names the file and the reason.
 */
public final class ImageFiles {
    private ImageFiles() {}

    /**
     * Writes a picture in the format that the file's extension names, one of {@link ImageFormat#written}.
     *
     * @param options only for PNG
     * @throws IllegalArgumentException if the extension is another one
     */
    public static void write(Image image, Path file, PngOptions options) throws IOException {
        ImageFormat format = writtenFormat(file);
        WholeFile.write(file, out -> write(image, out, format, options));
    }

    /**
     * Writes what a file of that format would hold to a stream, which stays open.
     *
     * @param options only for PNG
     * @throws IllegalArgumentException if the format is none of {@link ImageFormat#written}
     */
    public static void write(Image image, OutputStream out, ImageFormat format, PngOptions options) throws IOException {
        switch (format) {
            case PNG -> PngWriter.write(image, out, options);
            case PFM -> PfmFormat.write(image, out);
            default -> throw new IllegalArgumentException("no " + format + " files are written");
        }
    }

    /**
     * The format in which {@link #write(Image, Path, PngOptions)} writes a file: for asking before a long render rather
     * than after it.
     *
     * @throws IllegalArgumentException if the file's extension names none of {@link ImageFormat#written}; the message lists
     *     them
     */
    public static ImageFormat writtenFormat(Path file) {
        return ImageFormat.ofExtension(file)
                .filter(ImageFormat::isWritten)
                .orElseThrow(() -> new IllegalArgumentException("cannot tell how to write " + file
                        + ": the name must end in " + ImageFormat.extensions(ImageFormat.written())));
    }

    /** Writes an 8-bit PNG file without comments. */
    public static void writePng(Image image, Path file) throws IOException {
        writePng(image, file, PngOptions.DEFAULT);
    }

    /**
     * Writes an sRGB PNG file: components are limited to 0..1 and rounded to the nearest step of 1/255 or 1/65535, halves
     * upwards; what is no number becomes 0.
     */
    public static void writePng(Image image, Path file, PngOptions options) throws IOException {
        WholeFile.write(file, out -> PngWriter.write(image, out, options));
    }

    /** Writes what {@link #writePng} would to a stream, which stays open. */
    public static void toPng(Image image, OutputStream out, PngOptions options) throws IOException {
        PngWriter.write(image, out, options);
    }

    /** Writes a portable float map: all components bit by bit, little-endian, the bottom row first. */
    public static void writePfm(Image image, Path file) throws IOException {
        WholeFile.write(file, out -> PfmFormat.write(image, out));
    }

    /** Writes what {@link #writePfm} would to a stream, which stays open. */
    public static void toPfm(Image image, OutputStream out) throws IOException {
        PfmFormat.write(image, out);
    }

    /** Reads a portable float map of either byte order; a grey one gets three equal components. */
    public static Image readPfm(Path file) throws IOException {
        return decode(file, bytes -> {
            if (!PfmFormat.matches(bytes)) {
                throw new IOException("it is not a PFM file");
            }
            return PfmFormat.read(bytes);
        });
    }

    /**
     * Reads a PNG, PFM, JPEG or BMP file of at most 2^28 pixels. Integers become the float next to their fraction of the
     * maximum. Transparency, gamma and colour profiles are not applied.
     */
    public static Image read(Path file) throws IOException {
        return decode(
                file, bytes -> format(bytes) == ImageFormat.PFM ? PfmFormat.read(bytes) : toImage(decodeRaster(bytes)));
    }

    /** The integers of a PNG, JPEG or BMP file. */
    static Raster readRaster(Path file) throws IOException {
        return decode(file, ImageFiles::decodeRaster);
    }

    static Raster decodeRaster(byte[] bytes) throws IOException {
        ImageFormat format = format(bytes);
        return switch (format) {
            case PNG -> PngReader.read(bytes);
            case JPEG, BMP -> ImageIoReader.read(bytes, format.word());
            case PFM ->
                throw new IOException(
                        "a PFM file cannot be used here; " + ImageFormat.names(ImageFormat.textures(), "and") + " can");
        };
    }

    private static ImageFormat format(byte[] bytes) throws IOException {
        String formats = ImageFormat.names(List.of(ImageFormat.values()), "nor");
        return ImageFormat.ofContent(bytes)
                .orElseThrow(() -> new IOException(bytes.length == 0 ? "it is empty" : "it is neither " + formats));
    }

    private interface Decoder<T> {
        T decode(byte[] bytes) throws IOException;
    }

    private static <T> T decode(Path file, Decoder<T> decoder) throws IOException {
        try {
            if (Files.isDirectory(file)) {
                throw new IOException("it is a folder");
            }
            if (Files.size(file) > Integer.MAX_VALUE - 64) {
                throw new IOException("it has more than 2 GiB");
            }
            return decoder.decode(Files.readAllBytes(file));
        } catch (IOException e) {
            throw new IOException("cannot read " + file + ": " + WholeFile.reason(e), e);
        }
    }

    private static Image toImage(Raster raster) throws IOException {
        int pixels = raster.width() * raster.height();
        float[] rgb = Raster.allocate(raster.width(), raster.height(), 12, () -> new float[3 * pixels]);
        if (raster.deep() != null) {
            for (int i = 0; i < rgb.length; i++) {
                rgb[i] = (float) (raster.deep()[i] / 65535.0);
            }
        } else {
            for (int i = 0; i < pixels; i++) {
                int packed = raster.packed()[i];
                rgb[3 * i] = (float) ((packed >>> 16) / 255.0);
                rgb[3 * i + 1] = (float) ((packed >>> 8 & 255) / 255.0);
                rgb[3 * i + 2] = (float) ((packed & 255) / 255.0);
            }
        }
        return new Image(raster.width(), raster.height(), rgb);
    }
}
