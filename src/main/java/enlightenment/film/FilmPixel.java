package enlightenment.film;

import java.nio.ByteBuffer;
import java.util.Arrays;

/** A finished pixel on its way into a film. */
public final class FilmPixel {
    private static final int BYTES = 3 * Double.BYTES + 2 * Float.BYTES + Integer.BYTES;

    /** The means of red, green and blue. */
    public final double[] means = new double[3];

    /** Of linear light: the means of the quarters of the samples, as {@link FilmTile#quarterMeans} writes them. */
    public final double[] ofQuarters = new double[QuarterMeans.PER_PIXEL];

    /** {@link FilmTile#halves}; of linear light only where there are one or two samples. */
    public float halves;

    /** {@link FilmTile#quarters}, likewise. */
    public float quarters;

    /** The number of samples; 0 for a pixel that is not finished. */
    public int samples;

    /** A pixel that is not finished. */
    public FilmPixel() {}

    /** Sets this to a pixel without samples. */
    void clear() {
        Arrays.fill(means, 0);
        Arrays.fill(ofQuarters, 0);
        halves = 0;
        quarters = 0;
        samples = 0;
    }

    /** Sets this to a pixel of a tile, by its place in the whole picture. */
    void take(FilmTile tile, int column, int row) {
        for (int c = 0; c < 3; c++) {
            means[c] = tile.mean(column, row, c);
        }
        samples = tile.count(column, row);
        if (tile.isLinear()) {
            tile.quarterMeans(column, row, ofQuarters);
        }
        // Of more samples of linear light the figures follow from the quarters, in the end.
        boolean hasFigures = !tile.isLinear() || samples <= 2;
        halves = hasFigures ? tile.halves(column, row) : 0;
        quarters = hasFigures ? tile.quarters(column, row) : 0;
    }

    /** Copies another pixel. */
    void set(FilmPixel other) {
        System.arraycopy(other.means, 0, means, 0, means.length);
        System.arraycopy(other.ofQuarters, 0, ofQuarters, 0, ofQuarters.length);
        halves = other.halves;
        quarters = other.quarters;
        samples = other.samples;
    }

    /** The number of bytes that {@link #write} writes. */
    static int bytes(boolean isLinear) {
        return isLinear ? BYTES + QuarterMeans.PER_PIXEL * Float.BYTES : BYTES;
    }

    /** Writes all that a film keeps of the pixel; {@link FilmBand} reads it. */
    void write(ByteBuffer out, boolean isLinear) {
        out.putDouble(means[0]).putDouble(means[1]).putDouble(means[2]);
        out.putFloat(halves).putFloat(quarters).putInt(samples);
        if (isLinear) {
            for (double mean : ofQuarters) {
                out.putFloat((float) mean);
            }
        }
    }
}
