package enlightenment.codec;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.util.Arrays;

/**
 * Unpacks PIZ ("Technical Introduction to OpenEXR", data compression): the 16-bit words that occur in a chunk are numbered, their numbers
 * go through a Haar wavelet transform channel by channel, and what that leaves is Huffman coded. Floats count as two words each.
 */
final class PizUnpacker implements ExrUnpacker {
    private static final int WORDS = 1 << 16;
    private static final int BITMAP_BYTES = WORDS / 8;

    private final ExrType[] types;
    private final int width;
    private final char[] words = new char[WORDS];
    private char[] data = {};
    private ByteBuffer plain = ByteBuffer.allocate(0);

    PizUnpacker(ExrType[] types, int width) {
        this.types = types;
        this.width = width;
    }

    @Override
    public ByteBuffer unpack(ByteBuffer packed, int size) throws IOException {
        if (plain.capacity() != size) {
            plain = ByteBuffer.allocate(size).order(ByteOrder.LITTLE_ENDIAN);
            data = new char[size / 2];
        }
        packed.order(ByteOrder.LITTLE_ENDIAN);
        int used = readWords(packed);
        need(packed, 4);
        int length = packed.getInt();
        if (length < 0 || length > packed.remaining()) {
            throw new IOException("its Huffman code is said to have " + length + " bytes of " + packed.remaining());
        }
        byte[] coded = new byte[length];
        packed.get(coded);
        PizHuffman.decode(coded, data);
        int rows = rows(size);
        invertWavelets(rows, used);
        arrange(rows);
        return plain.flip();
    }

    private int rows(int size) {
        int bytes = 0;
        for (ExrType type : types) {
            bytes += type.bytes * width;
        }
        return size / bytes;
    }

    private static void need(ByteBuffer packed, int bytes) throws IOException {
        if (packed.remaining() < bytes) {
            throw new IOException("it ends in its head");
        }
    }

    /** Reads which words occur, as a bitmap without the zero bytes at its ends. Word 0 always counts. Returns their number. */
    private int readWords(ByteBuffer packed) throws IOException {
        need(packed, 4);
        int first = packed.getShort() & 0xffff;
        int last = packed.getShort() & 0xffff;
        if (first >= BITMAP_BYTES || last >= BITMAP_BYTES) {
            throw new IOException("its bitmap is said to have bytes " + first + ".." + last + ", of " + BITMAP_BYTES);
        }
        int used = 0;
        words[used++] = 0;
        need(packed, Math.max(last - first + 1, 0));
        for (int i = first; i <= last; i++) {
            int bits = packed.get();
            for (int bit = 0; bit < 8; bit++) {
                int word = 8 * i + bit;
                if (word > 0 && (bits >> bit & 1) != 0) {
                    words[used++] = (char) word;
                }
            }
        }
        Arrays.fill(words, used, WORDS, (char) 0);
        return used;
    }

    private void invertWavelets(int rows, int used) {
        int start = 0;
        for (ExrType type : types) {
            int perPixel = type.bytes / 2;
            for (int part = 0; part < perPixel; part++) {
                new PizWavelet(data, start + part, width, perPixel, rows, used).invert();
            }
            start += perPixel * width * rows;
        }
    }

    /** Channel after channel becomes row after row, and numbers become words. */
    private void arrange(int rows) {
        plain.clear();
        for (int row = 0; row < rows; row++) {
            int start = 0;
            for (ExrType type : types) {
                int perRow = type.bytes / 2 * width;
                int from = start + row * perRow;
                for (int i = from; i < from + perRow; i++) {
                    plain.putChar(words[data[i]]);
                }
                start += perRow * rows;
            }
        }
    }
}
