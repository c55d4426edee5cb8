package enlightenment.codec;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.util.Arrays;
import java.util.Random;
import java.util.zip.DataFormatException;
import java.util.zip.Deflater;
import java.util.zip.Inflater;
import org.junit.jupiter.api.Test;

class ZlibEncoderTest {
    private static byte[] encode(byte[] data) throws IOException {
        ByteArrayOutputStream out = new ByteArrayOutputStream();
        ZlibEncoder encoder = new ZlibEncoder(out);
        encoder.write(data, 0, data.length);
        encoder.finish();
        return out.toByteArray();
    }

    /** The JDK's decoder restores the data, checks the checksum, and finds nothing behind the end. */
    private static int assertRoundTrip(byte[] data) throws IOException, DataFormatException {
        byte[] encoded = encode(data);
        Inflater inflater = new Inflater();
        inflater.setInput(encoded);
        byte[] decoded = new byte[data.length + 1];
        int length = 0;
        while (!inflater.finished()) {
            int count = inflater.inflate(decoded, length, decoded.length - length);
            assertTrue(count > 0 || inflater.finished(), "the stream ends early");
            length += count;
        }
        assertEquals(0, inflater.getRemaining());
        inflater.end();
        assertArrayEquals(data, Arrays.copyOf(decoded, length));
        return encoded.length;
    }

    private static byte[] random(int length, int values, long seed) {
        byte[] data = new byte[length];
        Random random = new Random(seed);
        for (int i = 0; i < length; i++) {
            data[i] = (byte) random.nextInt(values);
        }
        return data;
    }

    @Test
    void shortInputsOfAllLengthsComeBack() throws Exception {
        for (int length = 0; length < 600; length++) {
            assertRoundTrip(random(length, 3, length));
            assertRoundTrip(new byte[length]);
        }
    }

    @Test
    void randomBytesComeBackAndAreStored() throws Exception {
        for (int length : new int[] {1000, 65535, 65536, 1 << 20, (1 << 20) + 1, 2_500_000}) {
            int encoded = assertRoundTrip(random(length, 256, 7));
            assertTrue(encoded <= length + 16 + 5 * (length / 16000 + 2), length + " bytes became " + encoded);
        }
    }

    @Test
    void equalBytesTakeNextToNothing() throws Exception {
        byte[] data = new byte[3_000_000];
        Arrays.fill(data, (byte) 0xa5);
        int encoded = assertRoundTrip(data);
        assertTrue(encoded < data.length / 700, "encoded: " + encoded);
    }

    @Test
    void runsPeriodsAndFewValuesComeBackAcrossPieces() throws Exception {
        byte[] runs = new byte[2_200_000];
        Random random = new Random(3);
        for (int i = 0; i < runs.length; ) {
            int end = Math.min(runs.length, i + 1 + random.nextInt(900));
            Arrays.fill(runs, i, end, (byte) random.nextInt(5));
            i = end;
        }
        assertRoundTrip(runs);
        for (int period : new int[] {1, 2, 5, 6, 7, 257, 258, 259, 32767, 32768, 32769, 40000}) {
            byte[] once = random(period, 256, period);
            byte[] data = new byte[1_200_000];
            for (int i = 0; i < data.length; i++) {
                data[i] = once[i % period];
            }
            int encoded = assertRoundTrip(data);
            if (period < 32768) {
                assertTrue(encoded < 2 * period + data.length / 50, "period " + period + ": " + encoded);
            }
        }
        assertRoundTrip(random(1_500_000, 2, 5));
        assertRoundTrip(random(300_000, 17, 6));
    }

    @Test
    void countsThatAskForLongCodeWordsComeBack() throws Exception {
        // Fibonacci counts make Huffman's tree as deep as it gets: one level per symbol.
        ByteArrayOutputStream data = new ByteArrayOutputStream();
        int a = 1;
        int b = 1;
        for (int symbol = 0; symbol < 20; symbol++) {
            byte[] copies = new byte[a];
            Arrays.fill(copies, (byte) symbol);
            data.writeBytes(copies);
            int next = a + b;
            a = b;
            b = next;
        }
        byte[] shuffled = data.toByteArray();
        Random random = new Random(11);
        for (int i = shuffled.length - 1; i > 0; i--) {
            int j = random.nextInt(i + 1);
            byte kept = shuffled[i];
            shuffled[i] = shuffled[j];
            shuffled[j] = kept;
        }
        assertRoundTrip(shuffled);
    }

    @Test
    void theSizeOfTheStepsInWhichDataArrivesDoesNotMatter() throws Exception {
        byte[] data = random(1_300_000, 4, 9);
        ByteArrayOutputStream out = new ByteArrayOutputStream();
        ZlibEncoder encoder = new ZlibEncoder(out);
        for (int from = 0; from < data.length; from += 777) {
            encoder.write(data, from, Math.min(777, data.length - from));
        }
        encoder.finish();
        assertArrayEquals(encode(data), out.toByteArray());
    }

    @Test
    void filteredPicturesBecomeAboutAsSmallAsWithZlib() throws Exception {
        // What filters leave of a picture: small differences of both signs, with flat stretches between.
        Random random = new Random(5);
        byte[] data = new byte[900_000];
        for (int i = 0; i < data.length; i++) {
            data[i] = i / 3000 % 3 == 0 ? 0 : (byte) Math.round(2 * random.nextGaussian());
        }
        Deflater deflater = new Deflater(6);
        deflater.setInput(data);
        deflater.finish();
        int zlib = deflater.deflate(new byte[data.length + 1000]);
        deflater.end();
        int own = assertRoundTrip(data);
        assertTrue(own < 1.05 * zlib, own + " bytes, zlib: " + zlib);
    }
}
