package enlightenment.film;

import enlightenment.file.ScratchFile;
import java.nio.ByteBuffer;
import java.nio.file.Path;

/** Figures of pixels with few samples that do not fit in memory. */
final class FewSamplesFile implements FewSamplesSplats.Figures {
    /** Per pixel. */
    static final int BYTES = 4 * Float.BYTES;

    private static final int PIXELS_AT_ONCE = 1 << 15;

    private final ScratchFile file;
    private final byte[] bytes = new byte[BYTES * PIXELS_AT_ONCE];
    private final ByteBuffer buffer = ByteBuffer.wrap(bytes);

    /** Which piece of the file is in the buffer. */
    private long piece;

    private boolean isChanged;

    FewSamplesFile(Path folder) {
        file = ScratchFile.in(folder);
    }

    private void turnTo(long pixel) {
        long wanted = pixel / PIXELS_AT_ONCE;
        if (wanted == piece) {
            return;
        }
        if (isChanged) {
            file.write(piece * bytes.length, bytes, 0, bytes.length);
            isChanged = false;
        }
        file.read(wanted * bytes.length, bytes, bytes.length);
        piece = wanted;
    }

    @Override
    public void put(long pixel, float[] four) {
        turnTo(pixel);
        buffer.position(BYTES * (int) (pixel % PIXELS_AT_ONCE));
        for (float number : four) {
            buffer.putFloat(number);
        }
        isChanged = true;
    }

    @Override
    public void get(long pixel, float[] four) {
        turnTo(pixel);
        buffer.position(BYTES * (int) (pixel % PIXELS_AT_ONCE));
        for (int i = 0; i < four.length; i++) {
            four[i] = buffer.getFloat();
        }
    }

    @Override
    public void release() {
        file.close();
    }
}
