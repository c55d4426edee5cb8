package enlightenment.net.job;

import enlightenment.file.ContentHash;

/**
 * The finished sums of one tile column as they travel. What the bytes mean is the renderer's affair; two results of the
 * same tile are the same exactly if their hashes are.
 */
public interface TileData {
    /** The sums; not to be changed. */
    byte[] bytes();

    /** The hash of {@link #bytes()}, computed on this machine: never what the sender says. */
    ContentHash hash();

    /** A result whose hash is computed here. */
    static TileData of(byte[] bytes) {
        return new Bytes(bytes, ContentHash.of(bytes));
    }

    /** The plain form. */
    record Bytes(byte[] bytes, ContentHash hash) implements TileData {}
}
