package enlightenment.net;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;

/** One entry of a {@link Journal}. A later one about the same tile overrules an earlier one. */
sealed interface JournalRecord {
    /** A tile was made by this machine; {@code data} are its sums. */
    record Kept(int tile, String machine, byte[] data) implements JournalRecord {
        @Override
        public byte[] encode() {
            byte[] name = machine.getBytes(StandardCharsets.UTF_8);
            return ByteBuffer.allocate(1 + 2 * Integer.BYTES + name.length + data.length)
                    .put(KEPT)
                    .putInt(tile)
                    .putInt(name.length)
                    .put(name)
                    .put(data)
                    .array();
        }
    }

    /**
     * Two machines agree that the tile has this hash. Without the hash, what one machine said alone would be taken for confirmed
     * where the record of the tile that was meant is lost.
     */
    record Confirmed(int tile, ContentHash hash) implements JournalRecord {
        @Override
        public byte[] encode() {
            return ByteBuffer.allocate(1 + Integer.BYTES + ContentHash.BYTES)
                    .put(CONFIRMED)
                    .putInt(tile)
                    .put(hash.toBytes())
                    .array();
        }
    }

    /** What was kept of the tile does not count. */
    record Revoked(int tile) implements JournalRecord {
        @Override
        public byte[] encode() {
            return ByteBuffer.allocate(1 + Integer.BYTES)
                    .put(REVOKED)
                    .putInt(tile)
                    .array();
        }
    }

    /** A machine is not to be trusted. */
    record Expelled(String machine) implements JournalRecord {
        @Override
        public byte[] encode() {
            byte[] name = machine.getBytes(StandardCharsets.UTF_8);
            return ByteBuffer.allocate(1 + name.length).put(EXPELLED).put(name).array();
        }
    }

    byte KEPT = 1;
    byte CONFIRMED = 2;
    byte REVOKED = 3;
    byte EXPELLED = 4;

    /** The body of the record. */
    byte[] encode();

    /**
     * The record that a body is. Its checksum was right, so a body that makes no sense was written by another version.
     *
     * @throws Journal.JournalException if it makes no sense
     */
    static JournalRecord decode(byte[] body, int tiles) throws IOException {
        ByteBuffer in = ByteBuffer.wrap(body);
        byte kind = in.get();
        if (kind == EXPELLED) {
            return new Expelled(text(in, in.remaining()));
        }
        boolean known = kind == KEPT || kind == CONFIRMED || kind == REVOKED;
        int tile = known && in.remaining() >= Integer.BYTES ? in.getInt() : -1;
        if (tile < 0 || tile >= tiles) {
            throw senseless(kind);
        }
        if (kind == REVOKED) {
            return new Revoked(tile);
        }
        if (kind == CONFIRMED) {
            if (in.remaining() != ContentHash.BYTES) {
                throw senseless(kind);
            }
            byte[] hash = new byte[ContentHash.BYTES];
            in.get(hash);
            return new Confirmed(tile, ContentHash.fromBytes(hash));
        }
        int length = in.remaining() >= Integer.BYTES ? in.getInt() : -1;
        if (length < 0 || length > in.remaining()) {
            throw senseless(kind);
        }
        String machine = text(in, length);
        byte[] data = new byte[in.remaining()];
        in.get(data);
        return new Kept(tile, machine, data);
    }

    private static IOException senseless(byte kind) {
        return new Journal.JournalException(
                "the checkpoint has a record of kind " + kind + " that makes no sense to this version");
    }

    private static String text(ByteBuffer in, int length) {
        byte[] bytes = new byte[length];
        in.get(bytes);
        return new String(bytes, StandardCharsets.UTF_8);
    }
}
