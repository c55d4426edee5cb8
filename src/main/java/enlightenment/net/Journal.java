package enlightenment.net;

import java.io.Closeable;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.channels.FileChannel;
import java.nio.channels.FileLock;
import java.nio.channels.OverlappingFileLockException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.util.Arrays;
import java.util.zip.CRC32C;

/**
 * The checkpoint of a server: what was done, as a file that is only ever appended to.
 *
 * <p>A header of 48 bytes (magic, job hash, number of tiles, CRC32C of these), then records: length of the body (4 bytes),
 * CRC32C of length and body (4), body. Most significant byte first. What was written is forced to the disk at most every 200
 * ms; a record that was cut short or damaged ends the file: it and what follows is cut off when the journal is opened
 * again, and the tiles in it are simply rendered again.
 */
final class Journal implements Closeable {
    static final int HEADER_BYTES = 48;
    static final long FORCE_EVERY_NANOS = 200_000_000L;

    private static final byte[] MAGIC = "ENLJRN02".getBytes(StandardCharsets.US_ASCII);
    private static final int RECORD_HEAD = 2 * Integer.BYTES;
    private static final int LONGEST_BODY = Limits.FRAME + (64 << 10);

    private final FileChannel file;
    private final FileLock lock;
    private final long cutBytes;
    private long lastForce;
    private boolean dirty;

    private Journal(FileChannel file, FileLock lock, long cutBytes, long now) {
        this.file = file;
        this.lock = lock;
        this.cutBytes = cutBytes;
        lastForce = now;
    }

    /** A journal that cannot be used; the message says why. */
    static final class JournalException extends IOException {
        private static final long serialVersionUID = 1L;

        JournalException(String message) {
            super(message);
        }
    }

    /** Hears what a journal holds, in the order in which it was written. */
    @FunctionalInterface
    interface Reader {
        void record(JournalRecord record) throws IOException;
    }

    /**
     * Opens a journal, makes it if it does not exist, tells what it holds and cuts off a torn end.
     *
     * @param now the time in nanoseconds, of any origin
     * @throws JournalException if the file is no journal, belongs to another job or is in use
     */
    static Journal open(Path path, ContentHash job, int tiles, long now, Reader reader) throws IOException {
        FileChannel file =
                FileChannel.open(path, StandardOpenOption.CREATE, StandardOpenOption.READ, StandardOpenOption.WRITE);
        try {
            FileLock lock = lock(file, path);
            byte[] header = header(job, tiles);
            long length = file.size();
            long good = HEADER_BYTES;
            if (checkHeader(file, path, header, job)) {
                good = readRecords(file, length, tiles, reader);
            } else {
                writeFully(file, ByteBuffer.wrap(header), 0);
            }
            long cut = Math.max(length - good, 0);
            file.truncate(good);
            file.position(good);
            file.force(true);
            return new Journal(file, lock, cut, now);
        } catch (IOException | RuntimeException e) {
            file.close();
            throw e;
        }
    }

    private static FileLock lock(FileChannel file, Path path) throws IOException {
        try {
            FileLock lock = file.tryLock();
            if (lock != null) {
                return lock;
            }
        } catch (OverlappingFileLockException e) {
            // Another journal of this process: the same answer.
        }
        throw new JournalException(path + " is in use by another server");
    }

    private static byte[] header(ContentHash job, int tiles) {
        ByteBuffer header = ByteBuffer.allocate(HEADER_BYTES);
        header.put(MAGIC).put(job.toBytes()).putInt(tiles);
        return header.putInt(checksum(header.array(), 0, HEADER_BYTES - Integer.BYTES))
                .array();
    }

