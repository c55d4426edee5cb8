package enlightenment.codec;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.stream.IntStream;

/**
 * Writes OpenEXR files ("OpenEXR File Layout", Academy Software Foundation): one part of scan lines, ZIP by {@link ZlibEncoder}, so that
 * the bytes depend on the numbers alone. Takes rows in their order from the top; what it keeps of them is packed, because the table of
 * the chunks' places comes before the chunks. For a picture whose packed rows do not fit in memory it takes all rows twice: first it only
 * {@linkplain #measure measures} the chunks, then it writes each as soon as it is packed.
 */
public final class ExrWriter {
    /** The number of rows that are packed together. */
    private static final int CHUNK_ROWS = ExrCompression.ZIP.rows;

    private static final int CHUNK_HEAD = 8;

    private final OutputStream out;
    private final ExrWindow window;
    private final List<ExrChannel> channels;

    /** Indices of channels by name, which is their order in a row. */
    private final int[] order;

    private final byte[] header;

    /** Those that are kept until the end. */
    private final List<byte[]> chunks = new ArrayList<>();

    /** The lengths of all chunks so far. */
    private final int[] lengths;

    private int packedChunks;
    private boolean isMeasuring;
    private boolean isMeasured;
    private final ByteBuffer plain;
    private final byte[] predicted;
    private int rows;

    /**
     * Begins a picture.
     *
     * @param out receives the file at the end; stays open
     * @param channels all of different names
     * @param texts what the file says of itself, by name
     * @throws IllegalArgumentException if two channels have one name, or a text has the name of what every file has
     */
    public ExrWriter(OutputStream out, ExrWindow window, List<ExrChannel> channels, Map<String, String> texts)
            throws IOException {
        this.out = out;
        this.window = window;
        this.channels = List.copyOf(channels);
        Set<String> names = new HashSet<>();
        int pixelBytes = 0;
        for (ExrChannel channel : channels) {
            if (!names.add(channel.name())) {
                throw new IllegalArgumentException("two channels are called " + channel.name());
            }
            pixelBytes += channel.type().bytes;
        }
        order = IntStream.range(0, channels.size())
                .boxed()
                .sorted(Comparator.comparing(i -> channels.get(i).name()))
                .mapToInt(Integer::intValue)
                .toArray();
        header = ExrAttributes.header(
                window, IntStream.of(order).mapToObj(channels::get).toList(), texts);
        int chunkRows = Math.min(CHUNK_ROWS, window.height());
        int size = Math.multiplyExact(Math.multiplyExact(pixelBytes, window.width()), chunkRows);
        plain = ByteBuffer.allocate(size).order(ByteOrder.LITTLE_ENDIAN);
        predicted = new byte[size];
        lengths = new int[(window.height() + CHUNK_ROWS - 1) / CHUNK_ROWS];
    }

    /**
     * Says before the first row that all rows come twice, in the same order; what is written is the same.
     *
     * @throws IllegalStateException if there are rows
     */
    public void measure() {
        if (rows > 0) {
            throw new IllegalStateException("there are " + rows + " rows");
        }
        isMeasuring = true;
    }

    /**
     * Adds the next row. Numbers that are none (NaN) become 0; finite ones beyond the range of halves become the largest half.
     *
     * @param numbers of each channel, in the order of the constructor, those of the row from the left
     * @throws IllegalStateException if all rows are there
     */
    public void add(float[][] numbers) throws IOException {
        if (rows == window.height()) {
            throw new IllegalStateException("all " + rows + " rows are there");
        }
        for (int c : order) {
            float[] row = numbers[c];
            boolean isHalf = channels.get(c).isHalf();
            for (int x = 0; x < window.width(); x++) {
                float value = Float.isNaN(row[x]) ? 0 : row[x];
                if (isHalf) {
                    plain.putShort(Half.of(value));
                } else {
                    plain.putFloat(value);
                }
            }
        }
        rows++;
        if (rows % CHUNK_ROWS == 0 || rows == window.height()) {
            pack();
        }
        if (isMeasuring && rows == window.height()) {
            isMeasuring = false;
            isMeasured = true;
            rows = 0;
            packedChunks = 0;
            writeHead();
        }
    }

    /** Packs the rows that are there as one chunk: as they are if that is no longer. */
    private void pack() throws IOException {
        int size = plain.position();
        ExrPrediction.apply(plain.array(), size, predicted);
        ByteArrayOutputStream packed = new ByteArrayOutputStream();
        ZlibEncoder encoder = new ZlibEncoder(packed, size);
        encoder.write(predicted, 0, size);
        encoder.finish();
        boolean isShorter = packed.size() < size;
        int length = isShorter ? packed.size() : size;
        ByteBuffer chunk = ByteBuffer.allocate(CHUNK_HEAD + length).order(ByteOrder.LITTLE_ENDIAN);
        chunk.putInt(window.y() + packedChunks * CHUNK_ROWS).putInt(length);
        chunk.put(isShorter ? packed.toByteArray() : plain.array(), 0, length);
        lengths[packedChunks++] = chunk.capacity();
        if (isMeasured) {
            out.write(chunk.array());
        } else if (!isMeasuring) {
            chunks.add(chunk.array());
        }
        plain.clear();
    }

    /**
     * Writes the file, or what is left of it.
     *
     * @throws IllegalStateException unless all rows are there
     */
    public void finish() throws IOException {
        if (rows < window.height()) {
            throw new IllegalStateException("only " + rows + " of " + window.height() + " rows are there");
        }
        if (!isMeasured) {
            writeHead();
        }
        for (byte[] chunk : chunks) {
            out.write(chunk);
        }
    }

    /** Writes what comes before the chunks. */
    private void writeHead() throws IOException {
        out.write(header);
        ByteBuffer table = ByteBuffer.allocate(8 * lengths.length).order(ByteOrder.LITTLE_ENDIAN);
        long at = header.length + (long) table.capacity();
        for (int length : lengths) {
            table.putLong(at);
            at += length;
        }
        out.write(table.array());
    }
}
