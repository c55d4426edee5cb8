package enlightenment.codec;

import enlightenment.text.Plain;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;

/**
 * Reads Radiance pictures (G. Ward, "Real pixels", Graphics Gems II, 1991, and the file format page of Radiance): a head of text, then
 * pixels of three mantissas and an exponent that they share, plain or in one of two run-length codes. What stands in {@code EXPOSURE}
 * lines has been multiplied into the pixels, and is divided out.
 */
final class HdrReader {
    private static final byte[] SIGNATURE = "#?".getBytes(StandardCharsets.US_ASCII);
    private static final String FORMAT = "FORMAT=";
    private static final String EXPOSURE = "EXPOSURE=";
    private static final int MOST_LINES = 1000;

    /** The bias of exponents, and the 8 bits of mantissas. */
    private static final int BIAS = 128 + 8;

    /** The widths for which rows may be coded component by component. */
    private static final int LEAST_BY_COMPONENT = 8;

    private static final int MOST_BY_COMPONENT = 0x7fff;

    private final ByteBuffer file;
    private final LinesOfText lines;
    private double exposure = 1;
    private boolean turnedX;
    private boolean turnedY;
    private int width;
    private int height;

    private HdrReader(byte[] bytes) {
        file = ByteBuffer.wrap(bytes);
        lines = new LinesOfText(file);
    }

    static boolean matches(byte[] start) {
        return start.length >= 2 && start[0] == SIGNATURE[0] && start[1] == SIGNATURE[1];
    }

    /** Decodes a whole file. */
    static Raster read(byte[] file) throws IOException {
        return new HdrReader(file).read();
    }

    private Raster read() throws IOException {
        readHead();
        readSize();
        Raster.checkPlausible(width, height, file.remaining());
        Raster raster = Raster.ofFloats(width, height);
        byte[] row = new byte[4 * width];
        for (int y = 0; y < height; y++) {
            readRow(row, y);
            store(row, turnedY ? height - 1 - y : y, raster.floats());
        }
        return raster;
    }

    private void readHead() throws IOException {
        boolean hasFormat = false;
        lines.next();
        for (String line = lines.next(); !line.isEmpty(); line = lines.next()) {
            if (lines.number() > MOST_LINES) {
                throw new IOException("its head has more than " + MOST_LINES + " lines");
            }
            if (line.startsWith(FORMAT)) {
                String format = line.substring(FORMAT.length()).trim();
                if (!format.equals("32-bit_rle_rgbe")) {
                    throw new IOException("line " + lines.number() + " of its head: pixels as " + Plain.quoted(format)
                            + " cannot be read, only as 32-bit_rle_rgbe");
                }
                hasFormat = true;
            } else if (line.startsWith(EXPOSURE)) {
                exposure *= exposure(line.substring(EXPOSURE.length()).trim());
            }
        }
        if (!hasFormat) {
            throw new IOException("its head does not say FORMAT=32-bit_rle_rgbe");
        }
    }

    private double exposure(String text) throws IOException {
        double value = 0;
        try {
            value = Double.parseDouble(text);
        } catch (NumberFormatException e) {
            // Refused below, as a number that makes no sense is.
            value = Double.NaN;
        }
        if (!(value >= 1e-30 && value <= 1e30)) {
            throw new IOException("line " + lines.number() + " of its head: " + Plain.quoted(text) + " is no exposure");
        }
        return value;
    }

    /** Such as {@code -Y 512 +X 1024}: rows from the top, pixels from the left. */
    private void readSize() throws IOException {
        String line = lines.next();
        String[] words = line.trim().split(" +");
        boolean isKnown = words.length == 4 && words[0].matches("[-+]Y") && words[2].matches("[-+]X");
        if (!isKnown || !words[1].matches("[0-9]{1,9}") || !words[3].matches("[0-9]{1,9}")) {
            throw new IOException("line " + lines.number() + " of its head: " + Plain.quoted(line)
                    + " is no size that can be read: it is written like -Y 512 +X 1024");
        }
        height = Integer.parseInt(words[1]);
        width = Integer.parseInt(words[3]);
        turnedY = words[0].charAt(0) == '+';
        turnedX = words[2].charAt(0) == '-';
        Raster.checkSize(width, height);
    }

    private void readRow(byte[] row, int y) throws IOException {
        need(4, y);
        int at = file.position();
        boolean byComponent = width >= LEAST_BY_COMPONENT
                && width <= MOST_BY_COMPONENT
                && file.get(at) == 2
                && file.get(at + 1) == 2
                && file.get(at + 2) >= 0;
        if (!byComponent) {
            readPixels(row, y);
            return;
        }
        if (file.getInt() != (0x02020000 | width)) {
            throw new IOException("row " + y + " says that it has another width");
        }
        for (int c = 0; c < 4; c++) {
            readComponent(row, c, y);
        }
    }

    /** The newer code: one component of a row, in runs of one byte and stretches of different ones. */
    private void readComponent(byte[] row, int component, int y) throws IOException {
        int x = 0;
        while (x < width) {
            need(2, y);
            int count = file.get() & 255;
            boolean isRun = count > 128;
            int n = isRun ? count - 128 : count;
            if (n == 0 || n > width - x) {
                throw new IOException(
                        "row " + y + " is damaged: a run of " + n + " where " + (width - x) + " pixels are missing");
            }
            if (!isRun) {
                need(n, y);
            }
            byte value = isRun ? file.get() : 0;
            for (int i = 0; i < n; i++) {
                row[4 * x++ + component] = isRun ? value : file.get();
            }
        }
    }

    /** The older code: pixels, of which such with three ones repeat the one before. */
    private void readPixels(byte[] row, int y) throws IOException {
        int x = 0;
        int shift = 0;
        while (x < width) {
            need(4, y);
            file.get(row, 4 * x, 4);
            int i = 4 * x;
            if (row[i] != 1 || row[i + 1] != 1 || row[i + 2] != 1) {
                x++;
                shift = 0;
                continue;
            }
            long n = shift > 24 ? Long.MAX_VALUE : (row[i + 3] & 255L) << shift;
            if (x == 0 || n > width - x) {
                throw new IOException(
                        "row " + y + " is damaged: a run of " + n + " where " + (width - x) + " pixels are missing");
            }
            for (int k = 0; k < n; k++, x++) {
                System.arraycopy(row, 4 * x - 4, row, 4 * x, 4);
            }
            shift += 8;
        }
    }

    private void need(int bytes, int y) throws IOException {
        if (file.remaining() < bytes) {
            throw new IOException("it ends in row " + y + " of " + height);
        }
    }

    private void store(byte[] row, int y, float[] rgb) {
        for (int x = 0; x < width; x++) {
            int exponent = row[4 * x + 3] & 255;
            double scale = exponent == 0 ? 0 : Math.scalb(1.0, exponent - BIAS) / exposure;
            int to = 3 * (y * width + (turnedX ? width - 1 - x : x));
            for (int c = 0; c < 3; c++) {
                rgb[to + c] = (float) Math.min((row[4 * x + c] & 255) * scale, Float.MAX_VALUE);
            }
        }
    }
}
