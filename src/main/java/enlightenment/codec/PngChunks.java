package enlightenment.codec;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.util.Optional;
import java.util.zip.CRC32;

/** The chunks of a PNG file (W3C PNG specification, second edition, 5.3), one after another; their checksums are compared. */
public final class PngChunks {
    private static final int SIGNATURE_LENGTH = PngWriter.SIGNATURE.length;

    /** Length, type and checksum. */
    private static final int AROUND = 12;

    private final ByteBuffer file;
    private String type = "";

    /** @param file a whole file that begins with the signature */
    PngChunks(byte[] file) {
        this.file = ByteBuffer.wrap(file).position(SIGNATURE_LENGTH);
    }

    /**
     * The content of the next chunk.
     *
     * @throws IOException if there is none, or it is damaged
     */
    ByteBuffer next() throws IOException {
        if (file.remaining() < AROUND) {
            throw new IOException("it ends too early");
        }
        int length = file.getInt();
        int start = file.position();
        if (length < 0 || length > file.remaining() - 8) {
            throw new IOException("it ends too early");
        }
        CRC32 crc = new CRC32();
        crc.update(file.array(), start, length + 4);
        type = new String(file.array(), start, 4, StandardCharsets.ISO_8859_1);
        file.position(start + 4 + length);
        ByteBuffer content = file.duplicate().position(start + 4).limit(start + 4 + length);
        if (file.getInt() != (int) crc.getValue()) {
            throw new IOException("it is damaged: a checksum does not match in chunk \"" + type + "\"");
        }
        return content;
    }

    /** The four letters of the chunk that {@link #next} gave last. */
    String type() {
        return type;
    }

    /**
     * The first Latin-1 comment with a keyword, of a PNG file that is whole and undamaged as far as its chunks tell; empty if there
     * is none, or the file is another.
     */
    public static Optional<String> comment(byte[] file, String keyword) {
        if (!RasterDecoder.PNG.matches(file)) {
            return Optional.empty();
        }
        PngChunks chunks = new PngChunks(file);
        String found = null;
        try {
            do {
                ByteBuffer content = chunks.next();
                if (found == null && chunks.type.equals("tEXt")) {
                    found = commentOf(content, keyword);
                }
            } while (!chunks.type.equals("IEND"));
        } catch (IOException e) {
            return Optional.empty();
        }
        return Optional.ofNullable(found);
    }

    private static String commentOf(ByteBuffer content, String keyword) {
        String text = StandardCharsets.ISO_8859_1.decode(content).toString();
        return text.startsWith(keyword + '\0') ? text.substring(keyword.length() + 1) : null;
    }
}
