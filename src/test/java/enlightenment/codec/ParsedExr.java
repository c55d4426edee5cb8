package enlightenment.codec;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.zip.DataFormatException;
import java.util.zip.Inflater;

/** An OpenEXR file of one part of scan lines in ZIP, taken apart byte by byte after the published layout: shares no code with the program. */
public final class ParsedExr {
    /** Per attribute, in the order of the file: its type, and its bytes. */
    public final Map<String, String> types = new LinkedHashMap<>();

    public final Map<String, byte[]> attributes = new LinkedHashMap<>();

    /** Per channel, in the order of the file: 1 for halves, 2 for floats. */
    public final Map<String, Integer> kinds = new LinkedHashMap<>();

    /** Per channel: the bits of all numbers, row by row. */
    public final Map<String, int[]> bits = new LinkedHashMap<>();

    /** The numbers of the first rows of the chunks, as they come in the file. */
    public final List<Integer> firstRows = new ArrayList<>();

    /** How many chunks stand unpacked. */
    public int plainChunks;

    private final ByteBuffer file;

    public ParsedExr(byte[] bytes) throws DataFormatException {
        file = ByteBuffer.wrap(bytes).order(ByteOrder.LITTLE_ENDIAN);
        require(file.getInt() == 20000630 && file.getInt() == 2, "magic number and version 2 without flags");
        for (String name = text(); !name.isEmpty(); name = text()) {
            types.put(name, text());
            byte[] value = new byte[file.getInt()];
            file.get(value);
            attributes.put(name, value);
        }
        readChannels();
        readChunks();
    }

    private static void require(boolean condition, String what) {
        if (!condition) {
            throw new AssertionError("not " + what);
        }
    }

    private String text() {
        StringBuilder text = new StringBuilder();
        for (int c = file.get(); c != 0; c = file.get()) {
            text.append((char) c);
        }
        return text.toString();
    }

    /** An attribute of whole numbers. */
    public List<Integer> integers(String attribute) {
        ByteBuffer value = ByteBuffer.wrap(attributes.get(attribute)).order(ByteOrder.LITTLE_ENDIAN);
        List<Integer> integers = new ArrayList<>();
        while (value.hasRemaining()) {
            integers.add(value.getInt());
        }
        return integers;
    }

    public String string(String attribute) {
        return new String(attributes.get(attribute), StandardCharsets.UTF_8);
    }

    private void readChannels() {
        byte[] list = attributes.get("channels");
        int at = 0;
        while (list[at] != 0) {
            int end = at;
            while (list[end] != 0) {
                end++;
            }
            String name = new String(list, at, end - at, StandardCharsets.US_ASCII);
            ByteBuffer rest = ByteBuffer.wrap(list, end + 1, 16).order(ByteOrder.LITTLE_ENDIAN);
            kinds.put(name, rest.getInt());
            require(rest.getInt() == 0 && rest.getInt() == 1 && rest.getInt() == 1, "linear, a sample per pixel");
            at = end + 17;
        }
        require(at == list.length - 1, "the end of the list");
    }

    private void readChunks() throws DataFormatException {
        List<Integer> window = integers("dataWindow");
        int width = window.get(2) - window.get(0) + 1;
        int height = window.get(3) - window.get(1) + 1;
        kinds.forEach((name, kind) -> bits.put(name, new int[width * height]));
        int rowBytes = width * kinds.values().stream().mapToInt(k -> 2 * k).sum();
        int chunks = (height + 15) / 16;
        long[] table = new long[chunks];
        for (int i = 0; i < chunks; i++) {
            table[i] = file.getLong();
        }
        for (int i = 0; i < chunks; i++) {
            require(table[i] == file.position(), "a chunk where the table says, after the one before");
            int first = file.getInt() - window.get(1);
            firstRows.add(first);
            byte[] packed = new byte[file.getInt()];
            file.get(packed);
            int rows = Math.min(16, height - first);
            readRows(
                    ByteBuffer.wrap(plain(packed, rows * rowBytes)).order(ByteOrder.LITTLE_ENDIAN), first, rows, width);
        }
        require(!file.hasRemaining(), "the end of the file");
    }

    private byte[] plain(byte[] packed, int size) throws DataFormatException {
        if (packed.length == size) {
            plainChunks++;
            return packed;
        }
        require(packed.length < size, "shorter");
        Inflater inflater = new Inflater();
        inflater.setInput(packed);
        byte[] coded = new byte[size + 1];
        require(inflater.inflate(coded) == size && inflater.finished(), "a zlib stream of " + size + " bytes");
        inflater.end();
        byte[] plain = new byte[size];
        int sum = coded[0];
        for (int i = 0; i < size; i++) {
            sum = i == 0 ? coded[0] : sum + coded[i] - 128;
            // The first half of the bytes are those of even places.
            int place = i < (size + 1) / 2 ? 2 * i : 2 * (i - (size + 1) / 2) + 1;
            plain[place] = (byte) sum;
        }
        return plain;
    }

    private void readRows(ByteBuffer plain, int first, int rows, int width) {
        for (int y = first; y < first + rows; y++) {
            for (Map.Entry<String, Integer> kind : kinds.entrySet()) {
                for (int x = 0; x < width; x++) {
                    bits.get(kind.getKey())[y * width + x] =
                            kind.getValue() == 1 ? plain.getShort() & 0xffff : plain.getInt();
                }
            }
        }
    }

    /** The numbers of a channel of floats. */
    public float[] floats(String channel) {
        require(kinds.get(channel) == 2, "floats: " + channel);
        int[] all = bits.get(channel);
        float[] floats = new float[all.length];
        for (int i = 0; i < floats.length; i++) {
            floats[i] = Float.intBitsToFloat(all[i]);
        }
        return floats;
    }
}