    /** Whether the file has our header; false if it is a part of it only, from a server that died while it wrote it. */
    private static boolean checkHeader(FileChannel file, Path path, byte[] ours, ContentHash job) throws IOException {
        byte[] found = new byte[(int) Math.min(file.size(), HEADER_BYTES)];
        readFully(file, ByteBuffer.wrap(found), 0);
        if (Arrays.equals(found, Arrays.copyOf(ours, found.length))) {
            return found.length == HEADER_BYTES;
        }
        int checked = HEADER_BYTES - Integer.BYTES;
        boolean isJournal = found.length == HEADER_BYTES
                && Arrays.equals(Arrays.copyOf(found, MAGIC.length), MAGIC)
                && ByteBuffer.wrap(found).getInt(checked) == checksum(found, 0, checked);
        if (!isJournal) {
            throw new JournalException(path + " is not a checkpoint of this version; it is left as it is");
        }
        ContentHash other =
                ContentHash.fromBytes(Arrays.copyOfRange(found, MAGIC.length, MAGIC.length + ContentHash.BYTES));
        throw new JournalException(path + " is the checkpoint of another job: it has the hash " + other
                + ", this job has " + job + " (scene, textures, settings or version differ)");
    }

    /** Reads records up to the first bad one; returns where it begins. */
    private static long readRecords(FileChannel file, long length, int tiles, Reader reader) throws IOException {
        long at = HEADER_BYTES;
        ByteBuffer head = ByteBuffer.allocate(RECORD_HEAD);
        while (length - at >= RECORD_HEAD) {
            head.clear();
            readFully(file, head, at);
            int bodyLength = head.getInt(0);
            if (bodyLength < 1 || bodyLength > LONGEST_BODY || bodyLength > length - at - RECORD_HEAD) {
                return at;
            }
            ByteBuffer whole = ByteBuffer.allocate(Integer.BYTES + bodyLength).putInt(bodyLength);
            readFully(file, whole, at + RECORD_HEAD);
            byte[] checked = whole.array();
            if (checksum(checked, 0, checked.length) != head.getInt(Integer.BYTES)) {
                return at;
            }
            reader.record(JournalRecord.decode(Arrays.copyOfRange(checked, Integer.BYTES, checked.length), tiles));
            at += RECORD_HEAD + bodyLength;
        }
        return at;
    }

    /** Appends a record; forced to the disk now or within the next calls of this or {@link #tick}. */
    void append(long now, JournalRecord record) throws IOException {
        byte[] body = record.encode();
        if (body.length > LONGEST_BODY) {
            throw new JournalException("a record of " + body.length + " bytes is too long for a checkpoint");
        }
        ByteBuffer whole = ByteBuffer.allocate(RECORD_HEAD + body.length);
        CRC32C crc = new CRC32C();
        crc.update(ByteBuffer.allocate(Integer.BYTES).putInt(body.length).flip());
        crc.update(body);
        whole.putInt(body.length).putInt((int) crc.getValue()).put(body).flip();
        // One write for the whole record: what tears is the last record only.
        while (whole.hasRemaining()) {
            file.write(whole);
        }
        dirty = true;
        tick(now);
    }

    /** Forces what was written to the disk if the last time was 200 ms ago. */
    void tick(long now) throws IOException {
        if (dirty && now - lastForce >= FORCE_EVERY_NANOS) {
            file.force(false);
            lastForce = now;
            dirty = false;
        }
    }

    /** Whether something is written but not forced to the disk yet. */
    boolean isDirty() {
        return dirty;
    }

    /** Bytes of a torn or damaged end that were cut off on opening. */
    long cutBytes() {
        return cutBytes;
    }

    /** Forces what was written to the disk and closes the file. */
    @Override
    public void close() throws IOException {
        try (file;
                lock) {
            file.force(true);
        }
    }

    private static int checksum(byte[] bytes, int from, int to) {
        CRC32C crc = new CRC32C();
        crc.update(bytes, from, to - from);
        return (int) crc.getValue();
    }

    private static void readFully(FileChannel file, ByteBuffer into, long at) throws IOException {
        long position = at;
        while (into.hasRemaining()) {
            int read = file.read(into, position);
            if (read < 0) {
                throw new JournalException("the checkpoint became shorter while it was read");
            }
            position += read;
        }
    }

    private static void writeFully(FileChannel file, ByteBuffer from, long at) throws IOException {
        long position = at;
        while (from.hasRemaining()) {
            position += file.write(from, position);
        }
    }
}
