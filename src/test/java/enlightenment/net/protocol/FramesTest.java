package enlightenment.net.protocol;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.sun.management.ThreadMXBean;
import enlightenment.file.ContentHash;
import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.InputStream;
import java.lang.management.ManagementFactory;
import java.lang.reflect.RecordComponent;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.HexFormat;
import java.util.List;
import java.util.Optional;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;

class FramesTest {
    private static final ContentHash HASH = new ContentHash(1, -2, Long.MAX_VALUE, Long.MIN_VALUE);

    /** One of each kind, with the extremes of its numbers. */
    private static final List<Message> ALL = List.of(
            new Message.Hello(Message.MAGIC, 1, Integer.MAX_VALUE, "0.1.0", "Lab 3, höher", 65_536, HASH, nonce(1)),
            new Message.Challenge(1, nonce(2)),
            new Message.Proof(nonce(3)),
            new Message.Welcome(nonce(4), 1_000, 5_000, 8),
            new Message.Refuse("wrong token", false),
            new Message.Job(HASH, Limits.TILES, List.of(HASH, HASH)),
            new Message.ContentRequest(HASH, Long.MAX_VALUE),
            new Message.Content(HASH, 5, 8, new byte[] {1, 2, 3}),
            new Message.Ready(HASH, nonce(5), nonce(6)),
            new Message.Grant(Long.MIN_VALUE, HASH, 0, Limits.TILES),
            new Message.Cancel(-1),
            new Message.Skip(Long.MAX_VALUE, 0, 1),
            new Message.Heartbeat(List.of(1L, Long.MIN_VALUE, -7L)),
            new Message.Alive(0, 1),
            new Message.Result(3, HASH, Limits.TILES - 1, new byte[100_000]),
            new Message.Acknowledge(17),
            new Message.Bye(""));

    private static byte[] nonce(int seed) {
        byte[] nonce = new byte[32];
        Arrays.fill(nonce, (byte) seed);
        return nonce;
    }

    private static byte[] frame(Message message) {
        ByteArrayOutputStream out = new ByteArrayOutputStream();
        try {
            Frames.write(out, message, Limits.FRAME);
        } catch (IOException e) {
            throw new AssertionError(e);
        }
        return out.toByteArray();
    }

    private static Optional<Message> read(byte[] bytes, int limit) throws IOException {
        return Frames.read(new ByteArrayInputStream(bytes), limit);
    }

    private static String refusal(byte[] bytes) {
        return assertThrows(ProtocolException.class, () -> read(bytes, Limits.FRAME))
                .getMessage();
    }

    /** A frame around a body in hexadecimal digits. */
    private static byte[] body(String hex) {
        byte[] body = HexFormat.of().parseHex(hex.replace(" ", ""));
        byte[] frame = new byte[4 + body.length + 4];
        frame[3] = (byte) body.length;
        System.arraycopy(body, 0, frame, 4, body.length);
        return sealed(frame);
    }

    /** The frame with the right checksum, however its body was changed. */
    private static byte[] sealed(byte[] frame) {
        byte[] checksum = Frames.checksum(Arrays.copyOfRange(frame, 4, frame.length - 4));
        System.arraycopy(checksum, 0, frame, frame.length - 4, 4);
        return frame;
    }

    private static void assertSame(Message expected, Message found) throws ReflectiveOperationException {
        assertEquals(expected.getClass(), found.getClass());
        for (RecordComponent component : expected.getClass().getRecordComponents()) {
            Object a = component.getAccessor().invoke(expected);
            Object b = component.getAccessor().invoke(found);
            if (a instanceof byte[] bytes) {
                assertArrayEquals(bytes, (byte[]) b);
            } else {
                assertEquals(a, b);
            }
        }
    }

    @Test
    void everyKindOfMessageComesOutAsItWentIn() throws Exception {
        assertEquals(
                List.copyOf(Message.KINDS),
                ALL.stream().map(Message::getClass).map(c -> (Object) c).toList());
        ByteArrayOutputStream all = new ByteArrayOutputStream();
        for (Message message : ALL) {
            all.write(frame(message));
        }
        InputStream in = new ByteArrayInputStream(all.toByteArray());
        for (Message message : ALL) {
            assertSame(message, Frames.read(in, Limits.FRAME).orElseThrow());
        }
        assertTrue(Frames.read(in, Limits.FRAME).isEmpty());
    }

