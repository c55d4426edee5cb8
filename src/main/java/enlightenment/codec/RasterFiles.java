package enlightenment.codec;

import enlightenment.file.FileFailure;
import enlightenment.file.InputFile;
import enlightenment.text.WordList;
import java.io.IOException;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.Optional;

/** Reads picture files of every kind. */
public final class RasterFiles {
    private RasterFiles() {}

    private static String kinds() {
        return WordList.join(
                Arrays.stream(RasterDecoder.values()).map(Enum::name).toList(), "nor");
    }

    /** What becomes of a file's bytes. */
    public interface Decoder<T> {
        /** @throws IOException with the reason, without the file's name */
        T decode(byte[] bytes) throws IOException;
    }

    /**
     * The numbers of a file whose kind its first bytes tell.
     *
     * @throws IOException with the reason
     */
    public static Raster decode(byte[] bytes) throws IOException {
        return RasterDecoder.of(bytes)
                .orElseThrow(() -> new IOException(bytes.length == 0 ? "it is empty" : "it is neither " + kinds()))
                .read(bytes);
    }

    /**
     * Reads a whole file, and decodes it.
     *
     * @throws IOException with a message that names the file and the reason
     */
    public static <T> T read(Path file, Decoder<T> decoder) throws IOException {
        try {
            return decoder.decode(InputFile.bytes(file));
        } catch (IOException e) {
            throw new IOException("cannot read " + file + ": " + FileFailure.reason(e), e);
        }
    }

    /**
     * How opaque the pixels of a file are, three equal components each, whose kind its first bytes tell.
     *
     * @return empty if all of it is opaque: kinds other than PNG are
     * @throws IOException with the reason
     */
    public static Optional<Raster> decodeAlpha(byte[] bytes) throws IOException {
        return RasterDecoder.of(bytes).filter(d -> d == RasterDecoder.PNG).isPresent()
                ? PngReader.readAlpha(bytes)
                : Optional.empty();
    }
}
