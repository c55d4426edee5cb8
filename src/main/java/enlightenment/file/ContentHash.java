package enlightenment.file;

import java.nio.ByteBuffer;
import java.security.MessageDigest;
import java.security.NoSuchAlgorithmException;
import java.util.HexFormat;

/** A SHA-256 hash as a value: names jobs, scenes, textures and tile results. */
public record ContentHash(long a, long b, long c, long d) {
    /** Length in bytes. */
    public static final int BYTES = 32;

    /** The hash of some bytes. */
    public static ContentHash of(byte[] content) {
        return fromBytes(sha256().digest(content));
    }

    /** The hash that these 32 bytes are. */
    public static ContentHash fromBytes(byte[] hash) {
        if (hash.length != BYTES) {
            throw new IllegalArgumentException("a hash has " + BYTES + " bytes, not " + hash.length);
        }
        ByteBuffer in = ByteBuffer.wrap(hash);
        return new ContentHash(in.getLong(), in.getLong(), in.getLong(), in.getLong());
    }

    public static MessageDigest sha256() {
        try {
            return MessageDigest.getInstance("SHA-256");
        } catch (NoSuchAlgorithmException e) {
            throw new IllegalStateException("every Java platform has SHA-256", e);
        }
    }

    public byte[] toBytes() {
        return ByteBuffer.allocate(BYTES)
                .putLong(a)
                .putLong(b)
                .putLong(c)
                .putLong(d)
                .array();
    }

    /** 64 lower-case hexadecimal digits. */
    @Override
    public String toString() {
        return HexFormat.of().formatHex(toBytes());
    }
}
