package enlightenment.film;

import enlightenment.file.ScratchFile;
import java.nio.ByteBuffer;
import java.nio.file.Path;

/** The error figures of a film's pixels in a file, where memory is too small. They are written once, then read from the beginning. */
final class FigureFile implements PixelFigures, PixelFigures.Visitor {
    private static final int BYTES = 2 * Float.BYTES + Integer.BYTES;
    private static final int PIXELS_AT_ONCE = 1 << 16;
    private static final int RARE = Integer.MIN_VALUE;

    private final ScratchFile file;
    private final byte[] bytes = new byte[BYTES * PIXELS_AT_ONCE];
    private final ByteBuffer buffer = ByteBuffer.wrap(bytes);
    private long written;
    private long samples;

    FigureFile(Path folder) {
        file = ScratchFile.in(folder);
    }

    /** Adds the next pixel. */
    @Override
    public void pixel(float first, float second, int count, boolean rare) {
        buffer.putFloat(first).putFloat(second).putInt(rare ? count | RARE : count);
        samples += count;
        if (!buffer.hasRemaining()) {
            flush();
        }
    }

    private void flush() {
        file.write(written, bytes, 0, buffer.position());
        written += buffer.position();
        buffer.clear();
    }

    /** The samples of all pixels. */
    long samples() {
        return samples;
    }

    @Override
    public void forEach(Visitor visitor) {
        flush();
        for (long at = 0; at < written; at += bytes.length) {
            int length = (int) Math.min(bytes.length, written - at);
            file.read(at, bytes, length);
            for (buffer.clear().limit(length); buffer.hasRemaining(); ) {
                float first = buffer.getFloat();
                float second = buffer.getFloat();
                int count = buffer.getInt();
                visitor.pixel(first, second, count & ~RARE, (count & RARE) != 0);
            }
        }
        buffer.clear();
    }

    @Override
    public int pixelsInMemory() {
        return 0;
    }

    void close() {
        file.close();
    }
}
