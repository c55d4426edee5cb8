package enlightenment.net.parts;

import enlightenment.file.ScratchFile;
import java.io.Closeable;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.stream.IntStream;

/** The results of a part's units until all of them are there, in a file beside that of the part. For use by several threads at once. */
final class PartResults implements Closeable {
    private final int[] units;
    private final long[] places;

    /** By index in {@link #units}, the length of the result; negative while it is missing. */
    private final int[] lengths;

    private final ScratchFile file;
    private int made;
    private long end;

    /**
     * Results of which nothing is there yet.
     *
     * @param units their numbers, ascending
     * @throws java.io.UncheckedIOException if there can be no file in this folder
     */
    PartResults(int[] units, Path folder) {
        this.units = units.clone();
        places = new long[units.length];
        lengths = new int[units.length];
        Arrays.fill(lengths, -1);
        file = ScratchFile.in(folder);
    }

    /** Keeps the result of a unit, which must not be there. */
    void keep(int unit, byte[] bytes) {
        int i = Arrays.binarySearch(units, unit);
        long at;
        synchronized (this) {
            at = end;
            end += bytes.length;
        }
        file.write(at, bytes, 0, bytes.length);
        synchronized (this) {
            places[i] = at;
            lengths[i] = bytes.length;
            made++;
        }
    }

    /** Number of results that are there. */
    synchronized int made() {
        return made;
    }

    /** The units whose results are there, ascending. */
    synchronized int[] units() {
        return IntStream.range(0, units.length)
                .filter(i -> lengths[i] >= 0)
                .map(i -> units[i])
                .toArray();
    }

    /** The result of a unit that is there. */
    byte[] get(int unit) {
        int i = Arrays.binarySearch(units, unit);
        byte[] bytes;
        long at;
        synchronized (this) {
            bytes = new byte[lengths[i]];
            at = places[i];
        }
        file.read(at, bytes, bytes.length);
        return bytes;
    }

    @Override
    public void close() {
        file.close();
    }
}
