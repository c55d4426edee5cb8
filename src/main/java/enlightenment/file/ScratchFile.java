package enlightenment.file;

import java.io.Closeable;
import java.io.EOFException;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.ByteBuffer;
import java.nio.channels.FileChannel;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.util.Arrays;
import java.util.EnumSet;

/**
 * Numbers of one process that do not fit in its memory. The file has no name where the system can remove one that is open, and is
 * removed with its last reference elsewhere: nothing of it remains when the process ends, however that happens. For use by several threads
 * at once, in disjoint ranges.
 *
 * <p>Failures of the disk are {@link UncheckedIOException}s whose message names the folder and the reason.
 */
public final class ScratchFile implements Closeable {
    /** The JDK copies what it transfers through a buffer of its own of that size, one for each thread. */
    private static final int MOST_AT_ONCE = 1 << 20;

    private final Path folder;
    private final FileChannel channel;

    private ScratchFile(Path folder, FileChannel channel) {
        this.folder = folder;
        this.channel = channel;
    }

    /** An empty file in this folder. */
    public static ScratchFile in(Path folder) {
        Path file = folder.resolve(TemporaryFile.reserveName());
        try {
            return new ScratchFile(
                    folder,
                    FileChannel.open(
                            file,
                            EnumSet.of(
                                    StandardOpenOption.CREATE_NEW,
                                    StandardOpenOption.READ,
                                    StandardOpenOption.WRITE,
                                    StandardOpenOption.DELETE_ON_CLOSE)));
        } catch (IOException e) {
            throw failed(folder, e);
        }
    }

    /**
     * How many bytes files of this process can still take in a folder.
     *
     * @return a very large number where that is not known
     */
    public static long usableSpace(Path folder) {
        try {
            long usable = Files.getFileStore(folder).getUsableSpace();
            return usable < 0 ? Long.MAX_VALUE : usable;
        } catch (IOException e) {
            return Long.MAX_VALUE;
        }
    }

    private static UncheckedIOException failed(Path folder, IOException e) {
        return new UncheckedIOException(new IOException(
                "cannot keep what is rendered in a file in " + folder + ": " + FileFailure.reason(e), e));
    }

    /** What transfers bytes. */
    @FunctionalInterface
    private interface Transfer {
        void run() throws IOException;
    }

    /** An interrupt would close the channel: it is taken back meanwhile. */
    private void uninterrupted(Transfer transfer) {
        boolean wasInterrupted = Thread.interrupted();
        try {
            transfer.run();
        } catch (IOException e) {
            throw failed(folder, e);
        } finally {
            if (wasInterrupted) {
                Thread.currentThread().interrupt();
            }
        }
    }

    /** Writes bytes at a position, which may lie beyond the end. */
    public void write(long position, byte[] bytes, int from, int length) {
        uninterrupted(() -> {
            for (int done = 0; done < length; ) {
                int size = Math.min(length - done, MOST_AT_ONCE);
                done += channel.write(ByteBuffer.wrap(bytes, from + done, size), position + done);
            }
        });
    }

    /** Reads bytes from a position; those that were never written are 0. */
    public void read(long position, byte[] bytes, int length) {
        uninterrupted(() -> {
            int done = 0;
            while (done < length) {
                int size = Math.min(length - done, MOST_AT_ONCE);
                int read = channel.read(ByteBuffer.wrap(bytes, done, size), position + done);
                if (read < 0) {
                    break;
                }
                if (read == 0) {
                    throw new EOFException("nothing can be read");
                }
                done += read;
            }
            Arrays.fill(bytes, done, length, (byte) 0);
        });
    }

    /** Gives the space back; nothing can be read any more. */
    @Override
    public void close() {
        uninterrupted(channel::close);
    }
}
