package enlightenment.image;

import enlightenment.check.Check;
import enlightenment.codec.JpegWriter;
import enlightenment.codec.PfmFormat;
import enlightenment.codec.PngWriter;
import enlightenment.codec.Raster;
import enlightenment.codec.RasterFiles;
import enlightenment.color.Color;
import enlightenment.file.WholeFile;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;

/**
 * Reads and writes picture files, such as PNG, JPEG and OpenEXR. A file that is written appears as a whole or not at all, and its bytes
 * depend on nothing but the picture and the options: not on the machine, the JDK or the time, but for JPEG, whose encoder is the JDK's. A
 * file's kind follows from its first bytes when it is read, from its extension when it is written.
 *
 * <p>All methods that read or write a file fail with an {@link IOException} whose message names the file and the reason.
 *
 * <p>All methods may be called by several threads at once. Two that write one file leave the whole of one of them.
 */
public final class ImageFiles {
    private ImageFiles() {}

    /**
     * Writes a picture in the format that the file's extension names, one of {@link ImageFormat#written}.
     *
     * @param options only for PNG
     * @throws IllegalArgumentException if the extension is another one, or the picture larger than {@link
     *     ImageFormat#largestSide}
     */
    public static void write(Image image, Path file, PngOptions options) throws IOException {
        ImageFormat format = writtenFormat(file);
        WholeFile.write(file, out -> write(image, out, format, options));
    }

