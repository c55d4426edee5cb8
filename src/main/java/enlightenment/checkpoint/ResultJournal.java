package enlightenment.checkpoint;

import enlightenment.engine.ResultStore;
import enlightenment.file.FileFailure;
import java.io.Closeable;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.ByteBuffer;
import java.nio.channels.FileChannel;
import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;

/**
 * Results in a file of the system's temporary folder, which belongs to this object and is deleted with it. It keeps the few results that
 * may have to be subtracted from sums, where the machine that made them is not trusted any more. Opened when the first is kept.
 */
public final class ResultJournal implements ResultStore, Closeable {
    private final Path folder;
    private final long[] places;
    private final int[] lengths;
    private FileChannel file;
    private long end;

    /** @param units how many units there are */
    public ResultJournal(int units) {
        this(units, Path.of(System.getProperty("java.io.tmpdir")));
    }

    /** A journal in another folder, for tests. */
    ResultJournal(int units, Path folder) {
        this.folder = folder;
        places = new long[units];
        lengths = new int[units];
    }

    /**
     * Keeps a result, in place of what was kept of the unit.
     *
     * @throws UncheckedIOException if it cannot be written
     */
    @Override
    public synchronized void keep(int unit, byte[] bytes) {
        try {
            if (file == null) {
                Path path = Files.createTempFile(folder, "enlightenment-results-", ".tmp");
                file = FileChannel.open(
                        path, StandardOpenOption.READ, StandardOpenOption.WRITE, StandardOpenOption.DELETE_ON_CLOSE);
            }
            ByteBuffer from = ByteBuffer.wrap(bytes);
            for (long at = end; from.hasRemaining(); ) {
                at += file.write(from, at);
            }
            places[unit] = end;
            lengths[unit] = bytes.length;
            end += bytes.length;
        } catch (IOException e) {
            throw new UncheckedIOException(
                    "results cannot be kept in the temporary folder " + folder
                            + " (java -Djava.io.tmpdir=FOLDER gives another): " + reason(e),
                    e);
        }
    }

    private static String reason(IOException e) {
        return e instanceof NoSuchFileException ? "there is no such folder" : FileFailure.reason(e);
    }

    /**
     * The last result kept of a unit.
     *
     * @throws UncheckedIOException if it cannot be read
     */
    @Override
    public synchronized byte[] get(int unit) {
        byte[] bytes = new byte[lengths[unit]];
        try {
            JournalFormat.readFully(file, ByteBuffer.wrap(bytes), places[unit]);
            return bytes;
        } catch (IOException e) {
            throw new UncheckedIOException(
                    "a result that was kept in the temporary folder " + folder + " cannot be read: " + reason(e), e);
        }
    }

    /** The file goes. */
    @Override
    public synchronized void close() throws IOException {
        if (file != null) {
            file.close();
        }
    }
}
