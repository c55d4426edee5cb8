package enlightenment.codec;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;

/**
 * Unpacks PXR24 (L. Gritz, Pixar): of floats the upper 24 bits were kept. A channel's part of a row is a plane for each byte of its
 * numbers, the highest byte first, of differences from pixel to pixel; all of it is deflated.
 */
final class Pxr24Unpacker implements ExrUnpacker {
    private static final int KEPT_OF_FLOAT = 3;

    private final Inflation inflation = new Inflation();
    private final ExrType[] types;
    private final int width;
    private byte[] coded = {};
    private ByteBuffer plain = ByteBuffer.allocate(0);

    Pxr24Unpacker(ExrType[] types, int width) {
        this.types = types;
        this.width = width;
    }

    private static int planes(ExrType type) {
        return type == ExrType.FLOAT ? KEPT_OF_FLOAT : type.bytes;
    }

    @Override
    public ByteBuffer unpack(ByteBuffer packed, int size) throws IOException {
        int plainRow = 0;
        int codedRow = 0;
        for (ExrType type : types) {
            plainRow += type.bytes * width;
            codedRow += planes(type) * width;
        }
        int rows = size / plainRow;
        if (plain.capacity() != size) {
            plain = ByteBuffer.allocate(size).order(ByteOrder.LITTLE_ENDIAN);
            coded = new byte[rows * codedRow];
        }
        inflation.inflate(packed, coded, coded.length);
        plain.clear();
        int at = 0;
        for (int row = 0; row < rows; row++) {
            for (ExrType type : types) {
                sum(type, at);
                at += planes(type) * width;
            }
        }
        return plain.flip();
    }

    /** Appends a channel's part of a row, whose planes begin there. */
    private void sum(ExrType type, int first) {
        int planes = planes(type);
        int lacking = type == ExrType.FLOAT ? 8 : 0;
        int value = 0;
        for (int x = 0; x < width; x++) {
            int difference = 0;
            for (int plane = 0; plane < planes; plane++) {
                difference = difference << 8 | coded[first + plane * width + x] & 255;
            }
            value += difference << lacking;
            if (type == ExrType.HALF) {
                plain.putShort((short) value);
            } else {
                plain.putInt(value);
            }
        }
    }

    @Override
    public void close() {
        inflation.close();
    }
}