    /**
     * Writes what a file of that format would hold to a stream, which stays open.
     *
     * @param options only for PNG
     * @throws IllegalArgumentException if the format is none of {@link ImageFormat#written}, or the picture larger than
     *     {@link ImageFormat#largestSide}
     */
    public static void write(Image image, OutputStream out, ImageFormat format, PngOptions options) throws IOException {
        switch (format) {
            case PNG -> {
                int maximum = (1 << options.depth()) - 1;
                new PngWriter(out, image.width(), image.height(), options.depth())
                        .write((x, y, c) -> image.displayedFor(maximum, x, y, c), options.text());
            }
            case JPEG -> JpegWriter.write(image.width(), image.height(), image.toArgb(), out);
            case PFM -> PfmFormat.write(image.width(), image.height(), image::component, out);
            case EXR -> toExr(image, out, ExrOptions.DEFAULT);
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
     * Writes an sRGB PNG file: components, {@linkplain Image#displayed as a screen takes them}, are limited to 0..1 and rounded to the
     * nearest step of 1/255 or 1/65535, halves upwards; what is no number becomes 0.
     */
    public static void writePng(Image image, Path file, PngOptions options) throws IOException {
        WholeFile.write(file, out -> toPng(image, out, options));
    }

    /** Writes what {@link #writePng} would to a stream, which stays open. */
    public static void toPng(Image image, OutputStream out, PngOptions options) throws IOException {
        write(image, out, ImageFormat.PNG, options);
    }

    /**
     * Writes a portable float map: all components bit by bit, little-endian, the bottom row first; those of linear light as linear
     * light. The file does not say which of the two it holds.
     */
    public static void writePfm(Image image, Path file) throws IOException {
        WholeFile.write(file, out -> toPfm(image, out));
    }

    /** Writes what {@link #writePfm} would to a stream, which stays open. */
    public static void toPfm(Image image, OutputStream out) throws IOException {
        write(image, out, ImageFormat.PFM, PngOptions.DEFAULT);
    }

    /**
     * Writes an OpenEXR file: one part of scan lines, channels R, G, B and those of the layers, ZIP. Components are written as they are,
     * bit by bit with 32 bits per component, but for those that are no number (NaN), which become 0; those of linear light as linear light,
     * which is what programs expect of such files. With 16 bits they become the nearest half, at most ±65504 unless infinite.
     *
     * @throws IllegalArgumentException if the place is not within the whole picture, a layer has another size than the picture, two
     *     channels have one name, or a name is not as {@link ExrOptions} says
     */
    public static void writeExr(Image image, Path file, ExrOptions options) throws IOException {
        WholeFile.write(file, out -> toExr(image, out, options));
    }

    /** Writes what {@link #writeExr} would to a stream, which stays open. */
    public static void toExr(Image image, OutputStream out, ExrOptions options) throws IOException {
        ExrPicture.write(image, out, options);
    }

    /**
     * Reads a file of any {@link ImageFormat} with at most 2^28 pixels; its first bytes tell which. Whole numbers become the
     * float next to their fraction of the maximum; a grey picture gets three equal components. Transparency, gamma and colour
     * profiles are not applied, nor the scale of a float map. The picture is taken for display-referred.
     */
    public static Image read(Path file) throws IOException {
        return read(file, Color.Encoding.DISPLAY);
    }

    /**
     * Reads a float map whose components are known to be linear light or display-referred, as {@link #read(Path)}.
     *
     * @throws IOException also if linear light is expected of a file of whole numbers, which holds none
     */
    public static Image read(Path file, Color.Encoding encoding) throws IOException {
        return RasterFiles.read(file, bytes -> {
            Raster raster = RasterFiles.decode(bytes);
            if (encoding == Color.Encoding.LINEAR && raster.floats() == null) {
                throw new IOException("it holds no linear light, but whole numbers for a screen");
            }
            return new Image(raster.width(), raster.height(), raster.components(), encoding);
        });
    }

    /**
     * Reads how opaque the pixels of a file are: 0 (not there) to 1, three equal components each, as they stand in the file.
     *
     * @return empty if the file says nothing of it, as formats other than PNG never do
     */
    public static Optional<Image> readAlpha(Path file) throws IOException {
        return RasterFiles.read(file, bytes -> {
            Optional<Raster> alpha = RasterFiles.decodeAlpha(bytes);
            return alpha.isEmpty()
                    ? Optional.empty()
                    : Optional.of(new Image(
                            alpha.get().width(),
                            alpha.get().height(),
                            alpha.get().components()));
        });
    }

    /**
     * How a PNG file is written.
     *
     * @param depth bits per component: 8 or 16
     * @param text comments, keyword to text, written in the map's order. A keyword has 1..79 printable Latin-1 characters and
     *     no space at its ends nor two in a row (PNG specification, 11.3.4.2); a text has no NUL character
     */
    public record PngOptions(int depth, Map<String, String> text) {
        /** 8 bits per component, no comments. */
        public static final PngOptions DEFAULT = new PngOptions(8, Map.of());

        /** @throws IllegalArgumentException if the depth, a keyword or a text is not allowed */
        public PngOptions {
            Check.that(depth == 8 || depth == 16, "depth", "must be 8 or 16 bits per component, not " + depth);
            text = Collections.unmodifiableMap(new LinkedHashMap<>(text));
            text.forEach(PngOptions::check);
        }

        /** These options with another depth. */
        public PngOptions withDepth(int newDepth) {
            return new PngOptions(newDepth, text);
        }

        /** These options with one more comment at the end, or another text for a keyword that is there. */
        public PngOptions withText(String keyword, String value) {
            Map<String, String> extended = new LinkedHashMap<>(text);
            extended.put(keyword, value);
            return new PngOptions(depth, extended);
        }

        private static void check(String keyword, String value) {
            boolean printable = keyword.chars().allMatch(c -> c >= 32 && c <= 126 || c >= 161 && c <= 255);
            if (!printable || keyword.isEmpty() || keyword.length() > 79) {
                throw new IllegalArgumentException(
                        "the keyword of a PNG comment has 1 to 79 printable Latin-1 characters, unlike \"" + keyword
                                + "\"");
            }
            if (keyword.startsWith(" ") || keyword.endsWith(" ") || keyword.contains("  ")) {
                throw new IllegalArgumentException(
                        "the keyword of a PNG comment has single spaces only between words, unlike \"" + keyword
                                + "\"");
            }
            if (value.indexOf('\0') >= 0) {
                throw new IllegalArgumentException("the PNG comment \"" + keyword + "\" contains a NUL character");
            }
        }
    }

    /**
     * How an OpenEXR file is written.
     *
     * @param depth bits per component of the picture: 32 keeps every float, 16 rounds to halves (11 bits, up to 65504)
     * @param place where a part of a larger picture lies; empty for a whole picture
     * @param text what the file says of itself: attributes of type string. A name has 1..31 printable ASCII characters without spaces and
     *     is none of the attributes that every file has, such as {@code channels}
     * @param layers further channels, in floats
     */
    public record ExrOptions(int depth, Optional<Place> place, Map<String, String> text, List<Layer> layers) {
        /** Floats of a whole picture, nothing else. */
        public static final ExrOptions DEFAULT = new ExrOptions(32, Optional.empty(), Map.of(), List.of());

        /**
         * The place of a picture's upper left pixel in a larger picture: the file's data window within its display window.
         *
         * @param x column of the larger picture
         * @param y row of the larger picture, from the top
         * @param wholeWidth columns of the larger picture
         * @param wholeHeight rows of the larger picture
         */
        public record Place(int x, int y, int wholeWidth, int wholeHeight) {}

        /**
         * Further numbers of each pixel: channels {@code name.X} for each X of the list.
         *
         * @param name of the layer; with a dot and a channel's name at most 31 characters
         * @param channels the last parts of the channels' names: three, or one if the components are equal
         * @param image the numbers, of the picture's size
         */
        public record Layer(String name, List<String> channels, Image image) {
            /** @throws IllegalArgumentException unless there are one or three channels */
            public Layer {
                channels = List.copyOf(channels);
                Check.that(
                        channels.size() == 1 || channels.size() == 3,
                        "channels",
                        "must be one or three, not " + channels.size());
            }
        }

        /** @throws IllegalArgumentException if the depth is neither 16 nor 32 */
        public ExrOptions {
            Check.that(depth == 16 || depth == 32, "depth", "must be 16 or 32 bits per component, not " + depth);
            text = Collections.unmodifiableMap(new LinkedHashMap<>(text));
            layers = List.copyOf(layers);
        }

        /** These options with another depth. */
        public ExrOptions withDepth(int newDepth) {
            return new ExrOptions(newDepth, place, text, layers);
        }

        /** These options for a part of a larger picture. */
        public ExrOptions withPlace(Place newPlace) {
            return new ExrOptions(depth, Optional.of(newPlace), text, layers);
        }

        /** These options with other texts. */
        public ExrOptions withText(Map<String, String> newText) {
            return new ExrOptions(depth, place, newText, layers);
        }

        /** These options with one more layer. */
        public ExrOptions withLayer(Layer layer) {
            List<Layer> extended = new ArrayList<>(layers);
            extended.add(layer);
            return new ExrOptions(depth, place, text, extended);
        }
    }
}
