package enlightenment.net.protocol;

import java.io.EOFException;
import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.nio.ByteBuffer;
import java.util.Arrays;
import java.util.Optional;
import java.util.zip.CRC32C;

/**
 * Messages as frames: the length of the body in bytes (4, most significant first), the body, its CRC32C (4). The length is
 * checked against the limit before anything is allocated by it. The checksum finds what TCP's own, which is weak, lets pass
 * where there is no TLS: a flipped bit in a colour would otherwise be believed.
 */
public final class Frames {
    private static final int HEAD = Integer.BYTES;
    private static final int TAIL = Integer.BYTES;
    private static final int TLS_ALERT = 21;
    private static final int TLS_HANDSHAKE = 22;
    private static final int TLS_MAJOR = 3;

    private Frames() {}

    /**
     * Writes one frame; the caller flushes.
     *
     * @param limit largest body in bytes
     * @throws IllegalArgumentException if the message is larger: ours to prevent, so no matter of the protocol
     */
    public static void write(OutputStream out, Message message, int limit) throws IOException {
        byte[] body = MessageCodec.encode(message);
        if (body.length > limit) {
            throw new IllegalArgumentException("a message of " + body.length + " bytes is above the limit of " + limit);
        }
        byte[] head = {
            (byte) (body.length >>> 24), (byte) (body.length >>> 16), (byte) (body.length >>> 8), (byte) body.length
        };
        out.write(head);
        out.write(body);
        out.write(checksum(body));
    }

    /** The end of a frame. */
    static byte[] checksum(byte[] body) {
        CRC32C crc = new CRC32C();
        crc.update(body);
        return ByteBuffer.allocate(TAIL).putInt((int) crc.getValue()).array();
    }

    /**
     * Reads one frame.
     *
     * @param limit largest body in bytes that is read
     * @return empty if the stream ends before the first byte of a frame
     * @throws ProtocolException if the frame is too large, cut short, or no message
     */
    public static Optional<Message> read(InputStream in, int limit) throws IOException {
        byte[] head = in.readNBytes(HEAD);
        if (head.length == 0) {
            return Optional.empty();
        }
        if (head.length < HEAD) {
            throw cutShort(head.length, HEAD);
        }
        int length = length(head, limit);
        byte[] body = in.readNBytes(length);
        byte[] tail = in.readNBytes(TAIL);
        if (tail.length < TAIL) {
            throw cutShort(body.length + tail.length, length + TAIL);
        }
        if (!Arrays.equals(tail, checksum(body))) {
            throw new ProtocolException("a frame was damaged on its way");
        }
        return Optional.of(MessageCodec.decode(body));
    }

    /** The length that the head of a frame claims, checked. */
    static int length(byte[] head, int limit) throws ProtocolException {
        long length = (head[0] & 0xFFL) << 24 | (head[1] & 0xFF) << 16 | (head[2] & 0xFF) << 8 | head[3] & 0xFF;
        if (length > limit && isTls(head)) {
            throw ProtocolException.tls();
        }
        if (length == 0 || length > limit) {
            throw new ProtocolException("a frame of " + length + " bytes is outside the limits 1.." + limit);
        }
        return (int) length;
    }

    /** A record of TLS begins with its type, here an alert or a handshake, and the major version, which is 3 in all of them. */
    private static boolean isTls(byte[] head) {
        return (head[0] == TLS_ALERT || head[0] == TLS_HANDSHAKE) && head[1] == TLS_MAJOR;
    }

    private static ProtocolException cutShort(int there, int expected) {
        return new ProtocolException(
                "the stream ended after " + there + " of " + expected + " bytes of a frame", new EOFException());
    }
}
