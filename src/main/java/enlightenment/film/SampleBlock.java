package enlightenment.film;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.util.Optional;

/** A block of a {@link SampleLog}, read again. */
public final class SampleBlock {
    private final ByteBuffer bytes;
    private final int size;
    private final int kind;

    private SampleBlock(int kind, int size, byte[] bytes) {
        this.kind = kind;
        this.size = size;
        this.bytes = ByteBuffer.wrap(bytes).order(ByteOrder.LITTLE_ENDIAN);
    }

    /** Why there can be no block of this kind with these numbers of samples and bytes; empty if there can. */
    public static Optional<String> problem(int kind, int samples, long bytes) {
        if (kind != SampleLog.PIXELS && kind != SampleLog.RAYS) {
            return Optional.of("there are no blocks of kind " + kind);
        }
        if (samples < 0 || samples > SampleLog.MOST) {
            return Optional.of("a block has at most " + SampleLog.MOST + " samples, not " + samples);
        }
        long expected = (long) samples * SampleLog.bytesPerSample(kind);
        return bytes == expected
                ? Optional.empty()
                : Optional.of(samples + " samples have " + expected + " bytes, not " + bytes);
    }

    /**
     * The block that these bytes are.
     *
     * @throws IllegalArgumentException if {@link #problem} has something to say
     */
    public static SampleBlock of(int kind, int samples, byte[] bytes) {
        problem(kind, samples, bytes.length).ifPresent(reason -> {
            throw new IllegalArgumentException(reason);
        });
        return new SampleBlock(kind, samples, bytes);
    }

    /** Number of samples. */
    public int size() {
        return size;
    }

    /** Whether samples have rays. */
    public boolean hasRays() {
        return kind == SampleLog.RAYS;
    }

    /** The pixel of a sample: row times width of the picture plus column. */
    public int pixel(int i) {
        return bytes.getInt(Integer.BYTES * i);
    }

    /** Numbers 0..5 of a sample: place in the pixel across and down, red, green, blue, weight. */
    public float number(int i, int which) {
        return bytes.getFloat(Integer.BYTES * size * (1 + which) + Float.BYTES * i);
    }

    private int afterNumbers() {
        return size * SampleLog.bytesPerSample(SampleLog.PIXELS);
    }

    /** Coordinates 0..8 of a sample's ray: P, S and L. */
    public double coordinate(int i, int which) {
        return bytes.getDouble(afterNumbers() + Double.BYTES * (size * which + i));
    }

    /** The outcome of a sample's ray; empty for a number that is none. */
    public Optional<SampleLog.Outcome> outcome(int i) {
        int number = bytes.get(afterNumbers() + Double.BYTES * SampleLog.COORDINATES * size + i);
        SampleLog.Outcome[] all = SampleLog.Outcome.values();
        return number >= 0 && number < all.length ? Optional.of(all[number]) : Optional.empty();
    }

    /** The number of mirrors and glass interfaces that a sample's ray met before S. */
    public int bounces(int i) {
        return bytes.get(afterNumbers() + (Double.BYTES * SampleLog.COORDINATES + 1) * size + i);
    }
}