    @Test
    void aMessageIsACborArrayOfItsKindAndItsFields() {
        // RFC 8949: array of 12, 5, 258, 259.
        assertArrayEquals(body("84 0c 05 190102 190103"), frame(new Message.Skip(5, 258, 259)));
        // Array of 2, 13, array of 2: 1, -1.
        assertArrayEquals(body("82 0d 82 01 20"), frame(new Message.Heartbeat(List.of(1L, -1L))));
    }

    @Test
    void aFrameAboveTheLimitIsRefusedByItsHeadAlone() {
        byte[] twoGib = {0x7F, -1, -1, -1};
        assertEquals("a frame of 2147483647 bytes is outside the limits 1..33554432", refusal(twoGib));
        byte[] fourGib = {-1, -1, -1, -1};
        assertEquals("a frame of 4294967295 bytes is outside the limits 1..33554432", refusal(fourGib));
        assertEquals("a frame of 0 bytes is outside the limits 1..33554432", refusal(new byte[4]));
        byte[] hello = frame(ALL.get(14));
        assertThrows(ProtocolException.class, () -> read(hello, Limits.FRAME_BEFORE_AUTHENTICATION));
    }

    /** RFC 8446, 5.1: a record begins with its type, 21 for alerts and 22 for handshakes, and the version 3.x. */
    @Test
    void whatBeginsLikeTlsIsToldSo() {
        byte[] alert = {0x15, 3, 3, 0, 2, 2, 0x0A};
        assertEquals("the other side speaks TLS here", refusal(alert));
        byte[] handshake = {0x16, 3, 1, 0};
        assertEquals("the other side speaks TLS here", refusal(handshake));
        byte[] large = {0x15, 4, 3, 0};
        assertEquals("a frame of 352584448 bytes is outside the limits 1..33554432", refusal(large));
    }

    @Test
    void everyMessageOfTheHandshakeFitsIntoTheSmallLimit() throws Exception {
        String longest = "ü".repeat(Limits.TEXT);
        byte[] refuse = frame(new Message.Refuse(longest, true));
        assertTrue(read(refuse, Limits.FRAME_BEFORE_AUTHENTICATION).isPresent());
        for (Message message : ALL.subList(0, 5)) {
            assertTrue(read(frame(message), Limits.FRAME_BEFORE_AUTHENTICATION).isPresent());
        }
    }

    @Test
    void ourOwnMessagesAboveTheLimitAreNotSent() {
        Message large = new Message.Result(1, HASH, 1, new byte[5_000]);
        assertThrows(
                IllegalArgumentException.class,
                () -> Frames.write(new ByteArrayOutputStream(), large, Limits.FRAME_BEFORE_AUTHENTICATION));
    }

    @Test
    void whatIsNoMessageIsRefusedWithItsReason() {
        assertEquals("message of unknown kind 99", refusal(body("82 1863 00")));
        assertEquals("a number is out of range", refusal(body("82 00 00")));
        assertTrue(refusal(body("a0")).startsWith("an array expected, not START_OBJECT"));
        assertTrue(refusal(body("81 10")).startsWith("Acknowledge: a whole number expected, not END_ARRAY"));
        assertTrue(refusal(body("82 10 6178")).startsWith("Acknowledge: a whole number expected, not VALUE_STRING"));
        assertTrue(refusal(body("83 10 05 05")).startsWith("the end of the message expected"));
        assertEquals("something follows the end of the message", refusal(body("82 10 05 00")));
        assertEquals("Acknowledge: the tile must lie in 0..16777215, not -1", refusal(body("82 10 20")));
        assertEquals("Acknowledge: a number is out of range", refusal(body("82 10 1b7fffffffffffffff")));
        // A lease of 2^64 - 1 and a big number as a tag do not fit a long.
        assertEquals("Cancel: a number is out of range", refusal(body("82 0b 1bffffffffffffffff")));
        assertEquals("Cancel: a number is out of range", refusal(body("82 0b c249010000000000000000")));
        assertEquals("Ready: bytes expected, not an undefined value", refusal(body("82 09 f7")));
        assertTrue(refusal(body("82 09 4101")).contains("a hash has 32 bytes, not 1"));
        assertTrue(refusal(body("82 0d 98ff 01")).contains("not CBOR"));
        String http = "GET / HTTP/1.1\r\n\r\n";
        assertTrue(refusal(http.getBytes(StandardCharsets.US_ASCII)).startsWith("a frame of 1195725856 bytes"));
    }

