package enlightenment.codec;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;

/** The head of an OpenEXR file that is written: magic number, version, and attributes in the order of their names. */
final class ExrAttributes {
    /** Of the layout; no flags: one part of scan lines, and no name has more than 31 characters. */
    private static final int VERSION = 2;

    private record Value(String type, byte[] bytes) {}

    private final Map<String, Value> attributes = new TreeMap<>();

    private ExrAttributes() {}

    /**
     * All bytes before the table of chunks.
     *
     * @param channels in the order of their names
     * @throws IllegalArgumentException if a text's name is none, or that of another attribute
     */
    static byte[] header(ExrWindow window, List<ExrChannel> channels, Map<String, String> texts) throws IOException {
        ExrAttributes a = new ExrAttributes();
        a.put("channels", "chlist", list(channels));
        a.put("compression", "compression", new byte[] {(byte) ExrCompression.ZIP.ordinal()});
        a.put("dataWindow", "box2i", box(window.x(), window.y(), window.width(), window.height()));
        a.put("displayWindow", "box2i", box(0, 0, window.wholeWidth(), window.wholeHeight()));
        a.put("lineOrder", "lineOrder", new byte[] {0}); // from the top
        a.put("pixelAspectRatio", "float", floats(1));
        a.put("screenWindowCenter", "v2f", floats(0, 0));
        a.put("screenWindowWidth", "float", floats(1));
        for (Map.Entry<String, String> text : texts.entrySet()) {
            if (!ExrChannel.isName(text.getKey())) {
                throw new IllegalArgumentException("\"" + text.getKey() + "\" is no name of an attribute");
            }
            a.put(text.getKey(), "string", text.getValue().getBytes(StandardCharsets.UTF_8));
        }
        return a.bytes();
    }

    private void put(String name, String type, byte[] bytes) {
        if (attributes.put(name, new Value(type, bytes)) != null) {
            throw new IllegalArgumentException("there are two attributes " + name);
        }
    }

    private static ByteBuffer buffer(int size) {
        return ByteBuffer.allocate(size).order(ByteOrder.LITTLE_ENDIAN);
    }

    private static byte[] box(int x, int y, int width, int height) {
        return buffer(16)
                .putInt(x)
                .putInt(y)
                .putInt(x + width - 1)
                .putInt(y + height - 1)
                .array();
    }

    private static byte[] floats(float... values) {
        ByteBuffer bytes = buffer(4 * values.length);
        for (float value : values) {
            bytes.putFloat(value);
        }
        return bytes.array();
    }

    private static byte[] list(List<ExrChannel> channels) throws IOException {
        ByteArrayOutputStream list = new ByteArrayOutputStream();
        for (ExrChannel channel : channels) {
            putText(list, channel.name());
            // The kind; no hint that numbers are logarithmic; a sample for every column and row.
            list.write(buffer(16)
                    .putInt(channel.type().ordinal())
                    .putInt(0)
                    .putInt(1)
                    .putInt(1)
                    .array());
        }
        list.write(0);
        return list.toByteArray();
    }

    private static void putText(ByteArrayOutputStream out, String text) throws IOException {
        out.write(text.getBytes(StandardCharsets.US_ASCII));
        out.write(0);
    }

    private byte[] bytes() throws IOException {
        ByteArrayOutputStream out = new ByteArrayOutputStream();
        out.write(buffer(8).putInt(ExrReader.MAGIC).putInt(VERSION).array());
        for (Map.Entry<String, Value> e : attributes.entrySet()) {
            putText(out, e.getKey());
            putText(out, e.getValue().type);
            out.write(buffer(4).putInt(e.getValue().bytes.length).array());
            out.write(e.getValue().bytes);
        }
        out.write(0);
        return out.toByteArray();
    }
}
