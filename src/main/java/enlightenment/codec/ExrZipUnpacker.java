package enlightenment.codec;

import java.io.IOException;
import java.nio.ByteBuffer;

/** Unpacks ZIP and ZIPS: DEFLATE of predicted bytes. */
final class ExrZipUnpacker implements ExrUnpacker {
    private final Inflation inflation = new Inflation();
    private byte[] coded = {};
    private byte[] plain = {};

    ExrZipUnpacker() {}

    @Override
    public ByteBuffer unpack(ByteBuffer packed, int size) throws IOException {
        if (coded.length != size) {
            coded = new byte[size];
            plain = new byte[size];
        }
        inflation.inflate(packed, coded, size);
        ExrPrediction.undo(coded, plain);
        return ByteBuffer.wrap(plain);
    }

    @Override
    public void close() {
        inflation.close();
    }
}
