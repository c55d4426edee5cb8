package enlightenment.codec;

import java.io.ByteArrayOutputStream;
import java.io.DataOutputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.charset.StandardCharsets;
import java.util.zip.CRC32;

/** Writes the chunks of a PNG file (W3C PNG specification, second edition, 5.3) with their lengths and checksums. */
final class PngChunkWriter {
    private final DataOutputStream out;

    /** @param out receives the file; stays open */
    PngChunkWriter(OutputStream out) {
        this.out = new DataOutputStream(out);
    }

    void signature() throws IOException {
        out.write(PngWriter.SIGNATURE);
    }

    void chunk(String type, byte[] data) throws IOException {
        chunk(type, data, 0, data.length);
    }

    void chunk(String type, byte[] data, int from, int length) throws IOException {
        byte[] name = type.getBytes(StandardCharsets.US_ASCII);
        CRC32 crc = new CRC32();
        crc.update(name);
        crc.update(data, from, length);
        out.writeInt(length);
        out.write(name);
        out.write(data, from, length);
        out.writeInt((int) crc.getValue());
    }

    /** A comment: in Latin-1 where that has all its characters. */
    void text(String keyword, String text) throws IOException {
        ByteArrayOutputStream bytes = new ByteArrayOutputStream();
        bytes.writeBytes(keyword.getBytes(StandardCharsets.ISO_8859_1));
        bytes.write(0);
        if (text.chars().allMatch(c -> c < 256)) {
            bytes.writeBytes(text.getBytes(StandardCharsets.ISO_8859_1));
            chunk("tEXt", bytes.toByteArray());
        } else {
            bytes.writeBytes(new byte[4]); // not compressed (two bytes), no language, no translated keyword
            bytes.writeBytes(text.getBytes(StandardCharsets.UTF_8));
            chunk("iTXt", bytes.toByteArray());
        }
    }

    void flush() throws IOException {
        out.flush();
    }
}
