package enlightenment.net.checkpoint;

import enlightenment.file.ContentHash;
import java.io.Closeable;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.channels.FileChannel;
import java.nio.channels.FileLock;
import java.nio.channels.OverlappingFileLockException;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.security.SecureRandom;
import java.util.Arrays;

/**
 * The checkpoint of a server: what was done, as a file that is only ever appended to.
 *
 * <p>{@link JournalFormat} tells its bytes. What was written is forced to the disk at most every 200 ms. A damaged record costs
 * itself and no other: whoever reads looks for the next one. What was cut short ends the file: it is cut off when the journal
 * is opened again. Tiles that are lost so are simply rendered again.
 */
public final class CheckpointJournal implements Closeable {
    public static final long FORCE_EVERY_NANOS = 200_000_000L;

    private final FileChannel file;
    private final FileLock lock;
    private final Forcing forcing;
    private final JournalFormat.Header header;
    private final long cutBytes;
    private final JournalScan scan;
    private long lastForce;
    private boolean dirty;

    private CheckpointJournal(
            FileChannel file,
            FileLock lock,
            Forcing forcing,
            JournalFormat.Header header,
            JournalScan scan,
            long cutBytes,
            long now) {
        this.file = file;
        this.lock = lock;
        this.forcing = forcing;
        this.header = header;
        this.scan = scan;
        this.cutBytes = cutBytes;
        lastForce = now;
    }

    /** Brings what was written to the disk. */
    @FunctionalInterface
    interface Forcing {
        void force(FileChannel file) throws IOException;
    }

    /** Hears what a journal holds, in the order in which it was written. */
    @FunctionalInterface
    public interface Reader {
        void record(JournalRecord record) throws IOException;
    }

    /**
     * Opens a journal, makes it if it does not exist, tells what it holds and cuts off a torn end.
     *
     * @param now the time in nanoseconds, of any origin
     * @throws JournalException if the file is no journal, belongs to another job or is in use
     */
    public static CheckpointJournal open(Path path, ContentHash job, int tiles, long now, Reader reader)
            throws IOException {
        return open(path, job, tiles, now, reader, file -> file.force(true));
    }

    /** The same with another way to force, for tests. */
    static CheckpointJournal open(Path path, ContentHash job, int tiles, long now, Reader reader, Forcing forcing)
            throws IOException {
        FileChannel file =
                FileChannel.open(path, StandardOpenOption.CREATE, StandardOpenOption.READ, StandardOpenOption.WRITE);
        try {
            FileLock lock = lock(file, path);
            long length = file.size();
            JournalFormat.Header header = header(file, path, job, tiles);
            JournalScan scan = new JournalScan(file, header);
            for (byte[] body = scan.next(); body != null; body = scan.next()) {
                reader.record(JournalRecord.decode(body, tiles));
            }
            file.truncate(scan.end());
            file.position(scan.end());
            forcing.force(file);
            long cut = Math.max(length - scan.end(), 0);
            return new CheckpointJournal(file, lock, forcing, header, scan, cut, now);
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

    /** The journal's header; both copies are whole when this returns. */
    private static JournalFormat.Header header(FileChannel file, Path path, ContentHash job, int tiles)
            throws IOException {
        byte[] found = new byte[(int) Math.min(file.size(), JournalFormat.START)];
        JournalFormat.readFully(file, ByteBuffer.wrap(found), 0);
        JournalFormat.Header header = JournalFormat.Header.decode(found, 0);
        if (header == null) {
            header = JournalFormat.Header.decode(found, JournalFormat.HEADER_BYTES);
        }
        if (header == null) {
            header = new JournalFormat.Header(job, tiles, new SecureRandom().nextLong());
            // A server may have died while it wrote the first one.
            if (!header.beginsLike(found)) {
                throw new JournalException(
                        JournalFormat.isOtherVersion(found)
                                ? path
                                        + " is a checkpoint of another version of Enlightenment, which cannot go on here;"
                                        + " it is left as it is"
                                : path + " is not a checkpoint; it is left as it is");
            }
        }
        if (!header.job().equals(job) || header.tiles() != tiles) {
            throw new JournalException(path + " is the checkpoint of another job: it has the hash " + header.job()
                    + ", this job has " + job + " (scene, textures, settings or version differ)");
        }
        byte[] twice = Arrays.copyOf(header.encode(), JournalFormat.START);
        System.arraycopy(twice, 0, twice, JournalFormat.HEADER_BYTES, JournalFormat.HEADER_BYTES);
        if (!Arrays.equals(found, twice)) {
            writeFully(file, ByteBuffer.wrap(twice), 0);
        }
        return header;
    }

    /** Appends a record; forced to the disk now or within the next calls of this or {@link #tick}. */
    public void append(long now, JournalRecord record) throws IOException {
        byte[] body = record.encode();
        if (body.length > JournalFormat.LONGEST_BODY) {
            throw new JournalException("a record of " + body.length + " bytes is too long for a checkpoint");
        }
        ByteBuffer whole = header.record(body);
        // One write for the whole record: what tears is the last record only.
        while (whole.hasRemaining()) {
            file.write(whole);
        }
        dirty = true;
        tick(now);
    }

    /** Forces what was written to the disk if the last time was 200 ms ago. */
    public void tick(long now) throws IOException {
        if (dirty && now - lastForce >= FORCE_EVERY_NANOS) {
            forcing.force(file);
            lastForce = now;
            dirty = false;
        }
    }

    /** Bytes in the middle that were found damaged on opening; the records in them are lost, those after them are not. */
    public long lostBytes() {
        return scan.lostBytes();
    }

    /** In how many places that was. */
    public int gaps() {
        return scan.gaps();
    }

    /** Bytes of a torn or damaged end that were cut off on opening. */
    public long cutBytes() {
        return cutBytes;
    }

    /** Forces what was written to the disk and closes the file. */
    @Override
    public void close() throws IOException {
        try (file;
                lock) {
            if (dirty) {
                forcing.force(file);
            }
        }
    }

    private static void writeFully(FileChannel file, ByteBuffer from, long at) throws IOException {
        long position = at;
        while (from.hasRemaining()) {
            position += file.write(from, position);
        }
    }
}
