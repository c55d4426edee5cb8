package enlightenment.film;

import enlightenment.color.DisplayCurve;
import enlightenment.file.ScratchFile;
import java.nio.ByteBuffer;
import java.nio.LongBuffer;
import java.nio.file.Path;
import java.util.Arrays;

/**
 * Splats whose sums do not fit in memory. What a batch brings to a band of rows is written behind what came there before; when that
 * is half as long as the sums of all pixels of the band, or they are read, it is added up: an external sort by bands (D. E. Knuth,
 * "The Art of Computer Programming", volume 3, section 5.4), which writes and reads in large pieces whatever pixels are reached.
 */
public final class SplatFilmInFile extends Splats {
    private static final int BAND_ROWS = 8;

    /** Bytes of a waiting contribution: pixel and group in one number, and units of red, green and blue. */
    private static final int ENTRY_BYTES = Integer.BYTES + 3 * Long.BYTES;

    /** Bytes of a pixel's sums. */
    private static final int SUM_BYTES = GROUPS * 3 * Long.BYTES;

    /** Waiting contributions take at most one part in this many of the sums' size. */
    private static final int WAITING_SHARE = 2;

    /** Memory for what is not written yet, if there are not very many bands. */
    private static final int BUFFERS = 1 << 24;

    private static final int LEAST_ENTRIES = 128;
    private static final int MOST_ENTRIES = 2048;

    private final ScratchFile waiting;
    private final ScratchFile added;
    private final Band[] bands;
    private final int chunkBytes;

    /** Pieces of the file of contributions: those beyond the last were never used, the free ones are used again. */
    private int chunks;

    private int[] free = new int[16];
    private int freeChunks;

    /** Some rows of the picture. */
    private static final class Band {
        private byte[] buffer;
        private int filled;
        private int[] full = new int[4];
        private int fullChunks;
        private boolean hasSums;
    }

    /**
     * A black film for a rectangle of the whole picture.
     *
     * @param picturePixels number of pixels of the whole picture
     * @param curve what pixels are, and how they become what a screen takes
     * @param folder where its files are, as long as the film is in use
     */
    public SplatFilmInFile(
            int x,
            int y,
            int width,
            int height,
            long picturePixels,
            SplatScale scale,
            DisplayCurve curve,
            Path folder) {
        super(x, y, width, height, picturePixels, scale, curve);
        bands = new Band[bands(height)];
        chunkBytes = ENTRY_BYTES * entries(bands.length);
        for (int i = 0; i < bands.length; i++) {
            bands[i] = new Band();
        }
        waiting = ScratchFile.in(folder);
        added = ScratchFile.in(folder);
    }

    private static int bands(int rows) {
        return (rows + BAND_ROWS - 1) / BAND_ROWS;
    }

    private static int entries(int bands) {
        return Math.max(LEAST_ENTRIES, Math.min(MOST_ENTRIES, BUFFERS / bands / ENTRY_BYTES));
    }

    /** Bytes of memory that a film of this size takes. */
    public static long memory(int columns, int rows) {
        // The sums of a band, as numbers and as bytes, and what is not written yet.
        return 2L * SUM_BYTES * BAND_ROWS * columns + (long) ENTRY_BYTES * entries(bands(rows)) * bands(rows);
    }

    /** Bytes per pixel of both files together, at most. */
    public static int bytesPerPixel() {
        return SUM_BYTES + SUM_BYTES / WAITING_SHARE;
    }

    @Override
    void put(int group, SplatSums batch) {
        write(group, batch, 1);
    }

    @Override
    void take(int group, SplatSums batch) {
        write(group, batch, -1);
    }

