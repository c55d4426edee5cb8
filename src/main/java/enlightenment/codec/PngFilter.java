package enlightenment.codec;

import java.util.Arrays;

/**
 * The five predictions that a PNG row can be sent relative to (PNG specification, 9). For each row the one is chosen whose
 * differences have the smallest sum of absolute values, the specification's own advice (12.7).
 */
final class PngFilter {
    private static final int TYPES = 5;
    private static final int SPAN = 1 << 9;

    private final int pixelBytes;
    private final int rowBytes;
    private final byte[][] candidates;
    private final int[] sums = new int[TYPES];

    /**
     * @param pixelBytes bytes per pixel, at least 1
     * @param rowBytes bytes per row
     */
    PngFilter(int pixelBytes, int rowBytes) {
        this.pixelBytes = pixelBytes;
        this.rowBytes = rowBytes;
        this.candidates = new byte[TYPES][rowBytes + 1];
        for (int type = 0; type < TYPES; type++) {
            candidates[type][0] = (byte) type;
        }
    }

    /**
     * The row as it is sent: the type, then the differences.
     *
     * @param row preceded by one pixel of zeros, as {@code above} is
     * @param above the row above; zeros for the first one
     * @return valid until the next call
     */
    byte[] apply(byte[] row, byte[] above) {
        Arrays.fill(sums, 0);
        for (int from = 0; from < rowBytes; from += SPAN) {
            predict(row, above, from, Math.min(rowBytes, from + SPAN));
        }
        int best = 0;
        for (int type = 1; type < TYPES; type++) {
            if (sums[type] < sums[best]) {
                best = type;
            }
        }
        return candidates[best];
    }

    /** All predictions in one loop, over a stretch short enough for the compiler to take notice after few calls. */
    private void predict(byte[] row, byte[] above, int from, int to) {
        byte[] none = candidates[0];
        byte[] sub = candidates[1];
        byte[] up = candidates[2];
        byte[] average = candidates[3];
        byte[] paeth = candidates[4];
        int noneSum = 0;
        int subSum = 0;
        int upSum = 0;
        int averageSum = 0;
        int paethSum = 0;
        for (int i = from; i < to; i++) {
            byte value = row[i + pixelBytes];
            int a = row[i] & 255;
            int b = above[i + pixelBytes] & 255;
            noneSum += Math.abs(none[i + 1] = value);
            subSum += Math.abs(sub[i + 1] = (byte) (value - a));
            upSum += Math.abs(up[i + 1] = (byte) (value - b));
            averageSum += Math.abs(average[i + 1] = (byte) (value - (a + b >>> 1)));
            paethSum += Math.abs(paeth[i + 1] = (byte) (value - paeth(a, b, above[i] & 255)));
        }
        sums[0] += noneSum;
        sums[1] += subSum;
        sums[2] += upSum;
        sums[3] += averageSum;
        sums[4] += paethSum;
    }

    /**
     * Undoes a filter in place.
     *
     * @param type as sent, 0..4
     * @param row the differences, preceded by one pixel of zeros, as {@code above} is
     */
    void undo(int type, byte[] row, byte[] above) {
        // One method each: what a file does not use need not be compiled, in a program that has just started.
        if (type == 1) {
            undoSub(row);
        } else if (type == 2) {
            undoUp(row, above);
        } else if (type == 3) {
            undoAverage(row, above);
        } else if (type == 4) {
            undoPaeth(row, above);
        }
    }

    private void undoSub(byte[] row) {
        for (int i = 0; i < rowBytes; i++) {
            row[i + pixelBytes] += row[i];
        }
    }

    private void undoUp(byte[] row, byte[] above) {
        for (int i = pixelBytes; i < row.length; i++) {
            row[i] += above[i];
        }
    }

    private void undoAverage(byte[] row, byte[] above) {
        for (int i = 0; i < rowBytes; i++) {
            row[i + pixelBytes] += (byte) ((row[i] & 255) + (above[i + pixelBytes] & 255) >>> 1);
        }
    }

    private void undoPaeth(byte[] row, byte[] above) {
        for (int i = 0; i < rowBytes; i++) {
            row[i + pixelBytes] += (byte) paeth(row[i] & 255, above[i + pixelBytes] & 255, above[i] & 255);
        }
    }

    /** Of three neighbours the one that is closest to left + up - upLeft (A. W. Paeth, 1991). */
    private static int paeth(int left, int up, int upLeft) {
        int toLeft = Math.abs(up - upLeft);
        int toUp = Math.abs(left - upLeft);
        int toUpLeft = Math.abs(left + up - 2 * upLeft);
        if (toLeft <= toUp && toLeft <= toUpLeft) {
            return left;
        }
        return toUp <= toUpLeft ? up : upLeft;
    }
}
