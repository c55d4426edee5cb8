package enlightenment.checkpoint;

import enlightenment.file.ContentHash;
import enlightenment.job.RenderIdentity;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.channels.FileChannel;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.zip.CRC32C;

/**
 * The bytes of a {@link CheckpointJournal}. Most significant byte first.
 *
 * <p>A header of 116 bytes, twice: magic (8), hashes of the scene, of the text of the settings and of that of the version (32 each), sign
 * (8), CRC32C of these (4). Then records: the sign (8), length of the body (4), CRC32C of both (4), body, CRC32C of the body (4).
 *
 * <p>The sign is drawn at random for each journal and never leaves the machine: it marks where a record begins after damaged bytes, and a
 * worker cannot send a tile that contains what would be taken for a record.
 */
final class JournalFormat {
    static final int HEADER_BYTES = 116;

    /** The place of the first record: after both headers. */
    static final int START = 2 * HEADER_BYTES;

    static final int RECORD_HEAD = 16;
    static final int RECORD_TAIL = Integer.BYTES;
    static final int LONGEST_BODY = 1 << 30;

    private static final String FORMAT = "ENLJRN";
    private static final byte[] MAGIC = (FORMAT + "03").getBytes(StandardCharsets.US_ASCII);

    private JournalFormat() {}

    /** The render that a journal belongs to, and the sign of its records. */
    record Header(ContentHash scene, ContentHash settings, ContentHash build, long sign) {
        /** The header of a new journal. */
        static Header of(RenderIdentity render, long sign) {
            return new Header(render.scene(), hash(render.settings()), hash(render.build()), sign);
        }

        private static ContentHash hash(String text) {
            return ContentHash.of(text.getBytes(StandardCharsets.UTF_8));
        }

        byte[] encode() {
            ByteBuffer header = ByteBuffer.allocate(HEADER_BYTES);
            header.put(MAGIC).put(scene.toBytes()).put(settings.toBytes()).put(build.toBytes());
            header.putLong(sign);
            return header.putInt(checksum(header.array(), 0, header.position())).array();
        }

        /** The header that begins there, or null if there is none. */
        static Header decode(byte[] bytes, int at) {
            int checked = HEADER_BYTES - Integer.BYTES;
            if (bytes.length - at < HEADER_BYTES
                    || !Arrays.equals(bytes, at, at + MAGIC.length, MAGIC, 0, MAGIC.length)
                    || ByteBuffer.wrap(bytes).getInt(at + checked) != checksum(bytes, at, checked)) {
                return null;
            }
            ByteBuffer in = ByteBuffer.wrap(bytes, at + MAGIC.length, HEADER_BYTES - MAGIC.length);
            return new Header(hash(in), hash(in), hash(in), in.getLong());
        }

        private static ContentHash hash(ByteBuffer in) {
            byte[] hash = new byte[ContentHash.BYTES];
            in.get(hash);
            return ContentHash.fromBytes(hash);
        }

        /** Whether these bytes, fewer than one header, are the beginning of one. */
        static boolean beginsLike(byte[] bytes) {
            int known = Math.min(bytes.length, MAGIC.length);
            return bytes.length < HEADER_BYTES && Arrays.equals(bytes, 0, known, MAGIC, 0, known);
        }

        /** Which of the three differ, in words; empty if none does. */
        String difference(Header wanted) {
            List<String> all = new ArrayList<>();
            if (!build.equals(wanted.build)) {
                all.add("the version");
            }
            if (!scene.equals(wanted.scene)) {
                all.add("the scene or one of its image files");
            }
            if (!settings.equals(wanted.settings)) {
                all.add("the settings");
            }
            return String.join(" and ", all);
        }

        /** A body as a record. */
        ByteBuffer record(byte[] body) {
            ByteBuffer whole = ByteBuffer.allocate(RECORD_HEAD + body.length + RECORD_TAIL);
            whole.putLong(sign).putInt(body.length);
            whole.putInt(checksum(whole.array(), 0, whole.position()));
            whole.put(body).putInt(checksum(body, 0, body.length));
            return whole.flip();
        }
    }

    /** Whether this is the beginning of a journal of some other version. */
    static boolean isOtherVersion(byte[] bytes) {
        byte[] format = FORMAT.getBytes(StandardCharsets.US_ASCII);
        return bytes.length > MAGIC.length
                && Arrays.equals(bytes, 0, format.length, format, 0, format.length)
                && !Arrays.equals(bytes, 0, MAGIC.length, MAGIC, 0, MAGIC.length);
    }

    static int checksum(byte[] bytes, int from, int length) {
        CRC32C crc = new CRC32C();
        crc.update(bytes, from, length);
        return (int) crc.getValue();
    }

    /** Fills the buffer from a place in the file. */
    static void readFully(FileChannel file, ByteBuffer into, long at) throws IOException {
        long position = at;
        while (into.hasRemaining()) {
            int read = file.read(into, position);
            if (read < 0) {
                throw new JournalException("the checkpoint became shorter while it was read");
            }
            position += read;
        }
    }
}