    @Test
    void deeperNestingThanTheFormatHasIsRefusedAtOnce() {
        assertTrue(refusal(body("81".repeat(100))).startsWith("a whole number expected, not START_ARRAY"));
        assertTrue(refusal(body("82 0d " + "81".repeat(60) + "01")).startsWith("Heartbeat: a whole number expected"));
    }

    @Test
    void aFrameCutAnywhereIsRefused() {
        for (Message message : ALL) {
            byte[] frame = frame(message);
            int step = Math.max(1, frame.length / 200);
            for (int cut = 1; cut < frame.length; cut += step) {
                byte[] part = Arrays.copyOf(frame, cut);
                assertTrue(refusal(part).startsWith("the stream ended after"), "cut at " + cut);
            }
        }
    }

    @Test
    void lengthsInsideABodyAllocateNothingToSpeakOf() {
        ThreadMXBean threads = (ThreadMXBean) ManagementFactory.getThreadMXBean();
        String[] claims = {
            // Bytes, text, array and chunked bytes that claim 2^31-1 or 2^62 elements.
            "82 03 5a7fffffff 00",
            "82 03 5b4000000000000000 00",
            "83 05 7a7fffffff 00",
            "83 05 7b4000000000000000 00",
            "82 0d 9a7fffffff 00",
            "9b4000000000000000 03",
            "82 03 5f 5a7fffffff 00",
            "82 0b c2 5a7fffffff 00"
        };
        for (String claim : claims) {
            refusal(body(claim));
        }
        for (String claim : claims) {
            byte[] frame = body(claim);
            long before = threads.getCurrentThreadAllocatedBytes();
            refusal(frame);
            long allocated = threads.getCurrentThreadAllocatedBytes() - before;
            assertTrue(allocated < 1 << 20, claim + " allocated " + allocated);
        }
    }

    @Test
    void damagedFramesAreMessagesOrProtocolExceptionsAndNothingElse() throws IOException {
        SplittableRandom random = new SplittableRandom(6);
        int refused = 0;
        for (int i = 0; i < 60_000; i++) {
            Message message = ALL.get(random.nextInt(ALL.size()));
            byte[] frame = frame(message instanceof Message.Result ? ALL.get(5) : message);
            int damages = 1 + random.nextInt(4);
            for (int d = 0; d < damages; d++) {
                int at = random.nextInt(4) == 0 ? random.nextInt(frame.length) : 4 + random.nextInt(frame.length - 4);
                frame[at] = (byte) random.nextInt(256);
            }
            try {
                read(sealed(frame), Limits.FRAME);
            } catch (ProtocolException e) {
                refused++;
                assertTrue(e.getMessage() != null && !e.getMessage().isBlank());
            }
        }
        assertTrue(refused > 20_000, "only " + refused + " were refused");
    }

    @Test
    void noiseIsRefused() {
        SplittableRandom random = new SplittableRandom(7);
        for (int i = 0; i < 20_000; i++) {
            byte[] noise = new byte[1 + random.nextInt(200)];
            random.nextBytes(noise);
            byte[] frame = new byte[4 + noise.length + 4];
            frame[3] = (byte) noise.length;
            System.arraycopy(noise, 0, frame, 4, noise.length);
            refusal(sealed(frame));
        }
    }

    @Test
    void aFlippedBitIsFoundWhereverItIs() {
        byte[] frame = frame(new Message.Result(7, HASH, 3, new byte[40]));
        for (int bit = 8 * 4; bit < 8 * frame.length; bit++) {
            byte[] damaged = frame.clone();
            damaged[bit / 8] ^= (byte) (1 << bit % 8);
            assertEquals("a frame was damaged on its way", refusal(damaged));
        }
    }
}
