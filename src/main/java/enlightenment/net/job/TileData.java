package enlightenment.net.job;

import enlightenment.file.ContentHash;

/** The result of a unit of work as it travels. Two results of a unit are the same picture exactly if their hashes are equal. */
public interface TileData {
    /** The result; not to be changed. */
    byte[] bytes();

    /** The hash of {@link #bytes()} but for its counters, computed on this machine: never what the sender says. */
    ContentHash hash();

    /** Makes tile data from a result's bytes. */
    @FunctionalInterface
    interface Maker {
        /** @param bytes a result of this unit without problems */
        TileData of(int unit, byte[] bytes);
    }

    /** A result whose hash is that of all its bytes: for a sender, who compares none. */
    static TileData plain(byte[] bytes) {
        return new Bytes(bytes, ContentHash.of(bytes));
    }

    /** The plain form. */
    record Bytes(byte[] bytes, ContentHash hash) implements TileData {}
}
