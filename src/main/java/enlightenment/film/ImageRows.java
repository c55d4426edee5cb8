package enlightenment.film;

import enlightenment.file.ScratchFile;
import enlightenment.image.Image;
import java.nio.ByteBuffer;
import java.nio.file.Path;

/** The rows of a finished picture that does not fit in memory. */
final class ImageRows implements Image.Rows {
    private final ScratchFile file;
    private final int rowBytes;
    private int rows;

    ImageRows(int width, Path folder) {
        rowBytes = Math.multiplyExact(3 * Float.BYTES, width);
        file = ScratchFile.in(folder);
    }

    /** Adds the next row from the top. */
    void add(float[] components) {
        byte[] bytes = new byte[rowBytes];
        ByteBuffer.wrap(bytes).asFloatBuffer().put(components);
        file.write((long) rowBytes * rows, bytes, 0, rowBytes);
        rows++;
    }

    @Override
    public void release() {
        file.close();
    }

    @Override
    public void read(int y, float[] components) {
        byte[] bytes = new byte[rowBytes];
        file.read((long) rowBytes * y, bytes, rowBytes);
        ByteBuffer.wrap(bytes).asFloatBuffer().get(components);
    }
}
