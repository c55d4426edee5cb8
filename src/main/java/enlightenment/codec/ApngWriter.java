package enlightenment.codec;

import java.io.ByteArrayOutputStream;
import java.io.DataOutputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.util.List;

/**
 * Writes an animated PNG file (W3C PNG specification, third edition, 11.3.6) of finished PNG files, whose pixels it does not look at: what
 * was compressed stays compressed, under another label. Plays for ever. Programs that know nothing of animation show the first frame.
 */
public final class ApngWriter {
    /** What the file takes over from its first frame. */
    private static final List<String> TAKEN_OVER = List.of("sRGB", "tEXt", "iTXt");

    /** Comments that are true of the whole film. */
    private static final List<String> COMMENTS = List.of("Title\0", "Software\0");

    private static final int SIZE_BYTES = 8;

    private final PngChunkWriter out;
    private final int frames;
    private final int delay;
    private final int perSecond;
    private ByteBuffer header;
    private int added;

    /** Counts chunks of both kinds that have a number: fcTL and fdAT. */
    private int sequence;

    /**
     * @param out receives the file; stays open
     * @param frames how many there will be, at least 1
     * @param delay how long each is shown: numerator of seconds, 0..65535
     * @param perSecond its denominator, 1..65535
     */
    public ApngWriter(OutputStream out, int frames, int delay, int perSecond) {
        this.out = new PngChunkWriter(out);
        this.frames = frames;
        this.delay = delay;
        this.perSecond = perSecond;
    }

    /**
     * Adds a frame; after the last, the file is complete.
     *
     * @param png a whole PNG file of the first one's size and kind
     * @throws IOException if it is not, or is damaged
     */
    public void add(byte[] png) throws IOException {
        if (!RasterDecoder.PNG.matches(png)) {
            throw new IOException("it is not PNG");
        }
        PngChunks chunks = new PngChunks(png);
        boolean first = added == 0;
        boolean controlled = false;
        do {
            ByteBuffer content = chunks.next();
            String type = chunks.type();
            if (type.equals("IHDR")) {
                header(content);
            } else if (type.equals("IDAT")) {
                if (!controlled) {
                    out.chunk("fcTL", control());
                    controlled = true;
                }
                data(content, first);
            } else if (first && TAKEN_OVER.contains(type) && !controlled && isTrueOfAll(type, content)) {
                out.chunk(type, bytes(content));
            }
        } while (!chunks.type().equals("IEND"));
        added++;
        if (added == frames) {
            out.chunk("IEND", new byte[0]);
            out.flush();
        }
    }

    private void header(ByteBuffer content) throws IOException {
        if (header == null) {
            header = content;
            out.signature();
            out.chunk("IHDR", bytes(content));
            out.chunk("acTL", ByteBuffer.allocate(8).putInt(frames).putInt(0).array());
        } else if (!header.equals(content)) {
            throw new IOException("it has another size or depth than the first frame");
        }
    }

    private static boolean isTrueOfAll(String type, ByteBuffer content) {
        String text = new String(bytes(content), StandardCharsets.ISO_8859_1);
        return type.equals("sRGB") || COMMENTS.stream().anyMatch(text::startsWith);
    }

    /** All of the picture, nothing of the frame before it. */
    private byte[] control() throws IOException {
        ByteArrayOutputStream bytes = new ByteArrayOutputStream();
        DataOutputStream data = new DataOutputStream(bytes);
        data.writeInt(sequence++);
        data.write(header.array(), header.arrayOffset() + header.position(), SIZE_BYTES);
        data.writeInt(0); // from the left
        data.writeInt(0); // from above
        data.writeShort(delay);
        data.writeShort(perSecond);
        data.writeByte(0); // it stays until the next
        data.writeByte(0); // and is not blended
        return bytes.toByteArray();
    }

    private void data(ByteBuffer content, boolean first) throws IOException {
        if (first) {
            out.chunk("IDAT", bytes(content));
        } else {
            byte[] numbered = ByteBuffer.allocate(Integer.BYTES + content.remaining())
                    .putInt(sequence++)
                    .put(content)
                    .array();
            out.chunk("fdAT", numbered);
        }
    }

    private static byte[] bytes(ByteBuffer content) {
        byte[] bytes = new byte[content.remaining()];
        content.duplicate().get(bytes);
        return bytes;
    }
}
