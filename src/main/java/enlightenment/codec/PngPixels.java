package enlightenment.codec;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.util.Arrays;
import java.util.Iterator;
import java.util.List;
import java.util.zip.DataFormatException;
import java.util.zip.Inflater;

/** Unpacks the pixels of a PNG file: decompression, filters, interlacing, samples of 1 to 16 bits. */
final class PngPixels {
    /** Adam7 (PNG specification, 8.2): first column, first row, column step and row step of each pass. */
    private static final int[][] INTERLACED = {
        {0, 0, 8, 8}, {4, 0, 8, 8}, {0, 4, 4, 8}, {2, 0, 4, 4}, {0, 2, 2, 4}, {1, 0, 2, 2}, {0, 1, 1, 2}
    };

    private static final int[][] IN_ONE_GO = {{0, 0, 1, 1}};

    private final PngReader png;
    private final Iterator<ByteBuffer> data;

    /** Says how opaque pixels are, if that is asked for; null for their colours. */
    private final PngAlpha alpha;

    /** @param alpha for how opaque pixels are; null for their colours */
    PngPixels(PngReader png, List<ByteBuffer> data, PngAlpha alpha) {
        this.png = png;
        this.data = data.iterator();
        this.alpha = alpha;
    }

    Raster decode() throws IOException {
        Raster raster =
                png.depth == 16 ? Raster.ofShorts(png.width, png.height) : Raster.ofBytes(png.width, png.height);
        Inflater inflater = new Inflater();
        try {
            for (int[] pass : png.interlaced ? INTERLACED : IN_ONE_GO) {
                decodePass(pass[0], pass[1], pass[2], pass[3], inflater, raster);
            }
        } catch (DataFormatException e) {
            throw new IOException("it is damaged: " + e.getMessage(), e);
        } finally {
            inflater.end();
        }
        return raster;
    }

    private void decodePass(int firstX, int firstY, int stepX, int stepY, Inflater inflater, Raster raster)
            throws IOException, DataFormatException {
        int columns = (png.width - firstX + stepX - 1) / stepX;
        if (columns <= 0) {
            return;
        }
        long pixelBits = (long) png.channels() * png.depth;
        int pixelBytes = (int) Math.max(1, pixelBits / 8);
        int rowBytes = Math.toIntExact((pixelBits * columns + 7) / 8);
        PngFilter filter = new PngFilter(pixelBytes, rowBytes);
        byte[] row = new byte[pixelBytes + rowBytes];
        byte[] above = new byte[pixelBytes + rowBytes];
        byte[] type = new byte[1];
        for (int y = firstY; y < png.height; y += stepY) {
            inflate(inflater, type, 0);
            inflate(inflater, row, pixelBytes);
            if (type[0] < 0 || type[0] > 4) {
                throw new IOException("it is damaged: there is no filter " + type[0]);
            }
            filter.undo(type[0], row, above);
            if (alpha != null) {
                storeAlpha(row, pixelBytes, y * png.width + firstX, stepX, columns, raster);
            } else if (png.depth == 16) {
                storeDeep(row, 3 * (y * png.width + firstX), 3 * stepX, columns, raster.deep());
            } else {
                storePacked(row, pixelBytes, y * png.width + firstX, stepX, columns, raster.packed());
            }
            byte[] free = above;
            above = row;
            row = free;
        }
    }

    private void inflate(Inflater inflater, byte[] target, int from) throws IOException, DataFormatException {
        int done = from;
        while (done < target.length) {
            int count = inflater.inflate(target, done, target.length - done);
            done += count;
            if (count == 0) {
                if (inflater.finished() || inflater.needsDictionary() || !data.hasNext()) {
                    throw new IOException("some of its pixels are missing");
                }
                inflater.setInput(data.next());
            }
        }
    }

    private void storePacked(byte[] row, int from, int firstPixel, int step, int columns, int[] packed)
            throws IOException {
        int channels = png.channels();
        int pixel = firstPixel;
        if (channels >= 3) {
            for (int x = 0, i = from; x < columns; x++, i += channels, pixel += step) {
                packed[pixel] = (row[i] & 255) << 16 | (row[i + 1] & 255) << 8 | row[i + 2] & 255;
            }
        } else if (png.isPalette()) {
            for (int x = 0; x < columns; x++, pixel += step) {
                int index = sample(row, from, x);
                if (index >= png.palette.length) {
                    throw new IOException("it is damaged: there is no colour " + index + " in its palette");
                }
                packed[pixel] = png.palette[index];
            }
        } else {
            int unit = 255 / ((1 << png.depth) - 1); // exact: 255, 85, 17 and 1
            for (int x = 0; x < columns; x++, pixel += step) {
                packed[pixel] = 0x010101 * (unit * sample(row, from, x * channels));
            }
        }
    }

    private void storeAlpha(byte[] row, int from, int firstPixel, int step, int columns, Raster raster)
            throws IOException {
        for (int x = 0, pixel = firstPixel; x < columns; x++, pixel += step) {
            int opacity = alpha.of(row, from, x);
            if (raster.deep() == null) {
                raster.packed()[pixel] = 0x010101 * opacity;
            } else {
                Arrays.fill(raster.deep(), 3 * pixel, 3 * pixel + 3, (char) opacity);
            }
        }
    }

    /** Sample number n of a row whose samples have at most 8 bits each. */
    private int sample(byte[] row, int from, int n) {
        return sample(row, from, n, png.depth);
    }

    /** Sample number n of a row whose samples have of some bits each, at most 16. */
    static int sample(byte[] row, int from, int n, int depth) {
        if (depth == 16) {
            return sampleOf16(row, from + 2 * n);
        }
        long bit = (long) n * depth;
        int value = row[from + (int) (bit >>> 3)] & 255;
        return value >>> 8 - depth - (int) (bit & 7) & (1 << depth) - 1;
    }

    private void storeDeep(byte[] row, int first, int step, int columns, char[] deep) {
        int channels = png.channels();
        int green = png.isGrey() ? 0 : 2;
        int blue = png.isGrey() ? 0 : 4;
        int i = 2 * channels; // after the pixel of zeros
        for (int x = 0, target = first; x < columns; x++, i += 2 * channels, target += step) {
            deep[target] = sampleOf16(row, i);
            deep[target + 1] = sampleOf16(row, i + green);
            deep[target + 2] = sampleOf16(row, i + blue);
        }
    }

    private static char sampleOf16(byte[] row, int i) {
        return (char) ((row[i] & 255) << 8 | row[i + 1] & 255);
    }
}
