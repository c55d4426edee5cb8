package enlightenment.film;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;

/**
 * Camera samples as they were taken, for listeners that store them. They are gathered into blocks of bytes, column by column, each number
 * with its least significant byte first. One per thread.
 *
 * <p>A block of n samples has n pixels (4 bytes: row times width plus column, in the whole picture), n places within the pixel across and
 * down (4 each, 0..1), n times red, green, blue and the weight (4 each); of rays also n times nine coordinates (8 each) of P, S and L,
 * outcome and bounces (1 each).
 */
public final class SampleLog {
    /** The kinds of blocks: samples alone, or with their rays. */
    public static final int PIXELS = 0;

    public static final int RAYS = 1;

    /** The most samples of a block. */
    public static final int MOST = 1 << 16;

    /** Numbers of a ray: P, S and L. */
    public static final int COORDINATES = 9;

    private static final int FLOATS = 6;
    private static final int FIRST = 1 << 10;

    /** The outcomes of rays, stored as their ordinals. */
    public enum Outcome {
        /** The ray met nothing. */
        MISSED,
        /** The point on the light shines on the surface. */
        LIT,
        /** An object occludes the point on the light. */
        SHADOWED,
        /** The ray met a light: S is on it. */
        LIGHT_SEEN,
        /** No light was sampled, as none shines on that side of the surface. */
        UNLIT
    }

    private final int kind;
    private final int width;
    private final Sink sink;
    private int size;
    private int[] pixels = new int[FIRST];
    private float[] floats = new float[FIRST * FLOATS];
    private double[] coordinates;
    private byte[] outcomes;
    private byte[] bounces;

    /** Takes blocks. */
    @FunctionalInterface
    public interface Sink {
        /**
         * Receives a block.
         *
         * @param samples number of samples in the block
         */
        void block(int kind, int samples, byte[] bytes);
    }

    /**
     * A log without samples.
     *
     * @param hasRays whether rays are kept with the samples
     * @param width number of columns of the whole picture
     */
    public SampleLog(boolean hasRays, int width, Sink sink) {
        kind = hasRays ? RAYS : PIXELS;
        this.width = width;
        this.sink = sink;
        coordinates = new double[hasRays ? FIRST * COORDINATES : 0];
        outcomes = new byte[hasRays ? FIRST : 0];
        bounces = new byte[hasRays ? FIRST : 0];
    }

    /** Bytes of a sample in a block. */
    public static int bytesPerSample(int kind) {
        int sample = Integer.BYTES + FLOATS * Float.BYTES;
        return kind == RAYS ? sample + COORDINATES * Double.BYTES + 2 : sample;
    }

    /** Whether rays are kept with the samples. */
    public boolean hasRays() {
        return kind == RAYS;
    }

    /**
     * Adds a sample of weight 1.
     *
     * @param dx its place in the pixel, 0..1; dy likewise
     * @param color red, green and blue
     */
    public void add(int column, int row, double dx, double dy, double[] color) {
        if (size == MOST) {
            flush();
        } else if (size == pixels.length) {
            grow();
        }
        pixels[size] = row * width + column;
        int k = FLOATS * size++;
        floats[k] = within(dx);
        floats[k + 1] = within(dy);
        floats[k + 2] = (float) color[0];
        floats[k + 3] = (float) color[1];
        floats[k + 4] = (float) color[2];
        floats[k + 5] = 1;
    }

    /** Rounded, but not into the next pixel. */
    private static float within(double d) {
        return Math.min((float) d, Math.nextDown(1f));
    }

    /**
     * Sets the ray of the sample added last.
     *
     * @param points P, S and L; missing points are NaN
     */
    public void ray(double[] points, Outcome outcome, int bounceCount) {
        System.arraycopy(points, 0, coordinates, COORDINATES * (size - 1), COORDINATES);
        outcomes[size - 1] = (byte) outcome.ordinal();
        bounces[size - 1] = (byte) Math.min(bounceCount, Byte.MAX_VALUE);
    }

    private void grow() {
        int more = 2 * pixels.length;
        pixels = java.util.Arrays.copyOf(pixels, more);
        floats = java.util.Arrays.copyOf(floats, more * FLOATS);
        if (kind == RAYS) {
            coordinates = java.util.Arrays.copyOf(coordinates, more * COORDINATES);
            outcomes = java.util.Arrays.copyOf(outcomes, more);
            bounces = java.util.Arrays.copyOf(bounces, more);
        }
    }

    /** Passes the samples so far to the sink, also if there are none. */
    public void flush() {
        ByteBuffer out = ByteBuffer.allocate(size * bytesPerSample(kind)).order(ByteOrder.LITTLE_ENDIAN);
        for (int i = 0; i < size; i++) {
            out.putInt(pixels[i]);
        }
        for (int c = 0; c < FLOATS; c++) {
            for (int i = 0; i < size; i++) {
                out.putFloat(floats[FLOATS * i + c]);
            }
        }
        if (kind == RAYS) {
            for (int c = 0; c < COORDINATES; c++) {
                for (int i = 0; i < size; i++) {
                    out.putDouble(coordinates[COORDINATES * i + c]);
                }
            }
            out.put(outcomes, 0, size).put(bounces, 0, size);
        }
        int samples = size;
        size = 0;
        sink.block(kind, samples, out.array());
    }

    /** Forgets what was not given away. */
    public void clear() {
        size = 0;
    }
}
