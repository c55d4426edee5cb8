package enlightenment.checkpoint;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.channels.FileChannel;

/**
 * Reads the records of a {@link CheckpointJournal}. Where one is damaged, the next one is looked for: by the sign that every record
 * begins with and by its checksums.
 */
final class JournalScan {
    private static final int WINDOW = 1 << 16;

    private final FileChannel file;
    private final JournalFormat.Header header;
    private final long length;
    private long at = JournalFormat.START;
    private long end = JournalFormat.START;
    private long place;
    private int gaps;
    private long lostBytes;

    JournalScan(FileChannel file, JournalFormat.Header header) throws IOException {
        this.file = file;
        this.header = header;
        length = file.size();
    }

    /** The body of the next record that is whole; null after the last. */
    byte[] next() throws IOException {
        while (at <= length - JournalFormat.RECORD_HEAD - JournalFormat.RECORD_TAIL) {
            byte[] body = body(at);
            if (body != null) {
                place = at;
                if (at > end) {
                    gaps++;
                    lostBytes += at - end;
                }
                at += JournalFormat.RECORD_HEAD + body.length + JournalFormat.RECORD_TAIL;
                end = at;
                return body;
            }
            at = nextSign(at + 1);
        }
        return null;
    }

    /** The place of the record that {@link #next} returned last. */
    long place() {
        return place;
    }

    /** The body of the record that begins there, or null if none does, or a damaged one. */
    private byte[] body(long start) throws IOException {
        return body(file, header, start, length);
    }

    /**
     * The body of the record at a place of a file; null if none is there or it is damaged.
     *
     * @param length that of the file
     */
    static byte[] body(FileChannel file, JournalFormat.Header header, long place, long length) throws IOException {
        ByteBuffer head = ByteBuffer.allocate(JournalFormat.RECORD_HEAD);
        JournalFormat.readFully(file, head, place);
        int size = head.getInt(Long.BYTES);
        int checked = JournalFormat.RECORD_HEAD - Integer.BYTES;
        if (head.getLong(0) != header.sign()
                || head.getInt(checked) != JournalFormat.checksum(head.array(), 0, checked)
                || size < 1
                || size > JournalFormat.LONGEST_BODY
                || size > length - place - JournalFormat.RECORD_HEAD - JournalFormat.RECORD_TAIL) {
            return null;
        }
        byte[] body = new byte[size];
        JournalFormat.readFully(file, ByteBuffer.wrap(body), place + JournalFormat.RECORD_HEAD);
        ByteBuffer tail = ByteBuffer.allocate(JournalFormat.RECORD_TAIL);
        JournalFormat.readFully(file, tail, place + JournalFormat.RECORD_HEAD + size);
        return tail.getInt(0) == JournalFormat.checksum(body, 0, size) ? body : null;
    }

    /** The first place, from this one on, where the sign stands; the end of the file if there is none. */
    private long nextSign(long from) throws IOException {
        for (long start = from; start <= length - Long.BYTES; start += WINDOW - Long.BYTES + 1) {
            ByteBuffer window = ByteBuffer.allocate((int) Math.min(WINDOW, length - start));
            JournalFormat.readFully(file, window, start);
            for (int i = 0; i <= window.capacity() - Long.BYTES; i++) {
                if (window.getLong(i) == header.sign()) {
                    return start + i;
                }
            }
        }
        return length;
    }

    /** The end of the last whole record. */
    long end() {
        return end;
    }

    /** In how many places something was damaged that whole records follow. */
    int gaps() {
        return gaps;
    }

    /** The number of bytes in damaged places. */
    long lostBytes() {
        return lostBytes;
    }
}
