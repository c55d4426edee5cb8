package enlightenment.checkpoint;

import enlightenment.file.ContentHash;
import enlightenment.file.FileFailure;
import enlightenment.job.RenderIdentity;
import java.io.Closeable;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.channels.FileChannel;
import java.nio.channels.FileLock;
import java.nio.channels.OverlappingFileLockException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.security.SecureRandom;
import java.util.Arrays;
import java.util.Optional;

/**
 * The finished units of a render in a file that is only appended to: the checkpoint of renders and servers.
 *
 * <p>{@link JournalFormat} documents its bytes. What was written is forced to the disk at most every 200 ms. A damaged record costs no
 * other: the reader searches for the next one. A torn record at the end is cut off when the journal is opened again. Units that are lost so
 * are simply rendered again.
 */
public final class CheckpointJournal implements Closeable {
    public static final long FORCE_EVERY_NANOS = 200_000_000L;

    private final FileChannel file;
    private final FileLock lock;
    private final Forcing forcing;
    private final JournalFormat.Header header;
    private final JournalScan scan;
    private long cutBytes;
    private long lastForce;
    private boolean dirty;

    private CheckpointJournal(
            FileChannel file, FileLock lock, Forcing forcing, JournalFormat.Header header, JournalScan scan) {
        this.file = file;
        this.lock = lock;
        this.forcing = forcing;
        this.header = header;
        this.scan = scan;
    }

    /** Brings what was written to the disk. */
    @FunctionalInterface
    interface Forcing {
        void force(FileChannel file) throws IOException;
    }

    /** Receives the records of a journal, in the order in which they were written. */
    @FunctionalInterface
    public interface Reader {
        /**
         * A record.
         *
         * @param plan the {@linkplain #key key} of the plan that it is about
         * @param place for {@link #read}
         */
        void record(long plan, JournalRecord record, long place) throws IOException;
    }

    /** The key that identifies a plan in the records about its units, also where the plan's record is lost. */
    public static long key(byte[] plan) {
        return ContentHash.of(plan).a();
    }

    /**
     * Opens or makes a journal, passes its records to the reader and cuts off a torn end. A journal without results may be of any render:
     * it is begun anew.
     *
     * @param mayHoldResults whether it may hold results of this render already
     * @param now the time in nanoseconds, of any origin
     * @throws JournalException if the file is no journal, belongs to another render, is in use, or holds what it may not; then it is left
     *     as it is
     */
    public static CheckpointJournal open(
            Path path, RenderIdentity render, boolean mayHoldResults, long now, Reader reader) throws IOException {
        return open(path, render, mayHoldResults, now, reader, file -> file.force(true));
    }

    /** {@link #open(Path, RenderIdentity, boolean, long, Reader)} with another way to force, for tests. */
    static CheckpointJournal open(
            Path path, RenderIdentity render, boolean mayHoldResults, long now, Reader reader, Forcing forcing)
            throws IOException {
        if (Files.exists(path) && !Files.isRegularFile(path)) {
            throw new JournalException(path + " is not a file");
        }
        FileChannel file =
                FileChannel.open(path, StandardOpenOption.CREATE, StandardOpenOption.READ, StandardOpenOption.WRITE);
        try {
            FileLock lock = lock(file, path);
            byte[] found = new byte[(int) Math.min(file.size(), JournalFormat.START)];
            JournalFormat.readFully(file, ByteBuffer.wrap(found), 0);
            JournalFormat.Header own = JournalFormat.Header.of(render, new SecureRandom().nextLong());
            JournalFormat.Header header = JournalContents.header(path, found).orElse(own);
            if (JournalContents.isOfOther(path, file, header, own, render)) {
                file.truncate(0);
                header = own;
            }
            JournalScan scan = new JournalScan(file, header);
            int results = 0;
            for (byte[] body = scan.next(); body != null; body = scan.next()) {
                JournalEntry entry = entry(path, body, scan.place());
                results += entry.record() instanceof JournalRecord.Kept ? 1 : 0;
                if (results > 0 && !mayHoldResults) {
                    throw new JournalException(
                            path + " holds results of this render already: --resume goes on with them");
                }
                reader.record(entry.plan(), entry.record(), scan.place());
            }
            CheckpointJournal journal = new CheckpointJournal(file, lock, forcing, header, scan);
            journal.begin(found, render, now);
            return journal;
        } catch (JournalException | RuntimeException e) {
            file.close();
            throw e;
        } catch (IOException e) {
            file.close();
            // Of a full disk the message says no more than that.
            throw FileFailure.named(path, e);
        }
    }

    private static JournalEntry entry(Path path, byte[] body, long place) throws IOException {
        try {
            return JournalEntry.of(body);
        } catch (JournalException e) {
            throw new JournalException(path + ": " + e.getMessage() + " (at byte " + place + "); it is left as it is");
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
        throw new JournalException(path + " is in use by another render");
    }

    /** Mends the header, cuts off a torn end, and says what the journal is of. */
    private void begin(byte[] found, RenderIdentity render, long now) throws IOException {
        byte[] twice = Arrays.copyOf(header.encode(), JournalFormat.START);
        System.arraycopy(twice, 0, twice, JournalFormat.HEADER_BYTES, JournalFormat.HEADER_BYTES);
        cutBytes = Math.max(file.size() - scan.end(), 0);
        file.truncate(scan.end());
        if (!Arrays.equals(found, twice)) {
            writeFully(file, ByteBuffer.wrap(twice), 0);
        }
        file.position(scan.end());
        if (scan.end() == JournalFormat.START) {
            write(0, new JournalRecord.About(render.settings(), render.build()));
        }
        forcing.force(file);
        lastForce = now;
        dirty = false;
    }

    /**
     * Appends a record; forced to the disk now or within the next calls of this or {@link #tick}.
     *
     * @param plan the {@linkplain #key key} of the plan that it is about; 0 if it is about none
     * @return its place, for {@link #read}
     */
    public long append(long now, long plan, JournalRecord record) throws IOException {
        long place = write(plan, record);
        tick(now);
        return place;
    }

    private long write(long plan, JournalRecord record) throws IOException {
        byte[] what = record.encode();
        if (what.length > JournalFormat.LONGEST_BODY - Long.BYTES) {
            throw new JournalException("a record of " + what.length + " bytes is too long for a checkpoint");
        }
        byte[] body = ByteBuffer.allocate(Long.BYTES + what.length)
                .putLong(plan)
                .put(what)
                .array();
        ByteBuffer whole = header.record(body);
        long place = file.position();
        dirty = true;
        // One write for the whole record: what tears is the last record only.
        while (whole.hasRemaining()) {
            file.write(whole);
        }
        return place;
    }

    /** The record at a place; empty if it is damaged. */
    public Optional<JournalRecord> read(long place) throws IOException {
        byte[] body = JournalScan.body(file, header, place, file.size());
        return body == null
                ? Optional.empty()
                : Optional.of(JournalEntry.of(body).record());
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
