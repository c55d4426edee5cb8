package enlightenment.codec;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.util.zip.DataFormatException;
import java.util.zip.Inflater;

/** The codes that chunks of OpenEXR pictures may have: their numbers are the ordinals. */
enum ExrCompression {
    NONE(1),
    RLE(1),
    ZIPS(1),
    ZIP(16),
    PIZ(0),
    PXR24(0),
    B44(0),
    B44A(0),
    DWAA(0),
    DWAB(0);

    /** How many rows a chunk has; 0 if the code is not known here. */
    final int rows;

    ExrCompression(int rows) {
        this.rows = rows;
    }

    /** @throws IOException that names the code if it is not known here */
    static ExrCompression of(int number) throws IOException {
        if (number < 0 || number >= values().length || values()[number].rows == 0) {
            String name = number >= 0 && number < values().length ? values()[number].name() : "number " + number;
            throw new IOException("compression " + name + " cannot be read, only NONE, RLE, ZIPS and ZIP");
        }
        return values()[number];
    }

    Unpacker unpacker() {
        return new Unpacker(this);
    }

    /** Unpacks chunks one after the other. Its result is overwritten by the next. */
    static final class Unpacker implements AutoCloseable {
        private final ExrCompression code;
        private final Inflater inflater;
        private byte[] coded = {};
        private byte[] plain = {};

        private Unpacker(ExrCompression code) {
            this.code = code;
            inflater = code == ZIP || code == ZIPS ? new Inflater() : null;
        }

        @Override
        public void close() {
            if (inflater != null) {
                inflater.end();
            }
        }

        /** @throws IOException unless it is just so many bytes */
        ByteBuffer unpack(ByteBuffer packed, int size) throws IOException {
            if (coded.length != size) {
                coded = new byte[size];
                plain = new byte[size];
            }
            switch (code) {
                case RLE:
                    expand(packed);
                    break;
                case ZIP, ZIPS:
                    inflate(packed);
                    break;
                default:
                    throw new IOException("it has " + packed.remaining() + " bytes instead of " + size);
            }
            restore();
            return ByteBuffer.wrap(plain);
        }

        private void inflate(ByteBuffer packed) throws IOException {
            inflater.reset();
            inflater.setInput(packed);
            try {
                int done = 0;
                while (done < coded.length) {
                    int count = inflater.inflate(coded, done, coded.length - done);
                    done += count;
                    if (count == 0) {
                        throw new IOException("only " + done + " of " + coded.length + " bytes are there");
                    }
                }
                if (!inflater.finished() && inflater.inflate(new byte[1]) > 0) {
                    throw new IOException("there are more than " + coded.length + " bytes");
                }
            } catch (DataFormatException e) {
                throw new IOException("it cannot be inflated: " + e.getMessage(), e);
            }
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
                    java.util.Arrays.fill(coded, done, done + n, packed.get());
                }
                done += n;
            }
            if (done < coded.length || packed.hasRemaining()) {
                throw new IOException("only " + done + " of " + coded.length + " bytes are there");
            }
        }

        /** Undoes what makes halves and floats shorter: differences, and the bytes of even places before those of odd ones. */
        private void restore() {
            int n = coded.length;
            for (int i = 1; i < n; i++) {
                coded[i] = (byte) (coded[i - 1] + coded[i] - 128);
            }
            int half = (n + 1) / 2;
            for (int i = 0; i < n; i++) {
                plain[i] = coded[(i & 1) == 0 ? i / 2 : half + i / 2];
            }
        }
    }
}
