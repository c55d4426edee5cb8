package enlightenment.codec;

import enlightenment.text.Plain;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;

/**
 * Reads OpenEXR pictures ("OpenEXR File Layout", Academy Software Foundation): one part of scan lines, of which the channels R, G and B,
 * or Y alone, are taken, as halves, floats or whole numbers; uncompressed or in the codes {@link ExrCompression} knows. The picture is
 * the data window.
 */
final class ExrReader {
    static final int MAGIC = 20000630;
    private static final int VERSION = 2;
    private static final int TILED = 0x200;
    private static final int LONG_NAMES = 0x400;
    private static final int DEEP = 0x800;
    private static final int SEVERAL_PARTS = 0x1000;

    private final ByteBuffer file;
    private final ExrHeader header;

    private ExrReader(byte[] bytes) throws IOException {
        file = ByteBuffer.wrap(bytes).order(ByteOrder.LITTLE_ENDIAN);
        if (bytes.length < 8) {
            throw new IOException("it ends in its head");
        }
        file.getInt();
        checkVersion(file.getInt());
        header = new ExrHeader(file);
    }

    static boolean matches(byte[] start) {
        return start.length >= 4
                && ByteBuffer.wrap(start).order(ByteOrder.LITTLE_ENDIAN).getInt() == MAGIC;
    }

    /** Decodes a whole file. */
    static Raster read(byte[] file) throws IOException {
        return new ExrReader(file).read();
    }

    private static void checkVersion(int word) throws IOException {
        if ((word & 255) != VERSION) {
            throw new IOException("version " + (word & 255) + " of OpenEXR cannot be read, only " + VERSION);
        }
        String kind = (word & DEEP) != 0
                ? "deep pixels"
                : (word & SEVERAL_PARTS) != 0 ? "several parts" : (word & TILED) != 0 ? "tiles" : null;
        if (kind != null) {
            throw new IOException("OpenEXR files of " + kind + " cannot be read, only one part of scan lines");
        }
        if ((word & ~(255 | LONG_NAMES)) != 0) {
            throw new IOException("it asks for unknown features of OpenEXR: 0x" + Integer.toHexString(word));
        }
    }

    private Raster read() throws IOException {
        int rows = header.compression.rows;
        int chunks = (int) (((long) header.height + rows - 1) / rows);
        long after = file.position() + 8L * chunks;
        if (after > file.limit()) {
            throw new IOException("it ends in the table of its " + chunks + " chunks");
        }
        Raster.checkPlausible(header.width, header.height, file.limit() - after);
        long chunkBytes = header.bytesPerRow * Math.min(rows, header.height);
        if (chunkBytes > Integer.MAX_VALUE - 64) {
            throw new IOException(rows + " rows of " + header.bytesPerRow + " bytes are too long");
        }
        int table = file.position();
        Raster raster = Raster.ofFloats(header.width, header.height);
        boolean[] isRead = new boolean[chunks];
        try (ExrUnpacker unpacker = header.compression.unpacker(header.types(), header.width)) {
            for (int i = 0; i < chunks; i++) {
                readChunk(file.getLong(table + 8 * i), rows, isRead, unpacker, raster.floats());
            }
        }
        return raster;
    }

    private void readChunk(long offset, int rows, boolean[] isRead, ExrUnpacker unpacker, float[] rgb)
            throws IOException {
        if (offset < 0 || offset > file.limit() - 8) {
            throw new IOException("a chunk is said to begin at byte " + offset + " of " + file.limit());
        }
        int first = file.getInt((int) offset);
        int size = file.getInt((int) offset + 4);
        long row = (long) first - header.top;
        if (row < 0 || row >= header.height || row % rows != 0 || isRead[(int) row / rows]) {
            throw new IOException("the chunk at byte " + offset + " is said to begin in row " + first);
        }
        isRead[(int) row / rows] = true;
        if (size < 0 || size > file.limit() - offset - 8) {
            throw new IOException("the chunk of row " + first + " is said to have " + size + " bytes");
        }
        int count = (int) Math.min(rows, header.height - row);
        int expected = (int) (count * header.bytesPerRow);
        ByteBuffer packed = file.slice((int) offset + 8, size);
        ByteBuffer data;
        if (size == expected) {
            data = packed; // what compression does not make shorter stands as it is
        } else {
            try {
                data = unpacker.unpack(packed, expected);
            } catch (IOException e) {
                throw new IOException("the chunk of row " + first + " is damaged: " + e.getMessage(), e);
            }
        }
        data.order(ByteOrder.LITTLE_ENDIAN);
        for (int k = 0; k < count; k++) {
            header.store(data, (int) (k * header.bytesPerRow), (int) row + k, rgb);
        }
    }

    /** For messages. */
    static String quoted(String name) {
        return Plain.quoted(name);
    }
}
