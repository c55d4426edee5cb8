package enlightenment.codec;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.util.Arrays;

/** Unpacks RLE: runs of equal bytes, of predicted ones. */
final class ExrRunsUnpacker implements ExrUnpacker {
    private byte[] coded = {};
    private byte[] plain = {};

    ExrRunsUnpacker() {}

    @Override
    public ByteBuffer unpack(ByteBuffer packed, int size) throws IOException {
        if (coded.length != size) {
            coded = new byte[size];
            plain = new byte[size];
        }
        expand(packed);
        ExrPrediction.undo(coded, plain);
        return ByteBuffer.wrap(plain);
    }

    /** A count n: n + 1 times the next byte; or -n: the next n bytes. */
    private void expand(ByteBuffer packed) throws IOException {
        int done = 0;
        while (packed.remaining() > 1) {
            int count = packed.get();
            int n = count < 0 ? -count : count + 1;
            if (n > coded.length - done || count < 0 && n > packed.remaining()) {
                throw new IOException("a run of " + n + " bytes is too long");
            }
            if (count < 0) {
                packed.get(coded, done, n);
            } else {
                Arrays.fill(coded, done, done + n, packed.get());
            }
            done += n;
        }
        if (done < coded.length || packed.hasRemaining()) {
            throw new IOException("only " + done + " of " + coded.length + " bytes are there");
        }
    }
}
