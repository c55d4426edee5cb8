package enlightenment.codec;

import java.io.IOException;
import java.io.OutputStream;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;

/**
 * Portable float maps: a text head ("PF", width and height, a number whose sign tells the byte order), then floats, bottom
 * row first (P. Debevec's PFM). What is written reads back bit by bit.
 */
public final class PfmFormat {
    private PfmFormat() {}

    /**
     * Writes a colour map, little-endian.
     *
     * @param out receives the file; stays open
     */
    public static void write(int width, int height, Components picture, OutputStream out) throws IOException {
        String head = "PF\n" + width + " " + height + "\n-1.0\n";
        out.write(head.getBytes(StandardCharsets.US_ASCII));
        byte[] row = new byte[Math.multiplyExact(12, width)];
        ByteBuffer buffer = ByteBuffer.wrap(row).order(ByteOrder.LITTLE_ENDIAN);
        for (int y = height - 1; y >= 0; y--) {
            buffer.clear();
            for (int x = 0; x < width; x++) {
                for (int c = 0; c < 3; c++) {
                    buffer.putFloat(picture.at(x, y, c));
                }
            }
            out.write(row);
        }
    }

    static boolean matches(byte[] file) {
        return file.length > 3 && file[0] == 'P' && (file[1] == 'F' || file[1] == 'f') && isSpace(file[2]);
    }

    /** Decodes a whole file, colour ("PF") or grey ("Pf"), of either byte order. The scale's size is not applied. */
    static Raster read(byte[] file) throws IOException {
        int channels = file[1] == 'F' ? 3 : 1;
        ByteBuffer buffer = ByteBuffer.wrap(file, 2, file.length - 2);
        int width = (int) number(buffer, "width");
        int height = (int) number(buffer, "height");
        double scale = number(buffer, "scale");
        Raster.checkSize(width, height);
        long expected = 4L * channels * width * height;
        if (buffer.remaining() != expected) {
            throw new IOException(width + " x " + height + " pixels take " + expected + " bytes, but "
                    + buffer.remaining() + " follow the head");
        }
        buffer.order(scale < 0 ? ByteOrder.LITTLE_ENDIAN : ByteOrder.BIG_ENDIAN);
        Raster raster = Raster.ofFloats(width, height);
        float[] rgb = raster.floats();
        for (int y = height - 1; y >= 0; y--) {
            int i = 3 * y * width;
            for (int x = 0; x < width; x++) {
                float first = buffer.getFloat();
                rgb[i++] = first;
                rgb[i++] = channels == 1 ? first : buffer.getFloat();
                rgb[i++] = channels == 1 ? first : buffer.getFloat();
            }
        }
        return raster;
    }

    /** The next number of the head, together with the one white space after it. */
    private static double number(ByteBuffer buffer, String what) throws IOException {
        StringBuilder text = new StringBuilder();
        while (buffer.hasRemaining() && text.length() < 40) {
            byte next = buffer.get();
            if (!isSpace(next)) {
                text.append((char) (next & 255));
            } else if (text.length() > 0) {
                break;
            }
        }
        try {
            return Double.parseDouble(text.toString());
        } catch (NumberFormatException e) {
            throw new IOException("the " + what + " in the head is not a number", e);
        }
    }

    private static boolean isSpace(byte value) {
        return value == ' ' || value == '\n' || value == '\t' || value == '\r';
    }
}
