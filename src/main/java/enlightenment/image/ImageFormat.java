package enlightenment.image;

import enlightenment.codec.JpegWriter;
import enlightenment.codec.RasterDecoder;
import enlightenment.color.Color;
import enlightenment.text.WordList;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Optional;

/**
 * The formats of picture files: which can be read, which can be written, and what they hold. {@link ImageFiles} reads all, and writes those that
 * {@linkplain #isWritten are written}.
 *
 * <p>Whole numbers are fractions of their maximum, and display-referred. Floats are the components themselves, without limits;
 * whether they are display-referred or linear light ({@link Color.Encoding}) no such file says.
 *
 */
public enum ImageFormat {
    /** Portable Network Graphics (W3C): lossless, the format of finished pictures. */
    PNG(List.of("png"), List.of(8, 16), true, RasterDecoder.PNG),

    /** JPEG (ISO/IEC 10918): lossy. Two Java versions may decode the same file to components that differ by one step. */
    JPEG(List.of("jpg", "jpeg"), List.of(8), true, RasterDecoder.JPEG),

    /** Windows bitmaps. */
    BMP(List.of("bmp"), List.of(8), false, RasterDecoder.BMP),

    /** P. Debevec's portable float map: every component bit by bit, for measuring and further work. */
    PFM(List.of("pfm"), List.of(), true, RasterDecoder.PFM),

    /** Radiance pictures (G. Ward): three mantissas of 8 bits with a common exponent. */
    HDR(List.of("hdr"), List.of(), false, RasterDecoder.HDR),

    /**
     * OpenEXR (Academy Software Foundation): one part of scan lines, read uncompressed or in RLE, ZIPS, ZIP, PIZ or PXR24, written in ZIP.
     * Floats of 32 or 16 bits.
     */
    EXR(List.of("exr"), List.of(32, 16), true, RasterDecoder.EXR);

    /** The number of bytes at the beginning of a file that {@link #ofContent} needs. */
    public static final int SIGNATURE_LENGTH = RasterDecoder.SIGNATURE_LENGTH;

    private final List<String> extensions;
    private final List<Integer> depths;
    private final boolean written;
    private final RasterDecoder decoder;

    ImageFormat(List<String> extensions, List<Integer> depths, boolean written, RasterDecoder decoder) {
        this.extensions = extensions;
        this.depths = depths;
        this.written = written;
        this.decoder = decoder;
    }

    /** The formats that {@link ImageFiles} writes, the usual one first. */
    public static List<ImageFormat> written() {
        return Arrays.stream(values()).filter(ImageFormat::isWritten).toList();
    }

    /** The formats that a texture may have: those of whole numbers. */
    public static List<ImageFormat> textures() {
        return Arrays.stream(values()).filter(f -> !f.holdsFloats()).toList();
    }

    /** The format that a file's extension names, in capital or small letters; empty if it names none. */
    public static Optional<ImageFormat> ofExtension(Path file) {
        Path last = file.getFileName();
        String name = last == null ? "" : last.toString();
        String extension = name.substring(name.lastIndexOf('.') + 1).toLowerCase(Locale.ROOT);
        boolean hasOne = extension.length() < name.length();
        // Loops, not streams: these are asked at every start.
        for (ImageFormat format : values()) {
            if (hasOne && format.extensions.contains(extension)) {
                return Optional.of(format);
            }
        }
        return Optional.empty();
    }

    /**
     * The format that a file's first bytes tell; empty if they tell none.
     *
     * @param start the whole file or its first {@link #SIGNATURE_LENGTH} bytes; fewer if the file has fewer
     */
    public static Optional<ImageFormat> ofContent(byte[] start) {
        for (ImageFormat format : values()) {
            if (format.decoder.matches(start)) {
                return Optional.of(format);
            }
        }
        return Optional.empty();
    }

    /** Usual extensions for messages: {@code .png, .jpg or .pfm}. */
    public static String extensions(List<ImageFormat> formats) {
        return WordList.join(
                formats.stream().map(f -> "." + f.extensions.get(0)).toList(), "or");
    }

    /** Names for messages: {@code PNG, JPEG and BMP}, with the conjunction "and". */
    public static String names(List<ImageFormat> formats, String conjunction) {
        return WordList.join(formats.stream().map(ImageFormat::name).toList(), conjunction);
    }

    /** The format's name in small letters, which is one of its extensions, too: {@code png}. */
    public String word() {
        return name().toLowerCase(Locale.ROOT);
    }

    /** The extensions of its files, in small letters and without the dot; the usual one first. */
    public List<String> extensions() {
        return extensions;
    }

    /** Whether {@link ImageFiles} writes this format. */
    public boolean isWritten() {
        return written;
    }

    /** Whether components are floats, exact and without limits; otherwise whole numbers that stand for 0..1. */
    public boolean holdsFloats() {
        return this == PFM || this == HDR || this == EXR;
    }

    /** Whether a file of this format may differ from the picture by more than the rounding to its {@link #depths}. */
    public boolean isLossy() {
        return this == JPEG;
    }

    /** The most columns, and the most rows, that {@link ImageFiles} writes. */
    public int largestSide() {
        return this == JPEG ? JpegWriter.LARGEST_SIDE : Integer.MAX_VALUE;
    }

    /**
     * Bits per component, the usual number first; empty for formats of floats that have no choice. A format that is not written has those
     * of its files that are read.
     */
    public List<Integer> depths() {
        return depths;
    }
}
