package enlightenment.mesh.input;

import java.io.EOFException;
import java.io.IOException;
import java.io.InputStream;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.util.function.Supplier;
import java.util.zip.ZipException;

/** Reads binary numbers in pieces of 64 KiB. */
public final class BinaryInput {
    private static final int PIECE = 1 << 16;

    private final MeshSource source;
    private final InputStream in;
    private final Supplier<String> place;
    private final byte[] bytes = new byte[PIECE];
    private final ByteBuffer numbers;
    private int at;
    private int end;

    /** The bytes that the stream can still have, without those in the buffer. */
    private long beyond;

    /**
     * Reads a stream, which stays its owner's.
     *
     * @param size the bytes that the stream has, or can have at most
     * @param place for messages: which element is read
     */
    public BinaryInput(MeshSource source, InputStream in, long size, ByteOrder order, Supplier<String> place) {
        this.source = source;
        this.in = in;
        this.place = place;
        beyond = size;
        numbers = ByteBuffer.wrap(bytes).order(order);
    }

    /** The bytes that can still come, at most. */
    public long left() {
        return beyond + end - at;
    }

    public IOException failure(String what) {
        return source.failure(place.get() + " " + what);
    }

    private void need(int n) throws IOException {
        if (end - at < n) {
            fill(n);
        }
    }

    private void fill(int n) throws IOException {
        System.arraycopy(bytes, at, bytes, 0, end - at);
        end -= at;
        at = 0;
        while (end < n) {
            int read = piece();
            if (read < 0) {
                throw failure("is incomplete: the data end there");
            }
            end += read;
            beyond -= read;
        }
    }

    private int piece() throws IOException {
        try {
            return in.read(bytes, end, PIECE - end);
        } catch (ZipException e) {
            throw failure("is broken: its compressed data cannot be inflated");
        } catch (EOFException e) {
            return -1;
        }
    }

    public int uint8() throws IOException {
        need(1);
        return bytes[at++] & 0xff;
    }

    public int int16() throws IOException {
        need(Short.BYTES);
        at += Short.BYTES;
        return numbers.getShort(at - Short.BYTES);
    }

    public int int32() throws IOException {
        need(Integer.BYTES);
        at += Integer.BYTES;
        return numbers.getInt(at - Integer.BYTES);
    }

    public long int64() throws IOException {
        need(Long.BYTES);
        at += Long.BYTES;
        return numbers.getLong(at - Long.BYTES);
    }

    public float float32() throws IOException {
        need(Float.BYTES);
        at += Float.BYTES;
        return numbers.getFloat(at - Float.BYTES);
    }

    public double float64() throws IOException {
        need(Double.BYTES);
        at += Double.BYTES;
        return numbers.getDouble(at - Double.BYTES);
    }

    /** Passes over bytes. */
    public void skip(long n) throws IOException {
        for (long rest = n; rest > 0; ) {
            need(1);
            int here = (int) Math.min(rest, end - at);
            at += here;
            rest -= here;
        }
    }
}
