package enlightenment.film;

import java.util.Arrays;
import java.util.Optional;

/**
 * The contribution of a batch of paths to a picture. It has the sums of the pixels that it reached, and the number of its paths. Immutable.
 */
public final class SplatSums {
    /** Indices of pixels in the rectangle that is rendered, row by row, ascending. */
    final int[] pixels;

    /** Units of red, green and blue ({@link SplatScale}) of each of these, not all 0. */
    final long[] sums;

    final long paths;

    SplatSums(int[] pixels, long[] sums, long paths) {
        this.pixels = pixels;
        this.sums = sums;
        this.paths = paths;
    }

    /** The number of paths, of those too that reached no pixel. */
    public long paths() {
        return paths;
    }

    /** The number of pixels that were reached. */
    public int size() {
        return pixels.length;
    }

    /** Whether the sum of two numbers is too large for a {@code long}. */
    static boolean overflows(long a, long b) {
        long sum = a + b;
        return ((a ^ sum) & (b ^ sum)) < 0;
    }

    /** The largest magnitude of all sums, {@link Long#MAX_VALUE} for that of the least number too; 0 if no pixel was reached. */
    public long largest() {
        long largest = 0;
        for (long sum : sums) {
            // Math.abs of the least number is negative.
            largest = Math.max(largest, sum == Long.MIN_VALUE ? Long.MAX_VALUE : Math.abs(sum));
        }
        return largest;
    }

    /**
     * As bytes: numbers of 7 bits each, the lowest first, the highest bit set where more follow (as LEB128). First the number of paths
     * and of pixels; then for each pixel how far it is from the one before, or from −1, and its sums of red, green and blue: each times
     * two, and of a negative one the magnitude of that less one.
     */
    public byte[] toBytes() {
        VarintWriter out = new VarintWriter(16 + 16 * pixels.length);
        out.put(paths);
        out.put(pixels.length);
        int before = -1;
        for (int i = 0; i < pixels.length; i++) {
            out.put(pixels[i] - before);
            before = pixels[i];
            for (int c = 0; c < 3; c++) {
                long sum = sums[3 * i + c];
                out.put(sum << 1 ^ sum >> Long.SIZE - 1);
            }
        }
        return out.bytes();
    }

    /**
     * Why these bytes cannot be what a batch of paths adds; empty if they can.
     *
     * @param paths how many the batch has
     * @param pixels how many the rectangle has that is rendered
     */
    public static Optional<String> problem(byte[] bytes, long paths, int pixels) {
        try {
            SplatSums sums = of(bytes, pixels);
            return sums.paths == paths
                    ? Optional.empty()
                    : Optional.of("it has " + sums.paths + " paths instead of " + paths);
        } catch (IllegalArgumentException e) {
            return Optional.of(e.getMessage());
        }
    }

    /**
     * The sums in the bytes of {@link #toBytes}.
     *
     * @param pixels the number of pixels of the rendered rectangle
     * @throws IllegalArgumentException with the reason, if the bytes are not valid
     */
    public static SplatSums of(byte[] bytes, int pixels) {
        VarintReader in = new VarintReader(bytes);
        long paths = in.next();
        long size = in.next();
        // Nothing is set aside for pixels that cannot be there: each takes 4 bytes at least.
        if (size > pixels || size > in.left() / 4) {
            throw new IllegalArgumentException(size + " pixels in " + in.left() + " bytes");
        }
        int[] indices = new int[(int) size];
        long[] sums = new long[3 * (int) size];
        long index = -1;
        for (int i = 0; i < size; i++) {
            long step = in.next();
            if (step < 1 || step >= pixels - index) {
                throw new IllegalArgumentException("a pixel lies " + step + " after pixel " + index);
            }
            index += step;
            indices[i] = (int) index;
            long all = 0;
            for (int c = 0; c < 3; c++) {
                long next = in.any();
                sums[3 * i + c] = next >>> 1 ^ -(next & 1);
                all |= sums[3 * i + c];
            }
            if (all == 0) {
                throw new IllegalArgumentException("pixel " + index + " was not reached");
            }
        }
        if (in.left() > 0) {
            throw new IllegalArgumentException(in.left() + " bytes too many");
        }
        return new SplatSums(indices, sums, paths);
    }

    /** Writes numbers without sign. */
    private static final class VarintWriter {
        private byte[] bytes;
        private int length;

        VarintWriter(int capacity) {
            bytes = new byte[capacity];
        }

        void put(long v) {
            if (length + 10 > bytes.length) {
                bytes = Arrays.copyOf(bytes, bytes.length + bytes.length / 2 + 10);
            }
            long rest = v;
            while (rest >>> 7 != 0) {
                bytes[length++] = (byte) (rest | 0x80);
                rest >>>= 7;
            }
            bytes[length++] = (byte) rest;
        }

        byte[] bytes() {
            return Arrays.copyOf(bytes, length);
        }
    }

    private static final class VarintReader {
        private final byte[] bytes;
        private int at;

        VarintReader(byte[] bytes) {
            this.bytes = bytes;
        }

        int left() {
            return bytes.length - at;
        }

        /** The next number, below 2^63. */
        long next() {
            long v = any();
            if (v < 0) {
                throw new IllegalArgumentException("a number is too large");
            }
            return v;
        }

        /** The next number, below 2^64, in as few bytes as it can have: so there is one form of everything. */
        long any() {
            long v = 0;
            for (int shift = 0; shift < Long.SIZE; shift += 7) {
                if (at == bytes.length) {
                    throw new IllegalArgumentException("it ends in the middle");
                }
                int b = bytes[at++];
                v |= (long) (b & 0x7f) << shift;
                if (b >= 0) {
                    if (b == 0 && shift > 0) {
                        throw new IllegalArgumentException("a number with leading zeros");
                    }
                    if (shift == Long.SIZE - 1 && b > 1) {
                        break;
                    }
                    return v;
                }
            }
            throw new IllegalArgumentException("a number is too large");
        }
    }
}
