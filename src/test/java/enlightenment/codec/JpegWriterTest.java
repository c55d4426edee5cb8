package enlightenment.codec;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.util.HashSet;
import java.util.Set;
import org.junit.jupiter.api.Test;

class JpegWriterTest {
    private static final int APP0 = 0xe0;
    private static final int BASELINE = 0xc0;
    private static final int SCAN = 0xda;

    private static byte[] encode(int width, int height, int[] rgb) throws IOException {
        ByteArrayOutputStream out = new ByteArrayOutputStream();
        JpegWriter.write(width, height, rgb, out);
        return out.toByteArray();
    }

    private static int[] noise(int width, int height) {
        int[] rgb = new int[width * height];
        for (int i = 0; i < rgb.length; i++) {
            rgb[i] = i * 0x9e3779b1 >>> 8;
        }
        return rgb;
    }

    @Test
    void coloursThatMeetAtTheEdgeOfABlockKeepTheirHues() throws IOException {
        int[] rgb = new int[32 * 16];
        for (int i = 0; i < rgb.length; i++) {
            rgb[i] = i % 32 < 8 ? 0xe02040 : 0x20c0f0;
        }
        Raster raster = ImageIoReader.read(encode(32, 16, rgb), "jpeg");
        // Each block of 8 x 8 has one colour, which is rounded thrice: 2.2 at most. At half resolution of colours one
        // of 16 x 16 has two.
        for (int i = 0; i < rgb.length; i++) {
            for (int shift = 0; shift < 24; shift += 8) {
                assertEquals(rgb[i] >> shift & 255, raster.packed()[i] >> shift & 255, 3, "pixel " + i);
            }
        }
    }

    @Test
    void theSamePictureGivesTheSameBytesAndHigherBitsAreIgnored() throws IOException {
        int[] rgb = noise(37, 23);
        byte[] first = encode(37, 23, rgb);
        assertArrayEquals(first, encode(37, 23, rgb.clone()));
        int[] opaque = rgb.clone();
        for (int i = 0; i < opaque.length; i++) {
            opaque[i] |= 0xff000000;
        }
        assertArrayEquals(first, encode(37, 23, opaque));
    }

    @Test
    void aFileIsBaselineJfifWithoutCommentsAndProfiles() throws IOException {
        byte[] file = encode(37, 23, noise(37, 23));
        Set<Integer> markers = new HashSet<>();
        int at = 2;
        int marker;
        do {
            assertEquals(0xff, file[at] & 255);
            marker = file[at + 1] & 255;
            markers.add(marker);
            at += 2 + ((file[at + 2] & 255) << 8 | file[at + 3] & 255);
        } while (marker != SCAN);
        assertTrue(markers.contains(APP0) && markers.contains(BASELINE), markers.toString());
        assertFalse(markers.contains(0xfe), markers.toString());
        assertTrue(markers.stream().noneMatch(m -> m > APP0 && m < 0xf0), markers.toString());
    }

    @Test
    void whatIsTooLargeIsRefusedBeforeAnythingIsWritten() {
        ByteArrayOutputStream out = new ByteArrayOutputStream();
        int side = JpegWriter.LARGEST_SIDE + 1;
        assertThrows(IllegalArgumentException.class, () -> JpegWriter.write(side, 1, new int[side], out));
        assertThrows(IllegalArgumentException.class, () -> JpegWriter.write(1, side, new int[side], out));
        assertEquals(0, out.size());
    }

    @Test
    void theLongestRowAndColumnAreWritten() throws IOException {
        int side = JpegWriter.LARGEST_SIDE;
        assertEquals(
                side, ImageIoReader.read(encode(side, 1, new int[side]), "jpeg").width());
        assertEquals(
                side, ImageIoReader.read(encode(1, side, new int[side]), "jpeg").height());
    }

    @Test
    void aStreamThatFailsIsTheFailureOfThePicture() {
        IOException full = new IOException("full");
        OutputStream out = new OutputStream() {
            @Override
            public void write(int b) throws IOException {
                throw full;
            }
        };
        assertSame(full, assertThrows(IOException.class, () -> JpegWriter.write(64, 64, noise(64, 64), out)));
    }
}
