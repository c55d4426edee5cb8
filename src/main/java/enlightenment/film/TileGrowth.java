package enlightenment.film;

import java.nio.ByteBuffer;
import java.util.Optional;

/**
 * What the pixels of a tile need so that they can get more samples later, with the same bits as if all had been taken at once: the sums of
 * the samples that are there, in their order, and those of their first and of their second half, from which the sums of the quarters of
 * more samples follow, which tell the error ({@link SampleSpread}). For methods of which the samples of a pixel do not depend on how many
 * follow.
 */
public final class TileGrowth {
    /** What is kept of a pixel: sum and compensation of each component, then the sums of both halves, 8 bytes each. */
    public static final int BYTES = 12 * Double.BYTES;

    private static final int NUMBERS = 12;
    private static final int FIRST_HALF = 6;
    private static final int SECOND_HALF = 9;

    /** With fewer samples what tells the error of a pixel depends on its neighbours. */
    private static final int FEWEST = 3;

    private final int x;
    private final int y;
    private final int width;
    private final double[] numbers;
    private final int[] before;

    /** The pixel that is rendered. */
    private int at;

    /** For the pixels of a tile; none of them has samples. */
    public TileGrowth(FilmTile tile) {
        x = tile.x;
        y = tile.y;
        width = tile.width;
        numbers = new double[NUMBERS * tile.width * tile.height];
        before = new int[tile.width * tile.height];
    }

    /** Whether a pixel with {@code before} samples can grow to {@code samples}, or has that number. */
    public static boolean isPossible(int before, int samples) {
        if (before < 1 || before > samples || samples < FEWEST) {
            return false;
        }
        // All that is there must be within one quarter, or be two of them.
        return before == samples || isQuarter(before, samples) || isHalf(before, samples);
    }

    private static boolean isQuarter(int before, int samples) {
        return 4L * (before - 1) < samples;
    }

    private static boolean isHalf(int before, int samples) {
        return before % 2 == 0 && 2L * before == samples;
    }

    /** Why these numbers cannot be those of a pixel with that mean; empty if they can. */
    public static Optional<String> problem(ByteBuffer in, double[] means, int samples) {
        for (double mean : means) {
            double sum = in.getDouble() + in.getDouble();
            // In this order what is no number is refused.
            if (!(sum / samples == mean)) {
                return Optional.of("a sum of samples is " + sum + ", which is not " + samples + " times " + mean);
            }
        }
        for (int i = FIRST_HALF; i < NUMBERS; i++) {
            double sum = in.getDouble();
            if (!(Math.abs(sum) < Double.POSITIVE_INFINITY)) {
                return Optional.of("the sum of a half is " + sum);
            }
        }
        return Optional.empty();
    }

    /** Puts what is there of a pixel. */
    public void read(int column, int row, int count, ByteBuffer in) {
        int pixel = pixel(column, row);
        before[pixel] = count;
        for (int i = 0; i < NUMBERS; i++) {
            numbers[NUMBERS * pixel + i] = in.getDouble();
        }
    }

    /** Writes what is kept of a pixel that was rendered. */
    public void write(int column, int row, ByteBuffer out) {
        for (int i = 0; i < NUMBERS; i++) {
            out.putDouble(numbers[NUMBERS * pixel(column, row) + i]);
        }
    }

    /** The number of samples that a pixel had before. */
    public int before(int column, int row) {
        return before[pixel(column, row)];
    }

    /**
     * Begins a pixel.
     *
     * @param count the samples that it is to have
     * @param spread begun for these
     * @return how many of them are there, in the tile and in the spread; if all are, the spread stays empty
     */
    public int begin(FilmTile tile, int column, int row, int count, SampleSpread spread) {
        at = NUMBERS * pixel(column, row);
        int there = before[pixel(column, row)];
        if (there > 0) {
            tile.put(column, row, numbers, at, there);
        }
        if (there > 0 && there < count) {
            if (isHalf(there, count)) {
                spread.goOn(there / 2, numbers, at + FIRST_HALF);
                spread.goOn(there / 2, numbers, at + SECOND_HALF);
            } else {
                spread.goOn(there, new double[] {numbers[at], numbers[at + 2], numbers[at + 4]}, 0);
            }
        }
        return there;
    }

    /** Stores the sums of the first half of a pixel's samples, which is in the tile. */
    public void half(FilmTile tile, int column, int row) {
        for (int c = 0; c < 3; c++) {
            numbers[at + FIRST_HALF + c] = tile.sum(column, row, c);
            numbers[at + SECOND_HALF + c] = 0;
        }
    }

    /** Adds a sample of the second half. */
    public void add(double[] color) {
        numbers[at + SECOND_HALF] += color[0];
        numbers[at + SECOND_HALF + 1] += color[1];
        numbers[at + SECOND_HALF + 2] += color[2];
    }

    /** Ends a pixel. */
    public void end(FilmTile tile, int column, int row) {
        for (int c = 0; c < 3; c++) {
            numbers[at + 2 * c] = tile.sum(column, row, c);
            numbers[at + 2 * c + 1] = tile.compensation(column, row, c);
        }
    }

    private int pixel(int column, int row) {
        return (row - y) * width + column - x;
    }
}
