package enlightenment.codec;

import java.io.ByteArrayOutputStream;
import java.io.DataOutputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.util.Map;

/**
 * Writes PNG files (W3C PNG specification, second edition): RGB with 8 or 16 bits, an sRGB chunk, comments. The bytes
 * depend on nothing but pixels and options.
 */
public final class PngWriter {
    static final byte[] SIGNATURE = {(byte) 0x89, 'P', 'N', 'G', '\r', '\n', 0x1a, '\n'};

    private final PngChunkWriter out;

    private final int width;
    private final int height;
    private final int depth;

    /**
     * @param out receives the file; stays open
     * @param width in pixels
     * @param height in pixels
     * @param depth bits per component: 8 or 16
     */
    public PngWriter(OutputStream out, int width, int height, int depth) {
        this.out = new PngChunkWriter(out);
        this.width = width;
        this.height = height;
        this.depth = depth;
    }

    /**
     * Writes the whole file.
     *
     * @param picture its components, {@linkplain #quantize quantized} to the depth
     * @param text comments by their keywords, both as the specification allows them (11.3.4)
     */
    public void write(Components picture, Map<String, String> text) throws IOException {
        out.signature();
        out.chunk("IHDR", header());
        out.chunk("sRGB", new byte[] {0}); // rendering intent: perceptual
        for (Map.Entry<String, String> entry : text.entrySet()) {
            out.text(entry.getKey(), entry.getValue());
        }
        pixels(picture);
        out.chunk("IEND", new byte[0]);
        out.flush();
    }

    private byte[] header() throws IOException {
        ByteArrayOutputStream bytes = new ByteArrayOutputStream();
        DataOutputStream data = new DataOutputStream(bytes);
        data.writeInt(width);
        data.writeInt(height);
        data.writeByte(depth);
        data.writeByte(2); // red, green, blue
        data.writeByte(0); // compression: DEFLATE
        data.writeByte(0); // filters: one of five per row
        data.writeByte(0); // not interlaced
        return bytes.toByteArray();
    }

    private void pixels(Components picture) throws IOException {
        int pixelBytes = 3 * depth / 8;
        int rowBytes = Math.multiplyExact(pixelBytes, width);
        PngFilter filter = new PngFilter(pixelBytes, rowBytes);
        byte[] row = new byte[pixelBytes + rowBytes];
        byte[] above = new byte[pixelBytes + rowBytes];
        ZlibEncoder encoder = new ZlibEncoder(new DataChunks());
        for (int y = 0; y < height; y++) {
            if (depth == 8) {
                quantizeTo8(picture, y, row);
            } else {
                quantizeTo16(picture, y, row);
            }
            encoder.write(filter.apply(row, above), 0, rowBytes + 1);
            byte[] free = above;
            above = row;
            row = free;
        }
        encoder.finish();
    }

    private void quantizeTo8(Components picture, int y, byte[] row) {
        int i = 3;
        for (int x = 0; x < width; x++) {
            row[i++] = (byte) quantize(picture.at(x, y, 0), 255);
            row[i++] = (byte) quantize(picture.at(x, y, 1), 255);
            row[i++] = (byte) quantize(picture.at(x, y, 2), 255);
        }
    }

    private void quantizeTo16(Components picture, int y, byte[] row) {
        int i = 6;
        for (int x = 0; x < width; x++) {
            for (int c = 0; c < 3; c++) {
                int value = quantize(picture.at(x, y, c), 65535);
                row[i++] = (byte) (value >>> 8);
                row[i++] = (byte) value;
            }
        }
    }

    /** The nearest of 0, 1, …, maximum to value · maximum; halves go up, what is no number goes to 0. */
    public static int quantize(float value, int maximum) {
        // The product of a float and a 16-bit number is exact in double; the sum is too wherever it decides anything.
        double scaled = (double) value * maximum + 0.5;
        return scaled >= maximum ? maximum : scaled > 0 ? (int) scaled : 0;
    }

    /** Makes one IDAT chunk of each array that is written. */
    private final class DataChunks extends OutputStream {
        @Override
        public void write(int value) throws IOException {
            write(new byte[] {(byte) value}, 0, 1);
        }

        @Override
        public void write(byte[] data, int from, int length) throws IOException {
            out.chunk("IDAT", data, from, length);
        }
    }
}
