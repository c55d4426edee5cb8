package enlightenment.codec;

import java.io.IOException;
import java.io.OutputStream;

/** Packs bits into bytes, the lowest bit first, as DEFLATE wants them (RFC 1951, 3.1.1). */
final class BitWriter {
    private static final int SIZE = 1 << 16;

    private final OutputStream out;
    private final byte[] bytes = new byte[SIZE];
    private int count;
    private long bits;
    private int bitCount;

    BitWriter(OutputStream out) {
        this.out = out;
    }

    /** Appends the lowest {@code length} bits of a value that has no higher ones; at most 32 bits. */
    void write(int value, int length) throws IOException {
        bits |= (value & 0xffffffffL) << bitCount;
        bitCount += length;
        if (bitCount >= 32) {
            putWholeBytes();
        }
    }

    private void putWholeBytes() throws IOException {
        for (; bitCount >= 8; bitCount -= 8) {
            putByte((int) bits);
            bits >>>= 8;
        }
    }

    /** Fills the current byte with zero bits. */
    void alignToByte() throws IOException {
        bitCount += -bitCount & 7;
        putWholeBytes();
    }

    /** Appends whole bytes; only between bytes. */
    void writeBytes(byte[] source, int from, int length) throws IOException {
        for (int i = 0; i < length; i++) {
            putByte(source[from + i]);
        }
    }

    /** Appends a number of four bytes, the highest byte first; only between bytes. */
    void writeBigEndian(int value) throws IOException {
        for (int shift = 24; shift >= 0; shift -= 8) {
            putByte(value >>> shift);
        }
    }

    /** Hands everything over to the stream; only between bytes. */
    void flush() throws IOException {
        out.write(bytes, 0, count);
        count = 0;
    }

    private void putByte(int value) throws IOException {
        if (count == SIZE) {
            flush();
        }
        bytes[count++] = (byte) value;
    }
}