    private void write(int group, SplatSums batch, int sign) {
        int bandPixels = BAND_ROWS * width;
        for (int i = 0; i < batch.pixels.length; i++) {
            int number = batch.pixels[i] / bandPixels;
            Band band = bands[number];
            if (band.buffer == null) {
                band.buffer = new byte[chunkBytes];
            }
            ByteBuffer.wrap(band.buffer, band.filled, ENTRY_BYTES)
                    .putInt((batch.pixels[i] - number * bandPixels) * GROUPS + group)
                    .putLong(sign * batch.sums[3 * i])
                    .putLong(sign * batch.sums[3 * i + 1])
                    .putLong(sign * batch.sums[3 * i + 2]);
            band.filled += ENTRY_BYTES;
            if (band.filled == chunkBytes) {
                flush(number);
            }
        }
    }

    private void flush(int number) {
        Band band = bands[number];
        int chunk = freeChunks > 0 ? free[--freeChunks] : chunks++;
        waiting.write((long) chunk * chunkBytes, band.buffer, 0, chunkBytes);
        if (band.fullChunks == band.full.length) {
            band.full = Arrays.copyOf(band.full, 2 * band.full.length);
        }
        band.full[band.fullChunks++] = chunk;
        band.filled = 0;
        if ((long) band.fullChunks * chunkBytes * WAITING_SHARE > sumBytes(number)) {
            addUp(number);
        }
    }

    private int rows(int number) {
        return Math.min(BAND_ROWS, height - number * BAND_ROWS);
    }

    private int sumBytes(int number) {
        return Math.multiplyExact(SUM_BYTES, rows(number) * width);
    }

    /** Adds what waits for a band to its sums, in the file. */
    private void addUp(int number) {
        long[] sums = sums(number);
        byte[] bytes = new byte[sumBytes(number)];
        ByteBuffer.wrap(bytes).asLongBuffer().put(sums);
        added.write(position(number), bytes, 0, bytes.length);
        Band band = bands[number];
        band.hasSums = true;
        if (freeChunks + band.fullChunks > free.length) {
            free = Arrays.copyOf(free, 2 * (freeChunks + band.fullChunks));
        }
        System.arraycopy(band.full, 0, free, freeChunks, band.fullChunks);
        freeChunks += band.fullChunks;
        band.fullChunks = 0;
        band.filled = 0;
    }

    private long position(int number) {
        return (long) SUM_BYTES * BAND_ROWS * width * number;
    }

    /** The sums of a band, with what waits: for each pixel those of the groups, of each red, green and blue. */
    private long[] sums(int number) {
        Band band = bands[number];
        long[] sums = new long[sumBytes(number) / Long.BYTES];
        if (band.hasSums) {
            byte[] bytes = new byte[sumBytes(number)];
            added.read(position(number), bytes, bytes.length);
            LongBuffer.wrap(sums).put(ByteBuffer.wrap(bytes).asLongBuffer());
        }
        byte[] chunk = new byte[chunkBytes];
        for (int i = 0; i < band.fullChunks; i++) {
            waiting.read((long) band.full[i] * chunkBytes, chunk, chunkBytes);
            add(number, chunk, chunkBytes, sums);
        }
        if (band.filled > 0) {
            add(number, band.buffer, band.filled, sums);
        }
        return sums;
    }

    private void add(int number, byte[] bytes, int length, long[] sums) {
        for (ByteBuffer in = ByteBuffer.wrap(bytes, 0, length); in.hasRemaining(); ) {
            int place = in.getInt();
            for (int k = 3 * place; k < 3 * place + 3; k++) {
                long units = in.getLong();
                if (SplatSums.overflows(sums[k], units)) {
                    int pixel = place / GROUPS;
                    throw SplatScale.tooBright(x + pixel % width, y + number * BAND_ROWS + pixel / width);
                }
                sums[k] += units;
            }
        }
    }

    @Override
    SplatView view() {
        return new SplatView() {
            private int band = -1;
            private long[] sums;

            @Override
            public long sum(int column, int row, int c, int group) {
                int number = (row - y) / BAND_ROWS;
                if (number != band) {
                    sums = null;
                    sums = sums(number);
                    band = number;
                }
                int pixel = (row - y - number * BAND_ROWS) * width + column - x;
                return sums[3 * (GROUPS * pixel + group) + c];
            }
        };
    }

    @Override
    public synchronized void release() {
        waiting.close();
        added.close();
    }
}
