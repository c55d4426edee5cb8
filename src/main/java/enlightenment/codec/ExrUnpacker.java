package enlightenment.codec;

import java.io.IOException;
import java.nio.ByteBuffer;

/** Unpacks the chunks of an OpenEXR picture, one after the other. */
interface ExrUnpacker extends AutoCloseable {
    /**
     * Unpacks a chunk.
     *
     * @param packed its bytes, from position to limit
     * @param size the number of bytes that it stands for: whole rows
     * @return these bytes; the next call overwrites them
     * @throws IOException with the reason, if there are fewer or more
     */
    ByteBuffer unpack(ByteBuffer packed, int size) throws IOException;

    @Override
    default void close() {}
}
