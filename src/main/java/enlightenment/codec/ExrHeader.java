package enlightenment.codec;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;

/** The attributes of an OpenEXR picture that say what its pixels are. */
final class ExrHeader {
    private static final int MOST_BYTES = 1 << 20;
    private static final int MOST_CHANNELS = 64;
    private static final int LONGEST_NAME = 255;
    private static final int RED = 0;
    private static final int ALL = 3;

    /** A channel, with the place of its samples in the bytes of a row. */
    private record Channel(String name, ExrType type, int sampling, long offset) {}

    private final ByteBuffer file;
    private final int end;
    private final List<Channel> channels = new ArrayList<>();

    /** Those that become red, green and blue. */
    private final Channel[] taken = new Channel[3];

    int width;
    int height;

    /** The number of the first row. */
    int top;

    ExrCompression compression;
    long bytesPerRow;

    /** Reads the attributes from where the file stands, up to their end. */
    ExrHeader(ByteBuffer file) throws IOException {
        this.file = file;
        end = (int) Math.min(file.limit(), (long) file.position() + MOST_BYTES);
        boolean hasChannels = false;
        boolean hasWindow = false;
        for (String name = text("an attribute"); !name.isEmpty(); name = text("an attribute")) {
            String type = text("the type of " + ExrReader.quoted(name));
            int size = number();
            if (size < 0 || size > end - file.position()) {
                throw new IOException("attribute " + ExrReader.quoted(name) + " is said to have " + size + " bytes");
            }
            int next = file.position() + size;
            switch (name) {
                case "channels" -> {
                    expect(name, type, "chlist");
                    readChannels(next);
                    hasChannels = true;
                }
                case "compression" -> {
                    expect(name, type, "compression");
                    need(1);
                    compression = ExrCompression.of(file.get());
                }
                case "dataWindow" -> {
                    expect(name, type, "box2i");
                    readWindow();
                    hasWindow = true;
                }
                default -> {}
            }
            file.position(next);
        }
        if (!hasChannels || !hasWindow || compression == null) {
            throw new IOException(
                    "its head lacks " + (!hasChannels ? "channels" : !hasWindow ? "dataWindow" : "compression"));
        }
        place();
    }

    private static void expect(String name, String type, String expected) throws IOException {
        if (!type.equals(expected)) {
            throw new IOException("attribute " + name + " is of type " + ExrReader.quoted(type) + ", not " + expected);
        }
    }

    private void readWindow() throws IOException {
        long left = number();
        top = number();
        long right = number();
        long bottom = number();
        long w = right - left + 1;
        long h = bottom - top + 1;
        Raster.checkSize(w, h);
        width = (int) w;
        height = (int) h;
    }

    private void readChannels(int next) throws IOException {
        while (file.position() < next) {
            String name = text("a channel");
            if (name.isEmpty()) {
                return;
            }
            int type = number();
            number();
            int x = number();
            int y = number();
            if (type < 0 || type >= ExrType.values().length || x < 1 || y < 1) {
                throw new IOException("channel " + ExrReader.quoted(name) + " is of an unknown type");
            }
            if (x != 1 || y != 1) {
                throw new IOException("channel " + ExrReader.quoted(name) + " has not a sample for each pixel");
            }
            channels.add(new Channel(name, ExrType.values()[type], x, 0));
            if (channels.size() > MOST_CHANNELS) {
                throw new IOException("it has more than " + MOST_CHANNELS + " channels");
            }
        }
        throw new IOException("the list of its channels does not end");
    }

    private void place() throws IOException {
        Channel[] rgb = new Channel[ALL];
        Channel grey = null;
        for (Channel c : channels) {
            Channel placed = new Channel(c.name, c.type, c.sampling, bytesPerRow);
            int band = "RGB".indexOf(c.name);
            if (c.name.length() == 1 && band >= RED) {
                rgb[band] = placed;
            } else if (c.name.equals("Y")) {
                grey = placed;
            }
            bytesPerRow += (long) c.type.bytes * width;
        }
        boolean isColoured = rgb[0] != null && rgb[1] != null && rgb[2] != null;
        if (!isColoured && grey == null) {
            throw new IOException("it has neither channels R, G and B nor Y, but "
                    + channels.stream().map(c -> ExrReader.quoted(c.name)).toList());
        }
        for (int band = 0; band < ALL; band++) {
            taken[band] = isColoured ? rgb[band] : grey;
        }
    }

    /** The kinds of all channels, in the order of their numbers in a row. */
    ExrType[] types() {
        return channels.stream().map(Channel::type).toArray(ExrType[]::new);
    }

    private void need(int bytes) throws IOException {
        if (bytes > end - file.position()) {
            throw new IOException("its head does not end within " + end + " bytes");
        }
    }

    private int number() throws IOException {
        need(4);
        return file.getInt();
    }

    private String text(String what) throws IOException {
        int start = file.position();
        int at = start;
        while (at < end && at - start <= LONGEST_NAME && file.get(at) != 0) {
            at++;
        }
        if (at >= end || at - start > LONGEST_NAME) {
            throw new IOException("the name of " + what + " in its head does not end");
        }
        byte[] bytes = new byte[at - start];
        file.get(bytes);
        file.get();
        return new String(bytes, StandardCharsets.ISO_8859_1);
    }

    /** Copies the samples of a row. */
    void store(ByteBuffer data, int from, int row, float[] rgb) {
        for (int band = 0; band < ALL; band++) {
            Channel c = taken[band];
            int at = from + (int) c.offset;
            int to = 3 * row * width + band;
            for (int x = 0; x < width; x++, to += ALL) {
                rgb[to] = switch (c.type) {
                    case FLOAT -> data.getFloat(at + 4 * x);
                    case HALF -> Half.toFloat(data.getShort(at + 2 * x));
                    case UINT -> data.getInt(at + 4 * x) & 0xffffffffL;
                };
            }
        }
    }
}
