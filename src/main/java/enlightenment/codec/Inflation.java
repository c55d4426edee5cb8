package enlightenment.codec;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.util.zip.DataFormatException;
import java.util.zip.Inflater;

/** Inflates zlib streams whose length is known. */
final class Inflation implements AutoCloseable {
    private final Inflater inflater = new Inflater();

    Inflation() {}

    /**
     * Inflates a stream into the first bytes of an array.
     *
     * @throws IOException if the stream is damaged, shorter or longer
     */
    void inflate(ByteBuffer packed, byte[] into, int size) throws IOException {
        inflater.reset();
        inflater.setInput(packed);
        try {
            int done = 0;
            while (done < size) {
                int count = inflater.inflate(into, done, size - done);
                done += count;
                if (count == 0) {
                    throw new IOException("only " + done + " of " + size + " bytes are there");
                }
            }
            if (!inflater.finished() && inflater.inflate(new byte[1]) > 0) {
                throw new IOException("there are more than " + size + " bytes");
            }
        } catch (DataFormatException e) {
            throw new IOException("it cannot be inflated: " + e.getMessage(), e);
        }
    }

    @Override
    public void close() {
        inflater.end();
    }
}
